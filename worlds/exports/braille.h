// Translates text into braille cells with liblouis, and makes files for braille displays and embossers. Only
// braille.cpp includes liblouis. Any thread may call these functions, but only one at a time, because liblouis shares
// its tables. Tables: Unified English Braille and German braille of 2018, uncontracted and contracted, from Debian's
// liblouis-data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::exports {

enum class BrailleTable : std::uint8_t { EnUebG1, EnUebG2, DeG1, DeG2 };

// Returns the table with this name: "en-ueb-g1", "en-ueb-g2", "de-g1" or "de-g2".
std::optional<BrailleTable> braille_table_named(std::string_view word);
// Returns the grade 1 table for a spoken language: the German table for German, otherwise the English one.
BrailleTable braille_table_of(std::string_view language);

// One number for each cell. Each cell has six dots, dot 1 in the lowest bit; 0 is a blank.
using BrailleCells = std::vector<std::uint8_t>;

// Translates the text. Fails with one sentence if liblouis or its tables are missing. Invalid UTF-8 becomes a question
// mark.
Result<BrailleCells> braille_of(std::string_view text, BrailleTable table);
// Translates the text without contractions, so that a reader can find a sign of a plan in the key letter by letter.
Result<BrailleCells> braille_signs(std::string_view text, BrailleTable table);

// Returns North American braille ASCII, the encoding of BRF files: 64 characters, one for each cell.
std::string brf_of(const BrailleCells& cells);

// Divides cells into lines of at most `width` cells, at blanks if possible. Every line after the first is indented by
// `indent` cells. `width` must be at least `indent` + 2.
std::vector<BrailleCells> braille_lines(const BrailleCells& cells, std::size_t width, std::size_t indent);

}  // namespace handrail::exports
