#include "worlds/exports/sheet_title.h"

#include <algorithm>
#include <string_view>

#include "worlds/base/language.h"
#include "worlds/exports/sheet_parts.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail::exports {
namespace {

constexpr std::size_t kTitleLines = 2;
constexpr double kNorth_mm = 20.0;  // width of the space to the right of the title, for the triangle that points north

std::string storey_text(const plan::Storey& storey, bool with_number) {
    return phrase(storey.name.empty() ? "export.storey_numbered"
                  : with_number       ? "export.storey_named_numbered"
                                      : "export.storey_named",
                  {{"upper", storey.upper ? "yes" : "no"},
                   {"name", storey.name},
                   {"storey", storey.number},
                   {"count", storey.count}});
}

std::string title_of(const std::string& world, const std::string& storey, std::optional<int> sheet) {
    if (world.empty())
        return capitalised(sheet ? phrase("export.part_title_short", {{"storey", storey}, {"sheet", *sheet}}) : storey);
    return sheet ? phrase("export.part_title", {{"world", world}, {"storey", storey}, {"sheet", *sheet}})
                 : phrase("export.sheet_title", {{"world", world}, {"storey", storey}});
}

// Removes the last word, or the last letter if there is only one word.
std::string shortened(std::string name) {
    std::size_t end = name.find_last_of(' ');
    if (end == std::string::npos) end = name.size() - 1;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
    name.resize(end);
    while (!name.empty() && std::string_view(" ,;:-").find(name.back()) != std::string_view::npos) name.pop_back();
    return name;
}

std::size_t longest_word(const BrailleCells& cells) {
    std::size_t longest = 0, length = 0;
    for (const auto cell : cells) {
        length = cell == 0 ? 0 : length + 1;
        longest = std::max(longest, length);
    }
    return longest;
}

}  // namespace

std::string sheet_title(const plan::Storey& storey, std::optional<int> sheet) {
    return title_of(storey.world, storey_text(storey, true), sheet);
}

Result<std::vector<BrailleCells>> title_lines(const plan::Storey& storey, std::optional<int> sheet, BrailleTable table,
                                              double page_mm) {
    const auto width = static_cast<std::size_t>((page_mm - 2.0 * kSheetMargin_mm - kNorth_mm) / kBrailleCell_mm);
    const std::string where = storey_text(storey, false);
    std::string name = storey.world;
    for (;; name = shortened(name)) {
        const bool whole = name.empty() || name.size() == storey.world.size();
        const Result<BrailleCells> cells = braille_of(title_of(whole ? name : name + "...", where, sheet), table);
        if (!cells) return tl::unexpected(cells.error());
        std::vector<BrailleCells> lines = braille_lines(*cells, width, 0);
        if (lines.size() > kTitleLines && !name.empty()) continue;
        lines.resize(std::min(lines.size(), kTitleLines));
        // Balances the lines, so that all are about equally long and no single word is left for the last line.
        const std::size_t least = std::max<std::size_t>(2, longest_word(*cells));
        for (std::size_t narrower = width; lines.size() > 1 && --narrower >= least;) {
            std::vector<BrailleCells> even = braille_lines(*cells, narrower, 0);
            if (even.size() > lines.size()) break;
            lines = std::move(even);
        }
        return lines;
    }
}

}  // namespace handrail::exports
