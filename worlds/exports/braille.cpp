#include "worlds/exports/braille.h"

#include <liblouis/liblouis.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::exports {
namespace {

struct TableRow {
    std::string_view word;
    BrailleTable table;
    const char* file;        // table file of liblouis for this kind of braille
    const char* signs_file;  // table without contractions, for signs
};
constexpr std::array kTables{
    TableRow{"en-ueb-g1", BrailleTable::EnUebG1, "en-ueb-g1.ctb", "en-ueb-g1.ctb"},
    TableRow{"en-ueb-g2", BrailleTable::EnUebG2, "en-ueb-g2.ctb", "en-ueb-g1.ctb"},
    TableRow{"de-g1", BrailleTable::DeG1, "de-g1.ctb", "de-g0.utb"},
    TableRow{"de-g2", BrailleTable::DeG2, "de-g2.ctb", "de-g0.utb"},
};

const TableRow& row_of(BrailleTable table) {
    return *std::find_if(kTables.begin(), kTables.end(), [&](const TableRow& row) { return row.table == table; });
}

std::vector<widechar> wide_of(std::string_view text) {
    std::vector<widechar> wide;
    for (std::size_t i = 0; i < text.size();) {
        const unsigned char first = static_cast<unsigned char>(text[i]);
        const std::size_t length = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 0;
        std::uint32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
        bool whole = length > 0 && i + length <= text.size();
        for (std::size_t k = 1; whole && k < length; ++k) {
            const unsigned char next = static_cast<unsigned char>(text[i + k]);
            whole = (next & 0xC0U) == 0x80U;
            code = code << 6 | (next & 0x3FU);
        }
        const bool fits = sizeof(widechar) > 2 || code < 0x10000;
        wide.push_back(whole && fits && code != 0 ? static_cast<widechar>(code) : widechar{'?'});
        i += whole ? length : 1;
    }
    return wide;
}

Result<BrailleCells> translated(std::string_view text, const char* file) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    lou_setLogLevel(LOU_LOG_OFF);
    const std::string tables = std::string("unicode.dis,") + file;
    std::vector<widechar> in = wide_of(text);
    // The output may be longer than the text, because a letter can need several cells: signs for numbers, capitals and
    // unknown characters. So the space for the output grows until it is large enough.
    for (std::size_t room = in.size() * 8 + 64;; room *= 4) {
        std::vector<widechar> out(room);
        int taken = static_cast<int>(in.size()), made = static_cast<int>(out.size());
        if (in.empty()) return BrailleCells{};
        if (!lou_translateString(tables.c_str(), in.data(), &taken, out.data(), &made, nullptr, nullptr, 0))
            return fail(phrase("export.no_braille", {{"table", file}}));
        if (taken < static_cast<int>(in.size()) && room < in.size() * 1000 + 10000) continue;
        BrailleCells cells;
        for (int i = 0; i < made; ++i) {
            const auto cell = static_cast<std::uint32_t>(out[static_cast<std::size_t>(i)]);
            cells.push_back(cell >= 0x2800 && cell < 0x2900 ? static_cast<std::uint8_t>(cell & 0x3F) : std::uint8_t{0});
        }
        return cells;
    }
}

}  // namespace

std::optional<BrailleTable> braille_table_named(std::string_view word) {
    for (const TableRow& row : kTables)
        if (row.word == word) return row.table;
    return std::nullopt;
}

BrailleTable braille_table_of(std::string_view language) {
    return language == "de" ? BrailleTable::DeG1 : BrailleTable::EnUebG1;
}

Result<BrailleCells> braille_of(std::string_view text, BrailleTable table) {
    return translated(text, row_of(table).file);
}

Result<BrailleCells> braille_signs(std::string_view text, BrailleTable table) {
    return translated(text, row_of(table).signs_file);
}

std::string brf_of(const BrailleCells& cells) {
    constexpr std::string_view kAscii = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";
    static_assert(kAscii.size() == 64);
    std::string text;
    for (const std::uint8_t cell : cells) text += kAscii[cell & 63U];
    return text;
}

std::vector<BrailleCells> braille_lines(const BrailleCells& cells, std::size_t width, std::size_t indent) {
    contract_pre(width >= indent + 2);
    std::vector<BrailleCells> lines;
    BrailleCells line;
    const auto end_line = [&] {
        while (!line.empty() && line.back() == 0) line.pop_back();
        lines.push_back(line);
        line.assign(indent, 0);
    };
    bool bare = true;  // the line contains only the indent so far
    for (std::size_t i = 0; i < cells.size();) {
        if (cells[i] == 0) {
            if (!bare && line.size() < width) line.push_back(0);
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < cells.size() && cells[end] != 0) ++end;
        if (!bare && line.size() + (end - i) > width) end_line(), bare = true;
        while (end - i > width - line.size()) {  // the word is longer than a line
            const std::size_t fits = width - line.size();
            line.insert(line.end(), cells.begin() + static_cast<std::ptrdiff_t>(i),
                        cells.begin() + static_cast<std::ptrdiff_t>(i + fits));
            i += fits;
            end_line();
        }
        line.insert(line.end(), cells.begin() + static_cast<std::ptrdiff_t>(i),
                    cells.begin() + static_cast<std::ptrdiff_t>(end));
        bare = false;
        i = end;
    }
    if (!bare || lines.empty()) end_line();
    return lines;
}

}  // namespace handrail::exports
