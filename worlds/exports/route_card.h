// Ways in words on a card to take along: as text, or as a BRF file for braille displays and embossers, 40 cells by 25
// lines to a page. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/braille.h"

namespace handrail {

inline constexpr std::size_t kCardCells = 40, kCardLines = 25;

// One way: each sentence begins a line.
using CardWay = std::vector<std::string>;

// UTF-8, lines at most `kCardCells` characters wide, a blank line between ways, LF.
std::string card_text(const std::vector<CardWay>& ways);

// North American braille ASCII, each way on a page of its own, form feed between pages, CR LF. Fails with one sentence
// where braille cannot be had.
Result<std::string> card_brf(const std::vector<CardWay>& ways, BrailleTable table);

}  // namespace handrail
