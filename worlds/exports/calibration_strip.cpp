#include <array>

#include "worlds/base/language.h"
#include "worlds/exports/braille_page.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail::exports {
namespace {

constexpr double kLeft_mm = 12.0, kColumn_mm = 34.0, kSample_mm = 22.0;

std::vector<Vec2> bar(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

}  // namespace

Result<SheetPage> calibration_strip(const PaperSize& paper, BrailleTable table) {
    SheetPage page{paper.short_mm, paper.long_mm, phrase("export.strip_title"), phrase("export.strip_text"), {}, {}};
    int part = 0;
    double y = page.height_mm - 14.0;
    std::string missing;
    const auto write = [&](const std::string& text, const Vec2& at) {
        const Result<BrailleCells> cells = braille_of(text, table);
        if (!cells) missing = cells.error().message;
        else lay_braille(page, *cells, at, ++part);
    };
    const auto row = [&](const std::string& title, const auto& sizes_mm, const auto& sample) {
        write(title, {kLeft_mm, y});
        y -= 14.0;
        for (std::size_t i = 0; i < sizes_mm.size(); ++i) {
            const double x = kLeft_mm + static_cast<double>(i) * kColumn_mm;
            write(phrase("export.strip_mm", {{"mm", sizes_mm[i]}}), {x, y});
            sample(Vec2(x, y - 12.0), sizes_mm[i]);
        }
        y -= 44.0;
    };
    row(phrase("export.strip_dots"), std::array{1.2, 1.4, 1.5, 1.6, 1.8}, [&](const Vec2& at, double mm) {
        SheetPage cells;
        lay_braille(cells, {0x3F, 0x15, 0x3F}, at, ++part);
        for (SheetDot& dot : cells.dots) dot.radius_mm = 0.5 * mm, page.dots.push_back(dot);
    });
    row(phrase("export.strip_lines"), std::array{0.5, 1.0, 1.5, 2.0}, [&](const Vec2& at, double mm) {
        page.shapes.push_back({{bar(at.x, at.y - 8.0, kSample_mm, mm)}, ++part});
    });
    row(phrase("export.strip_gaps"), std::array{2.0, 3.0, 4.0, 5.0, 6.0}, [&](const Vec2& at, double mm) {
        for (const double x : {0.0, kWallLine_mm + mm})
            page.shapes.push_back({{bar(at.x + x, at.y - 20.0, kWallLine_mm, 20.0)}, ++part});
    });
    if (!missing.empty()) return fail(missing);
    return page;
}

}  // namespace handrail::exports
