// Draws a plot with two logarithmic axes as an SVG picture, black on white. Every series has its own mark with its name
// next to it, so that no information depends on colour. A title and a description are for people who listen to the
// plot. Pure functions of plain text.
#pragma once

#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::bench {

struct PlotPoint {
    double x = 0.0, y = 0.0;  // values of 0 or less are drawn on the axis
    std::string label;        // value of the knob at this point; empty: none
};
struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
    bool line = false;  // true: a line joins the points in the given order
};
struct Plot {
    std::string title;
    std::string x_title, y_title;         // axis titles, with units
    double least_x = 0.0, least_y = 0.0;  // a smaller value is drawn at this limit, and the axis says so
    std::vector<PlotSeries> series;
};

std::string svg_of(const Plot& plot);

}  // namespace handrail::bench
