// Braille dots on a page. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/braille.h"
#include "worlds/exports/sheet.h"

namespace handrail::exports {

// Lays a line of cells, with the centre of its upper left dot at `first_dot_mm`.
void lay_braille(SheetPage& page, const BrailleCells& cells, const Vec2& first_dot_mm, int part);
// The size of a line of cells, including the dots.
Vec2 braille_size_mm(std::size_t cells);

// A line of a key: a sign as it is on the plan, letter by letter, and its meaning. Without a sign it is plain text.
struct KeyLine {
    std::string sign, text;
};
// Lays the lines out as pages of braille; each begins a new line.
Result<std::vector<SheetPage>> braille_pages(const std::vector<KeyLine>& lines, BrailleTable table, double width_mm,
                                             double height_mm, const std::string& title);

}  // namespace handrail::exports
