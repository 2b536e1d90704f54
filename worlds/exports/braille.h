// Text in braille by liblouis: cells as bits, and as a file that braille displays and embossers read. liblouis is known
// to braille.cpp alone; one call at a time from any thread (it shares its tables). Tables: Unified English Braille and
// German braille of 2018, uncontracted and contracted, as Debian's liblouis-data has them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

enum class BrailleTable : std::uint8_t { EnUebG1, EnUebG2, DeG1, DeG2 };

// "en-ueb-g1", "en-ueb-g2", "de-g1", "de-g2".
std::optional<BrailleTable> braille_table_named(std::string_view word);
// The one of grade 1 for a language that is spoken; English for others than German.
BrailleTable braille_table_of(std::string_view language);

// Six dots a cell, dot 1 the lowest bit; 0 is a blank.
using BrailleCells = std::vector<std::uint8_t>;

// Fails with one sentence where liblouis or its tables are not there. Damaged UTF-8 becomes a question mark.
Result<BrailleCells> braille_of(std::string_view text, BrailleTable table);
// The same without any contraction: what stands on a plan must be found letter by letter in its key.
Result<BrailleCells> braille_signs(std::string_view text, BrailleTable table);

// North American braille ASCII, the code of BRF files: 64 characters, one for each cell.
std::string brf_of(const BrailleCells& cells);

// Lines of at most `width` cells, broken at blanks where there are such; every line after the first is set in by
// `indent` cells. `width` is at least 2 more than `indent`.
std::vector<BrailleCells> braille_lines(const BrailleCells& cells, std::size_t width, std::size_t indent);

}  // namespace handrail
