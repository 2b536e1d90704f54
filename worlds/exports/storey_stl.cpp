#include "worlds/exports/storey_stl.h"

#include <algorithm>
#include <boost/polygon/polygon.hpp>

#include "worlds/base/language.h"
#include "worlds/exports/braille_page.h"
#include "worlds/exports/floor_edges.h"
#include "worlds/exports/names.h"
#include "worlds/exports/openings.h"
#include "worlds/exports/places.h"
#include "worlds/exports/wall_ink.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::exports {
namespace {

using Loops = std::vector<std::vector<Vec2>>;

constexpr double kEdge_mm = 5.0, kPlate_mm = 2.0, kWall_mm = 4.0, kLow_mm = 1.5, kDotHigh_mm = 0.8, kDotWide_mm = 1.6;
constexpr double kFree_mm = 1.0, kLeastWall_mm = 1.2, kDoor_mm = 4.0, kLeastThing_mm = 3.0, kSmallestScale = 2000.0;

std::int32_t um(double mm) { return static_cast<std::int32_t>(std::lround(mm * 1000.0)); }

PlateRing ring_of(const std::vector<Vec2>& loop_mm) {
    PlateRing ring;
    for (const Vec2& p : loop_mm) ring.push_back({um(p.x), um(p.y)});
    return ring;
}

double area_of(const std::vector<Vec2>& loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) twice += plan::cross_of(loop[i], loop[(i + 1) % loop.size()]);
    return 0.5 * twice;
}

// Turns lines around black, and around holes in black, into areas that neither touch nor overlap. Together they are the
// union of all black, in whole micrometres.
std::vector<PlateArea> areas_of(const Loops& loops_mm) {
    namespace bp = boost::polygon;
    using Point = bp::point_data<int>;
    bp::polygon_set_data<int> set;
    for (const auto& loop : loops_mm) {
        std::vector<Point> points;
        for (const PlatePoint& p : ring_of(loop)) points.emplace_back(p.x_um, p.y_um);
        set.insert(bp::polygon_data<int>(points.begin(), points.end()), area_of(loop) < 0.0);
    }
    std::vector<bp::polygon_with_holes_data<int>> found;
    set.get(found);
    const auto ring = [](auto begin, auto end, bool counter_clockwise) {
        PlateRing made;
        double twice = 0.0;
        for (; begin != end; ++begin) made.push_back({begin->x(), begin->y()});
        if (made.size() > 1 && made.front() == made.back()) made.pop_back();
        for (std::size_t i = 0; i < made.size(); ++i) {
            const PlatePoint &a = made[i], &b = made[(i + 1) % made.size()];
            twice += static_cast<double>(a.x_um) * b.y_um - static_cast<double>(b.x_um) * a.y_um;
        }
        if ((twice > 0.0) != counter_clockwise) std::reverse(made.begin(), made.end());
        return made;
    };
    std::vector<PlateArea> areas;
    for (const auto& one : found) {
        PlateArea area{ring(one.begin(), one.end(), true), {}};
        for (auto hole = one.begin_holes(); hole != one.end_holes(); ++hole)
            area.holes.push_back(ring(hole->begin(), hole->end(), false));
        areas.push_back(std::move(area));
    }
    return areas;
}

class PlateMaker {
public:
    PlateMaker(const plan::Storey& storey, BrailleTable table) : storey_(storey), table_(table) {}

    Result<StoreyPlate> make(double longer_side_mm) {
        const Vec2 size_m = storey_.max_m - storey_.min_m;
        const double longest_m = std::max(size_m.x, size_m.y);
        made_.one_to = std::ceil(longest_m * 1000.0 / (longer_side_mm - 2.0 * kEdge_mm));
        if (!(made_.one_to <= kSmallestScale))
            return fail(phrase("export.too_large", {{"x", size_m.x}, {"y", size_m.y}}));
        on_plate_ = {storey_.min_m, Vec2(kEdge_mm), 1000.0 / made_.one_to};
        made_.wide_mm = size_m.x * on_plate_.mm_per_m + 2.0 * kEdge_mm;
        made_.deep_mm = size_m.y * on_plate_.mm_per_m + 2.0 * kEdge_mm;
        raise_walls();
        stairs_ = stair_lines(storey_, on_plate_, rooms_, places_, kLeastWall_mm, kFree_mm + 1.0, kLeastThing_mm);
        for (const plan::PlanBox& line : stairs_.lines) {
            raise(corners_of(line), kLow_mm);
            things_apart_.take(corners_of(line));
        }
        if (const Result<void> signs = raise_signs(); !signs) return tl::unexpected(signs.error());
        raise_base();
        raise_edges();
        raise_things();
        auto triangles = plate_with(um(made_.wide_mm), um(made_.deep_mm), um(kPlate_mm), raised_);
        if (!triangles || !check_solid(*triangles).closed()) return fail(phrase("export.not_closed"));
        made_.triangles = std::move(*triangles);
        report();
        return std::move(made_);
    }

private:
    void raise_walls() {
        const WallLook look{kLeastWall_mm, kFree_mm, kDoor_mm, 2.0 * kLeastWall_mm};
        walls_ = ink_of_walls(storey_, on_plate_, made_.wide_mm, made_.deep_mm, look);
        mend_openings(walls_.ink, storey_, on_plate_, look);
        keep_off_the_rim();
        rooms_ = rooms_on(walls_.ink, storey_, on_plate_);
        fill_cavities();
        part_corners(walls_.ink);
        for (PlateArea& area : areas_of(traced_mm(walls_.ink))) raised_.push_back({std::move(area), um(kWall_mm)});
        places_ = Places(walls_.ink, kFree_mm, Vec2(2.0), Vec2(made_.wide_mm - 2.0, made_.deep_mm - 2.0));
        things_apart_ = places_;
        for (const plan::StoreyThing& thing : storey_.things) things_apart_.take(corners_of(on_plate_(thing.box)));
    }

    // Fills cavities where nobody can walk, such as the space between the two leaves of a cavity wall. Fingers then
    // feel a single wall, and the plate is stronger.
    void fill_cavities() {
        for (std::size_t i = 0; i < rooms_.room.size(); ++i)
            if (rooms_.room[i] == navigation::kNothing) walls_.ink.black[i] = 1;
    }

    // Keeps walls inside the plate's rim. A wall that was thickened where the plan is cut off would otherwise extend
    // over the rim.
    void keep_off_the_rim() {
        const int rim = static_cast<int>(1.0 / kInkPixel_mm);
        Ink& ink = walls_.ink;
        for (int y = 0; y < ink.high; ++y)
            for (int x = 0; x < ink.wide; ++x)
                if (x < rim || y < rim || x >= ink.wide - rim || y >= ink.high - rim) ink.black[ink.at(x, y)] = 0;
    }

    void raise(std::vector<Vec2> loop_mm, double high_mm) {
        if (area_of(loop_mm) < 0.0) std::reverse(loop_mm.begin(), loop_mm.end());
        raised_.push_back({{ring_of(loop_mm), {}}, um(high_mm)});
    }

    void raise_base() {
        if (!storey_.base) return;
        const auto arrow = arrow_of_base(*storey_.base, on_plate_, walls_.ink, places_, {3.0, 2.5});
        if (!arrow) {
            made_.simplified.push_back(phrase("export.base_left_out"));
            return;
        }
        places_.take(arrow->loop_mm);
        things_apart_.take(arrow->loop_mm);
        raise(arrow->loop_mm, kLow_mm);
    }

    void raise_edges() {
        const EdgeInk ink = edge_lines(storey_, on_plate_, rooms_, places_, kLeastWall_mm, kFree_mm + 1.0);
        for (const plan::PlanBox& line : ink.lines) {
            raise(corners_of(line), kLow_mm);
            things_apart_.take(corners_of(line));
        }
    }

    Result<void> raise_signs() {
        made_.signs = room_signs(storey_);
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i) {
            const Result<BrailleCells> cells = braille_signs(made_.signs[i].sign, table_);
            if (!cells) return tl::unexpected(cells.error());
            const Vec2 half = 0.5 * braille_size_mm(cells->size()) + Vec2(0.1);
            const auto place = place_of_sign(storey_, i, on_plate_, rooms_, places_, things_apart_, half, {});
            if (!place) continue;
            made_.signs[i].on_sheet = true;
            const std::vector<Vec2> corners = corners_of(plan::PlanBox{*place, {1.0, 0.0}, half});
            places_.take(corners);
            things_apart_.take(corners);
            SheetPage dots;
            lay_braille(dots, *cells, *place + Vec2(-half.x, half.y) + Vec2(0.5, -0.5) * kDotWide_mm, 1);
            for (const SheetDot& dot : dots.dots) {
                std::vector<Vec2> ring;
                for (int k = 0; k < 12; ++k)
                    ring.push_back(dot.at_mm +
                                   Vec2(std::cos(k * kPi / 6.0), std::sin(k * kPi / 6.0)) * (0.5 * kDotWide_mm));
                raise(std::move(ring), kDotHigh_mm);
            }
        }
        return {};
    }

    void raise_things() {
        std::vector<std::string> left_out, shrunk;
        for (const plan::StoreyThing& thing : storey_.things) {
            const ThingFit fit = fit_of_thing(thing, on_plate_, places_, kLeastThing_mm);
            if (!fit.box) {
                left_out.push_back(thing.name);
                continue;
            }
            if (fit.shrunk) shrunk.push_back(thing.name);
            places_.take(corners_of(*fit.box));
            raise(corners_of(*fit.box), kLow_mm);
            made_.drawn.push_back(thing.name);
        }
        if (!shrunk.empty()) made_.simplified.push_back(phrase("export.shrunk", {{"names", names_list(shrunk)}}));
        if (!left_out.empty()) made_.simplified.push_back(phrase("export.left_out", {{"names", names_list(left_out)}}));
    }

    void report() {
        std::vector<std::string> unsigned_rooms;
        for (std::size_t i = 0; i < made_.signs.size(); ++i)
            if (!made_.signs[i].on_sheet &&
                std::find(stairs_.drawn.begin(), stairs_.drawn.end(), i) == stairs_.drawn.end())
                unsigned_rooms.push_back(made_.signs[i].name);
        if (!unsigned_rooms.empty())
            made_.simplified.push_back(
                phrase("export.no_sign", {{"count", unsigned_rooms.size()}, {"names", names_list(unsigned_rooms)}}));
        if (walls_.wider > 0)
            made_.simplified.push_back(phrase("export.doors_wider", {{"count", walls_.wider}, {"mm", kDoor_mm}}));
        if (!walls_.narrow_gaps.empty())
            made_.simplified.push_back(
                phrase("export.doors_narrow", {{"names", gap_names(storey_, walls_.narrow_gaps)}, {"mm", kDoor_mm}}));
    }

    const plan::Storey& storey_;
    BrailleTable table_;
    StoreyPlate made_;
    OnPaper on_plate_;
    WallInk walls_;
    plan::RoomGrid rooms_;
    StairInk stairs_;
    Places places_, things_apart_;
    std::vector<RaisedArea> raised_;
};

}  // namespace

Result<StoreyPlate> storey_plate(const plan::Storey& storey, BrailleTable table, double longer_side_mm) {
    return PlateMaker(storey, table).make(longer_side_mm);
}

}  // namespace handrail::exports
