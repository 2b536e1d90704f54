// Spoken directions on a card to take along: as text, or as a BRF file for braille displays and embossers, 40 cells by
// 25 lines to a page. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/braille.h"

namespace handrail::exports {

inline constexpr std::size_t kCardCells = 40, kCardLines = 25;

// The directions of one route; each sentence begins a line.
using CardRoute = std::vector<std::string>;

// UTF-8 with LF, lines of at most `kCardCells` characters, and a blank line between routes.
std::string card_text(const std::vector<CardRoute>& ways);

// North American braille ASCII with CR LF, each route on a new page, with form feeds between pages. Fails with one
// sentence if braille is not available.
Result<std::string> card_brf(const std::vector<CardRoute>& ways, BrailleTable table);

}  // namespace handrail::exports
