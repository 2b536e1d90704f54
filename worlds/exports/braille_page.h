// Braille dots on a page. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/braille.h"
#include "worlds/exports/sheet.h"

namespace handrail {

// Lays a line of cells with its upper left dot's middle at a place.
void lay_braille(SheetPage& page, const BrailleCells& cells, const Vec2& first_dot_mm, int part);
// What so many cells cover, dots and all.
Vec2 braille_size_mm(std::size_t cells);

// A line of a key: a sign as it stands on the plan, letter by letter, and what it means. Without one: a text alone.
struct KeyLine {
    std::string sign, text;
};
// They as pages of braille, each beginning a line.
Result<std::vector<SheetPage>> braille_pages(const std::vector<KeyLine>& lines, BrailleTable table, double width_mm,
                                             double height_mm, const std::string& title);

}  // namespace handrail
