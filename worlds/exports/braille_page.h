// Draws braille dots on a page. Pure functions; any thread may call them.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/braille.h"
#include "worlds/exports/sheet.h"

namespace handrail::exports {

// Adds a line of cells to the page, with the centre of its upper left dot at `first_dot_mm`.
void lay_braille(SheetPage& page, const BrailleCells& cells, const Vec2& first_dot_mm, int part);
// Returns the size of a line of this many cells, including the dots.
Vec2 braille_size_mm(std::size_t cells);

// A line of a key: a sign, spelt as on the plan, and its meaning. Without a sign, the line is plain text.
struct KeyLine {
    std::string sign, text;
};
// Writes the lines in braille on pages. Each KeyLine begins a new line.
Result<std::vector<SheetPage>> braille_pages(const std::vector<KeyLine>& lines, BrailleTable table, double width_mm,
                                             double height_mm, const std::string& title);

}  // namespace handrail::exports
