// Writes spoken directions on a card that people carry with them. The card is a text, or a BRF file for braille
// displays and embossers with 40 cells by 25 lines to a page. Pure functions; any thread may call them.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/braille.h"

namespace handrail::exports {

inline constexpr std::size_t kCardCells = 40, kCardLines = 25;

// The directions of one route. Each sentence begins a new line.
using CardRoute = std::vector<std::string>;

// Returns UTF-8 text with LF line ends. Lines have at most `kCardCells` characters, and a blank line separates routes.
std::string card_text(const std::vector<CardRoute>& ways);

// Returns North American braille ASCII with CR LF line ends. Each route begins a new page, and form feeds separate
// pages. Fails with one sentence if braille is not available.
Result<std::string> card_brf(const std::vector<CardRoute>& ways, BrailleTable table);

}  // namespace handrail::exports
