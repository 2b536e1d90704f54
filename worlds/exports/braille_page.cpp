#include "worlds/exports/braille_page.h"

#include "worlds/exports/swell_sheet.h"

namespace handrail::exports {

namespace {

constexpr double kKeyMargin_mm = 12.0;

}  // namespace

void lay_braille(SheetPage& page, const BrailleCells& cells, const Vec2& first_dot_mm, int part) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (int dot = 0; dot < 6; ++dot)
            if (cells[i] >> dot & 1)
                page.dots.push_back(
                    {first_dot_mm + Vec2(static_cast<double>(i) * kBrailleCell_mm + (dot / 3) * kBraillePitch_mm,
                                         -(dot % 3) * kBraillePitch_mm),
                     0.5 * kBrailleDot_mm, part});
}

Vec2 braille_size_mm(std::size_t cells) {
    const double between = cells == 0 ? 0.0 : static_cast<double>(cells - 1) * kBrailleCell_mm;
    return {between + kBraillePitch_mm + kBrailleDot_mm, 2.0 * kBraillePitch_mm + kBrailleDot_mm};
}

Result<std::vector<SheetPage>> braille_pages(const std::vector<KeyLine>& lines, BrailleTable table, double width_mm,
                                             double height_mm, const std::string& title) {
    const auto width = static_cast<std::size_t>((width_mm - 2.0 * kKeyMargin_mm) / kBrailleCell_mm);
    std::vector<SheetPage> pages;
    double y = -1.0;
    for (const KeyLine& key : lines) {
        Result<BrailleCells> cells = braille_of(key.text, table);
        if (!cells) return tl::unexpected(cells.error());
        if (!key.sign.empty()) {
            Result<BrailleCells> sign = braille_signs(key.sign, table);
            if (!sign) return tl::unexpected(sign.error());
            sign->push_back(0);
            cells->insert(cells->begin(), sign->begin(), sign->end());
        }
        for (const BrailleCells& line : braille_lines(*cells, width, 2)) {
            if (y < kKeyMargin_mm + 2.0 * kBraillePitch_mm) {
                pages.push_back({width_mm, height_mm, title, {}, {}, {}});
                y = height_mm - kKeyMargin_mm - 0.5 * kBrailleDot_mm;
            }
            lay_braille(pages.back(), line, {kKeyMargin_mm + 0.5 * kBrailleDot_mm, y}, 1);
            y -= kBrailleLine_mm;
        }
        if (!pages.empty()) pages.back().text += key.sign + (key.sign.empty() ? "" : "  ") + key.text + "\n";
    }
    return pages;
}

}  // namespace handrail::exports
