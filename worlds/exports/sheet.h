// Represents a printed page as plain values: black shapes and dots in millimetres. Functions write the page to a file.
// That file contains only paths and circles, so no font is needed and every length is exact. Pure functions; any thread
// may call them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::exports {

// A shape. A point is black if it is inside an odd number of `loops_mm`.
struct SheetShape {
    // Lines around the shape; x to the right, y up, measured from the lower left corner of the page.
    std::vector<std::vector<Vec2>> loops_mm;
    int part = 0;  // number of the part to which the shape belongs; gaps within one part may be smaller, see check_gaps
};

struct SheetDot {
    Vec2 at_mm{0.0};
    double radius_mm = 0.75;
    int part = 0;
};

struct SheetPage {
    double width_mm = 210.0, height_mm = 297.0;
    std::string title, text;  // title and description in the file, which are not printed
    std::vector<SheetShape> shapes;
    std::vector<SheetDot> dots;
};

// Returns one page as SVG 1.1 with its size in millimetres. The page's title and text become the name and description
// of the SVG. `language` is a language code.
std::string svg_of(const SheetPage& page, const std::string& language);
// Returns all pages as PDF 1.7 that is printed at actual size.
std::string pdf_of(std::span<const SheetPage> pages, const std::string& language);

// The distances between black shapes, as check_gaps measured them.
struct GapCheck {
    // The least distance between two parts; the size of the page if there are fewer than two parts.
    double least_mm = 0.0;
    // Places where the distance is too small, between two parts or in a slit of a shape.
    std::vector<Vec2> narrow_mm;
};
// Measures distances in a picture of the page with 0.1 mm to a pixel, so the result is exact to about that length.
// Different parts must be at least `least_mm` apart everywhere. Within a part, shapes may touch. Gaps and slits inside
// a part are reported if no disc of that size fits through them, unless two lines simply meet at a corner. Dots of one
// part are not compared with each other.
GapCheck check_gaps(const SheetPage& page, double least_mm);

}  // namespace handrail::exports
