#include <algorithm>

#include "worlds/exports/ink.h"
#include "worlds/exports/sheet.h"

namespace handrail::exports {

GapCheck check_gaps(const SheetPage& page, double least_mm) {
    Ink shapes(page.width_mm, page.height_mm);
    std::vector<int> part(shapes.black.size(), 0);
    GapCheck check;
    check.least_mm = std::max(page.width_mm, page.height_mm);
    const auto place = [&](std::size_t i) {
        return Vec2(static_cast<double>(i % static_cast<std::size_t>(shapes.wide)),
                    static_cast<double>(i / static_cast<std::size_t>(shapes.wide))) *
               kInkPixel_mm;
    };
    const auto take = [&](Ink& ink, int x, int y, int whose) {
        const std::size_t i = ink.at(x, y);
        if (part[i] != 0 && part[i] != whose) {
            check.least_mm = 0.0;
            check.narrow_mm.push_back(place(i));
        }
        part[i] = whose;
        ink.black[i] = 1;
    };
    for (const SheetShape& shape : page.shapes)
        for_pixels_in(shapes, shape.loops_mm, [&](int x, int y) { take(shapes, x, y, shape.part); });
    const Ink slits = narrow_white(shapes, least_mm - kInkPixel_mm);
    Ink all = shapes;
    for (const SheetDot& dot : page.dots) {
        const int reach = static_cast<int>(dot.radius_mm / kInkPixel_mm) + 1;
        const int mx = static_cast<int>(dot.at_mm.x / kInkPixel_mm), my = static_cast<int>(dot.at_mm.y / kInkPixel_mm);
        for (int y = my - reach; y <= my + reach; ++y)
            for (int x = mx - reach; x <= mx + reach; ++x)
                if (all.holds(x, y) && glm::distance(Vec2(x + 0.5, y + 0.5) * kInkPixel_mm, dot.at_mm) <= dot.radius_mm)
                    take(all, x, y, dot.part);
    }
    std::vector<std::uint32_t> whose;
    const std::vector<float> far = distances_px(all, &whose);
    for (int y = 0; y < all.high; ++y)
        for (int x = 0; x < all.wide; ++x) {
            const std::size_t i = all.at(x, y);
            if (slits.black[i]) check.narrow_mm.push_back(place(i));
            for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
                if (!all.holds(x + dx, y + dy)) continue;
                const std::size_t j = all.at(x + dx, y + dy);
                if (part[whose[i]] == part[whose[j]]) continue;
                const double gap_mm = static_cast<double>(far[i] + far[j]) * kInkPixel_mm;
                check.least_mm = std::min(check.least_mm, gap_mm);
                if (gap_mm < least_mm - 0.5 * kInkPixel_mm) check.narrow_mm.push_back(place(i));
            }
        }
    return check;
}

}  // namespace handrail::exports
