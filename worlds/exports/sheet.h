// A printed page as plain values, black shapes and dots in millimetres, and how it is written to a file. It consists
// only of paths and circles, so no font is needed and every length is exact. Pure functions; any thread.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::exports {

// A shape that is black at every point inside an odd number of the loops.
struct SheetShape {
    std::vector<std::vector<Vec2>> loops_mm;  // x to the right, y up, from the lower left corner of the page
    int part = 0;                             // gaps within one part may be smaller, see check_gaps
};

struct SheetDot {
    Vec2 at_mm{0.0};
    double radius_mm = 0.75;
    int part = 0;
};

struct SheetPage {
    double width_mm = 210.0, height_mm = 297.0;
    std::string title, text;  // for readers of the file, not of the paper
    std::vector<SheetShape> shapes;
    std::vector<SheetDot> dots;
};

// One page as SVG 1.1 with its size in millimetres. Title and text become its name and description. `language` is a
// language code.
std::string svg_of(const SheetPage& page, const std::string& language);
// All pages as PDF 1.7 that is printed at actual size.
std::string pdf_of(std::span<const SheetPage> pages, const std::string& language);

// The distances between black and black. See check_gaps.
struct GapCheck {
    // The least distance between two parts; the page's size if there are fewer than two parts.
    double least_mm = 0.0;
    // Places with less than the requested distance: between parts, and in slits of shapes.
    std::vector<Vec2> narrow_mm;
};
// Examines a picture of the page with 0.1 mm to a pixel, so the result is exact to about that. Different parts must be
// at least `least_mm` apart everywhere. Within a part shapes may touch, but gaps and slits through which no disc of
// that size fits are also reported, except where two lines simply meet at a corner. Dots of one part are not compared
// with each other.
GapCheck check_gaps(const SheetPage& page, double least_mm);

}  // namespace handrail::exports
