#include "worlds/exports/sheet_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "worlds/exports/openings.h"
#include "worlds/exports/wall_ink.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::exports {
namespace {

// Distance by which the part shown extends beyond the floor, so that it includes the walls. It is the same for a whole
// storey.
constexpr double kAroundFloor_m = 0.9, kAroundBase_m = 1.0;
constexpr double kLeastProgress_m = 0.5;  // each part must be smaller than the undivided area by at least this length
// Cost of an uneven cut. A cut costs the metres of floor that it crosses, plus this factor times the metres by which
// its two sides differ in size.
constexpr double kUneven = 0.15;
constexpr double kLeastSide_mm = 10.0;  // two sheets are neighbours if their common strip is at least this long

struct Area {
    Vec2 low{0.0}, high{0.0};
};

// Counts the floor squares in any rectangle in constant time.
class FloorSums {
public:
    explicit FloorSums(const plan::Storey& storey) : storey_(storey), floor_(storey.floor) {
        const bool inside = std::any_of(storey.rooms.begin(), storey.rooms.end(),
                                        [](const plan::StoreyRoom& room) { return !room.outside; });
        sums_.assign(static_cast<std::size_t>(floor_.wide + 1) * static_cast<std::size_t>(floor_.high + 1), 0);
        for (int y = 0; y < floor_.high; ++y)
            for (int x = 0; x < floor_.wide; ++x) {
                const std::uint32_t room = room_at(x, y);
                const bool counts =
                    (room != navigation::kNothing && !(inside && storey.rooms[room].outside)) || is_base(x, y);
                sum(x + 1, y + 1) = sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + (counts ? 1 : 0);
            }
    }

    // Shrinks an area to the floor in it, with a margin around that floor; nothing if there is no floor in it.
    std::optional<Area> fitted(const Area& area) const {
        int x0 = cell(area.low.x, 0), x1 = cell(area.high.x, 0) + 1, y0 = cell(area.low.y, 1),
            y1 = cell(area.high.y, 1) + 1;
        x0 = std::max(x0, 0), y0 = std::max(y0, 0), x1 = std::min(x1, floor_.wide), y1 = std::min(y1, floor_.high);
        if (x0 >= x1 || y0 >= y1 || count(x0, y0, x1, y1) == 0) return std::nullopt;
        while (count(x0, y0, x0 + 1, y1) == 0) ++x0;
        while (count(x1 - 1, y0, x1, y1) == 0) --x1;
        while (count(x0, y0, x1, y0 + 1) == 0) ++y0;
        while (count(x0, y1 - 1, x1, y1) == 0) --y1;
        const Vec2 around(kAroundFloor_m);
        return Area{glm::max(area.low, storey_.min_m + Vec2(x0, y0) * floor_.cell_m - around),
                    glm::min(area.high, storey_.min_m + Vec2(x1, y1) * floor_.cell_m + around)};
    }

    // Returns the length, in metres, over which a line across the area divides the floor of rooms.
    double crossed_m(const Area& area, int axis, double at) const {
        const int other = 1 - axis, here = cell(at, axis);
        double crossed = 0.0;
        for (int i = std::max(0, cell(area.low[other], other)); i <= cell(area.high[other], other); ++i) {
            const std::uint32_t before = axis == 0 ? room_at(here - 1, i) : room_at(i, here - 1);
            const std::uint32_t behind = axis == 0 ? room_at(here, i) : room_at(i, here);
            if (before != navigation::kNothing && before == behind && !storey_.rooms[before].outside)
                crossed += floor_.cell_m;
        }
        return crossed;
    }

    // Returns whether the strip that two sheets share contains floor.
    bool has_floor(const Area& area) const { return fitted(area).has_value(); }

private:
    std::uint32_t room_at(int x, int y) const {
        if (x < 0 || y < 0 || x >= floor_.wide || y >= floor_.high) return navigation::kNothing;
        return floor_
            .room[static_cast<std::size_t>(y) * static_cast<std::size_t>(floor_.wide) + static_cast<std::size_t>(x)];
    }
    bool is_base(int x, int y) const {
        if (!storey_.base) return false;
        const Vec2 off = storey_.min_m + (Vec2(x, y) + Vec2(0.5)) * floor_.cell_m - storey_.base->place_m;
        return std::max(std::abs(off.x), std::abs(off.y)) < kAroundBase_m;
    }
    int cell(double at, int axis) const {
        return static_cast<int>(std::floor((at - storey_.min_m[axis]) / floor_.cell_m + 1e-9));
    }
    std::int32_t& sum(int x, int y) {
        return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(floor_.wide + 1) +
                     static_cast<std::size_t>(x)];
    }
    std::int32_t count(int x0, int y0, int x1, int y1) const {
        const auto of = [&](int x, int y) {
            return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(floor_.wide + 1) +
                         static_cast<std::size_t>(x)];
        };
        return of(x1, y1) - of(x0, y1) - of(x1, y0) + of(x0, y0);
    }

    const plan::Storey& storey_;
    const plan::StoreyFloor& floor_;
    std::vector<std::int32_t> sums_;
};

class Cutter {
public:
    Cutter(const plan::Storey& storey, const PaperSize& paper, double one_to)
        : sums_(storey), one_to_(one_to), shared_m_(kShared_mm * one_to / 1000.0) {
        for (const bool across : {false, true})
            pages_m_.push_back(room_on_page(paper, across, true) * (one_to / 1000.0));
    }

    std::vector<SheetPart> cut(const Area& all) {
        if (const auto area = sums_.fitted(all); !area || sheets_for(*area) > 2 * kMostSheets || !divide(*area))
            return {};
        for (SheetPart& part : parts_) part.count = static_cast<int>(parts_.size());
        return std::move(parts_);
    }

private:
    struct Cut {
        int axis = 0;
        double at = 0.0;
        Area before, behind;
    };

    // Returns the number of sheets that cover a rectangle.
    int sheets_for(const Area& area) const {
        const Vec2 size = area.high - area.low;
        int least = std::numeric_limits<int>::max();
        for (const Vec2& page : pages_m_) {
            const auto along = [&](int axis) {
                return size[axis] <= page[axis] + 1e-6
                           ? 1.0
                           : std::ceil((size[axis] - shared_m_) / (page[axis] - shared_m_) - 1e-9);
            };
            least = static_cast<int>(std::min<double>(least, std::min(along(0) * along(1), 1e6)));
        }
        return least;
    }

    std::optional<Cut> best_cut(const Area& area) const {
        std::optional<Cut> best;
        int fewest = std::numeric_limits<int>::max();
        double least = 0.0;
        constexpr double kStep_m = 0.2;
        for (const int axis : {0, 1})
            for (double at = area.low[axis] + kStep_m; at < area.high[axis]; at += kStep_m) {
                Cut cut{axis, at, area, area};
                cut.before.high[axis] = std::min(area.high[axis], at + 0.5 * shared_m_);
                cut.behind.low[axis] = std::max(area.low[axis], at - 0.5 * shared_m_);
                const auto before = sums_.fitted(cut.before), behind = sums_.fitted(cut.behind);
                if (!before || !behind) continue;
                cut.before = *before, cut.behind = *behind;
                const auto takes_off = [&](const Area& one) {
                    const Vec2 less = (area.high - area.low) - (one.high - one.low);
                    return less.x + less.y >= kLeastProgress_m;
                };
                if (!takes_off(*before) || !takes_off(*behind)) continue;
                const int sheets = sheets_for(*before) + sheets_for(*behind);
                if (sheets > fewest) continue;
                const double uneven = std::abs((behind->high - behind->low)[axis] - (before->high - before->low)[axis]);
                const double cost = sums_.crossed_m(area, axis, at) + kUneven * uneven;
                if (sheets == fewest && cost >= least) continue;
                fewest = sheets, least = cost;
                best = cut;
            }
        return best;
    }

    // Divides an area into sheets. North comes before south, as in reading order.
    bool divide(const Area& area) {
        if (sheets_for(area) == 1) {
            if (static_cast<int>(parts_.size()) == kMostSheets) return false;
            SheetPart part;
            part.min_m = area.low;
            part.max_m = area.high;
            part.one_to = one_to_;
            part.number = static_cast<int>(parts_.size()) + 1;
            parts_.push_back(part);
            return true;
        }
        const std::optional<Cut> cut = best_cut(area);
        if (!cut) return false;
        const std::size_t first = parts_.size();
        if (!divide(cut->axis == 0 ? cut->before : cut->behind)) return false;
        const std::size_t second = parts_.size();
        if (!divide(cut->axis == 0 ? cut->behind : cut->before)) return false;
        for (std::size_t i = first; i < second; ++i)
            for (std::size_t j = second; j < parts_.size(); ++j) {
                if (cut->axis == 0) meet(parts_[i], parts_[j], 0, cut->at);
                else meet(parts_[j], parts_[i], 1, cut->at);
            }
        return true;
    }

    // Stores in two sheets that they are neighbours. `before` is to the west or south of `behind`.
    void meet(SheetPart& before, SheetPart& behind, int axis, double at) const {
        const int other = 1 - axis;
        Area strip;
        strip.low[axis] = std::max(behind.min_m[axis], at - 0.5 * shared_m_);
        strip.high[axis] = std::min(before.max_m[axis], at + 0.5 * shared_m_);
        strip.low[other] = std::max(before.min_m[other], behind.min_m[other]);
        strip.high[other] = std::min(before.max_m[other], behind.max_m[other]);
        const double least = kLeastSide_mm * one_to_ / 1000.0;
        if (strip.high[axis] <= at || strip.low[axis] >= at || strip.high[other] - strip.low[other] < least ||
            !sums_.has_floor(strip))
            return;
        const double along = 0.5 * (strip.low[other] + strip.high[other]);
        before.next[axis == 0 ? 1 : 2].push_back({behind.number, at, along});
        behind.next[axis == 0 ? 0 : 3].push_back({before.number, at, along});
    }

    FloorSums sums_;
    double one_to_, shared_m_;
    std::vector<Vec2> pages_m_;
    std::vector<SheetPart> parts_;
};

// Returns whether a box of `wide` by `high` pixels fits somewhere into the room.
bool has_free_box(const std::vector<std::int32_t>& sums, int wide, int high, int box_x, int box_y) {
    const auto of = [&](int x, int y) {
        return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(wide + 1) + static_cast<std::size_t>(x)];
    };
    for (int y = 0; y + box_y <= high; ++y)
        for (int x = 0; x + box_x <= wide; ++x)
            if (of(x + box_x, y + box_y) - of(x, y + box_y) - of(x + box_x, y) + of(x, y) == box_x * box_y) return true;
    return false;
}

// Draws the walls without changes, except that none is thinner than a pixel.
Ink plain_walls(const plan::Storey& storey, const OnPaper& on_paper) {
    const Vec2 size_mm = (storey.max_m - storey.min_m) * on_paper.mm_per_m;
    Ink ink(size_mm.x, size_mm.y);
    const auto draw = [&](plan::PlanBox box) {
        box.half_m = glm::max(box.half_m, Vec2(0.75 * kInkPixel_mm));
        fill(ink, std::vector<std::vector<Vec2>>{corners_of(box)}, true);
    };
    for (const plan::PlanOutline& wall : storey.walls_m) {
        const std::vector<std::vector<Vec2>> loops = on_paper({wall});
        if (plan::narrowest_m(loops[0]) < 1.5 * kInkPixel_mm) draw(plan::box_around(loops[0]));
        else fill(ink, loops, true);
    }
    for (const auto& [a, b] : storey.sheets_m) {
        const Vec2 way = on_paper(b) - on_paper(a);
        const double length = glm::length(way);
        if (length > 1e-6) draw({0.5 * (on_paper(a) + on_paper(b)), way / length, {0.5 * length, 0.0}});
    }
    return ink;
}

}  // namespace

Vec2 room_on_page(const PaperSize& paper, bool across, bool part) {
    const Vec2 page = across ? Vec2(paper.long_mm, paper.short_mm) : Vec2(paper.short_mm, paper.long_mm);
    return page - Vec2(2.0 * kSheetMargin_mm, 2.0 * kSheetMargin_mm + kSheetHead_mm + kSheetFoot_mm +
                                                  (part ? kPartHead_mm + kPartFoot_mm : 0.0));
}

std::vector<SheetPart> parts_of(const plan::Storey& storey, const PaperSize& paper, double one_to) {
    return Cutter(storey, paper, one_to).cut({storey.min_m, storey.max_m});
}

std::vector<double> scales_needed(const plan::Storey& storey, const std::vector<double>& scales, const Vec2& box_mm) {
    // In this picture, a pixel is 10 cm of the world.
    const OnPaper on_paper{storey.min_m, Vec2(0.0), 1.0};
    const double pixel_m = kInkPixel_mm / on_paper.mm_per_m;
    const plan::RoomGrid grid = rooms_on(plain_walls(storey, on_paper), storey, on_paper);
    std::vector<double> needed(storey.rooms.size(), 0.0);
    for (std::size_t room = 0; room < storey.rooms.size(); ++room) {
        const auto pixel = [&](double at_m, int axis, int most) {
            return std::clamp(static_cast<int>((at_m - storey.min_m[axis]) / pixel_m), 0, most);
        };
        constexpr double kNextToFloor_m = 0.35;
        const Vec2 low = storey.rooms[room].min_m - Vec2(kNextToFloor_m),
                   high = storey.rooms[room].max_m + Vec2(kNextToFloor_m);
        const int x0 = pixel(low.x, 0, grid.wide), x1 = pixel(high.x, 0, grid.wide), y0 = pixel(low.y, 1, grid.high),
                  y1 = pixel(high.y, 1, grid.high);
        const int wide = x1 - x0, deep = y1 - y0;
        std::vector<std::int32_t> sums(static_cast<std::size_t>(wide + 1) * static_cast<std::size_t>(deep + 1), 0);
        const auto sum = [&](int x, int y) -> std::int32_t& {
            return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(wide + 1) + static_cast<std::size_t>(x)];
        };
        for (int y = 0; y < deep; ++y)
            for (int x = 0; x < wide; ++x)
                sum(x + 1, y + 1) =
                    sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + (grid.room[grid.at(x0 + x, y0 + y)] == room ? 1 : 0);
        for (auto scale = scales.rbegin(); scale != scales.rend() && needed[room] == 0.0; ++scale) {
            const Vec2 box = glm::ceil(box_mm * (*scale / 1000.0 / pixel_m) - Vec2(1e-9));
            if (has_free_box(sums, wide, deep, static_cast<int>(box.x), static_cast<int>(box.y))) needed[room] = *scale;
        }
    }
    return needed;
}

}  // namespace handrail::exports
