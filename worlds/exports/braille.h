// Translates text into braille with liblouis: cells as bits, and as a file for braille displays and embossers. Only
// braille.cpp includes liblouis. Any thread may call it, but only one at a time, because the tables are shared. Tables:
// Unified English Braille and German braille of 2018, uncontracted and contracted, from Debian's liblouis-data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::exports {

enum class BrailleTable : std::uint8_t { EnUebG1, EnUebG2, DeG1, DeG2 };

// Accepts "en-ueb-g1", "en-ueb-g2", "de-g1" and "de-g2".
std::optional<BrailleTable> braille_table_named(std::string_view word);
// The grade 1 table for a spoken language; English unless it is German.
BrailleTable braille_table_of(std::string_view language);

// Six dots for each cell, dot 1 in the lowest bit; 0 is a blank.
using BrailleCells = std::vector<std::uint8_t>;

// Fails with one sentence if liblouis or its tables are missing. Invalid UTF-8 becomes a question mark.
Result<BrailleCells> braille_of(std::string_view text, BrailleTable table);
// The same without contractions: a sign on a plan must be found in the key letter by letter.
Result<BrailleCells> braille_signs(std::string_view text, BrailleTable table);

// North American braille ASCII, the encoding of BRF files: 64 characters, one for each cell.
std::string brf_of(const BrailleCells& cells);

// Lines of at most `width` cells, broken at blanks if possible. Every line after the first is indented by `indent`
// cells. `width` must be at least `indent` + 2.
std::vector<BrailleCells> braille_lines(const BrailleCells& cells, std::size_t width, std::size_t indent);

}  // namespace handrail::exports
