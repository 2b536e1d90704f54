// What is printed, as plain values: black shapes and dots on a page in millimetres, and how it becomes a file. Only
// paths and circles, so that no font is asked for and every length is exact. Pure functions; any thread.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

// Black where a point lies in an odd number of the loops.
struct SheetShape {
    std::vector<std::vector<Vec2>> loops_mm;  // x to the right, y up, from the lower left corner of the page
    int part = 0;                             // what it belongs to: within one part gaps may be smaller, see check_gaps
};

struct SheetDot {
    Vec2 at_mm{0.0};
    double radius_mm = 0.75;
    int part = 0;
};

struct SheetPage {
    double width_mm = 210.0, height_mm = 297.0;
    std::string title, text;  // for those who read the file and not the paper
    std::vector<SheetShape> shapes;
    std::vector<SheetDot> dots;
};

// One page as SVG 1.1 with its size in millimetres, title and text as its name and description. `language`: its code.
std::string svg_of(const SheetPage& page, const std::string& language);
// All pages as PDF 1.7 that asks to be printed at its own size.
std::string pdf_of(std::span<const SheetPage> pages, const std::string& language);

// Of how far apart black is from black. See check_gaps.
struct GapCheck {
    double least_mm = 0.0;        // between two parts; the page's size where there is one part or none
    std::vector<Vec2> narrow_mm;  // where it is less than was asked for: between parts, and in slits of shapes
};
// Looks at a picture of the page with 0.1 mm to a pixel, so it is exact to about that. Between different parts there
// must be `least_mm` everywhere; within a part shapes may touch, but a gap or slit through which no disc of that size
// goes counts as well, save where two lines simply meet in a corner. Dots of one part are not held against each other.
GapCheck check_gaps(const SheetPage& page, double least_mm);

}  // namespace handrail
