// A plot with two logarithmic axes as an SVG picture: black on white, a shape of its own for every series and its name
// beside it, so that nothing hangs on colour; a title and a description in words for those who hear it. Plain text in,
// plain text out.
#pragma once

#include <string>
#include <vector>

namespace handrail::bench {

struct PlotPoint {
    double x = 0.0, y = 0.0;  // values of 0 or less stand at the axis
    std::string label;        // of a knob; empty: none
};
struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
    bool line = false;  // joined in the order given
};
struct Plot {
    std::string title;
    std::string x_title, y_title;         // with units
    double least_x = 0.0, least_y = 0.0;  // smaller values are drawn here, and the axis says so
    std::vector<PlotSeries> series;
};

std::string svg_of(const Plot& plot);

}  // namespace handrail::bench
