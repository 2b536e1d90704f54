#include "worlds/exports/wall_ink.h"

#include <algorithm>
#include <array>

#include "worlds/base/language.h"
#include "worlds/exports/names.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::exports {
namespace {

using Loops = std::vector<std::vector<Vec2>>;

class Inker {
public:
    Inker(const plan::Storey& storey, const OnPaper& on_paper, const WallLook& look)
        : storey_(storey), on_paper_(on_paper), look_(look) {}

    WallInk make(double width_mm, double height_mm) {
        made_.ink = Ink(width_mm, height_mm);
        draw();
        for (std::size_t gap = 0; gap < storey_.gaps.size(); ++gap) open_gap(gap);
        made_.joined = join_near(made_.ink, look_.clear_mm);
        leave_out_pieces();
        return std::move(made_);
    }

private:
    std::vector<Vec2> thick_enough(std::vector<Vec2> outline) {
        if (plan::narrowest_m(outline) >= look_.line_mm) return outline;
        plan::PlanBox box = plan::box_around(outline);
        if (2.0 * box.half_m.y >= look_.line_mm) return outline;
        ++made_.thicker;
        box.half_m.y = 0.5 * look_.line_mm;
        box.half_m.x = std::max(box.half_m.x, box.half_m.y);
        return corners_of(box);
    }

    void draw() {
        for (const plan::PlanOutline& wall : storey_.walls_m)
            fill(made_.ink, Loops{thick_enough(std::move(on_paper_(Loops{wall})[0]))}, true);
        for (const auto& sheet : storey_.sheets_m) {
            const Vec2 a = on_paper_(sheet[0]), b = on_paper_(sheet[1]);
            const double length = glm::distance(a, b);
            if (length < 1e-6) continue;
            const plan::PlanBox box{0.5 * (a + b), (b - a) / length, {0.5 * length + 0.01, 0.5 * look_.line_mm}};
            fill(made_.ink, Loops{corners_of(box)}, true);
        }
    }

    bool walled_at(const Vec2& at_mm) const {
        const int x = static_cast<int>(at_mm.x / kInkPixel_mm), y = static_cast<int>(at_mm.y / kInkPixel_mm);
        return made_.ink.holds(x, y) && made_.ink.black[made_.ink.at(x, y)];
    }

    // Returns the thickness of the wall next to a jamb. Returns -1 if a wall continues across the gap at this place,
    // because that wall must not be cut.
    double thickness(const Vec2& at, const Vec2& across) const {
        const double most = 0.7 * on_paper_.mm_per_m;
        double deepest = 0.0;
        for (const double way : {-1.0, 1.0}) {
            double far = 0.0;
            while (far < most && walled_at(at + across * (way * far))) far += kInkPixel_mm;
            if (far >= most) return -1.0;
            deepest = std::max(deepest, far);
        }
        return deepest;
    }

    // Opens a doorway. A door must stay as wide as a finger needs, and no thickened line may extend into it.
    void open_gap(std::size_t place) {
        const plan::StoreyGap& gap = storey_.gaps[place];
        const Vec2 middle = on_paper_(gap.place_m), along = gap.along, across(-along.y, along.x);
        const double width = gap.width_m * on_paper_.mm_per_m;
        double low = -0.5 * width, high = 0.5 * width;
        const double before = thickness(middle + along * (low - 0.3), across);
        const double behind = thickness(middle + along * (high + 0.3), across);
        if (width < look_.door_mm) {
            const bool can_before = before > 0.0, can_behind = behind > 0.0;
            const double more = look_.door_mm - width;
            if (can_before) low -= can_behind ? 0.5 * more : more;
            if (can_behind) high += can_before ? 0.5 * more : more;
            if (can_before || can_behind) ++made_.wider;
            else made_.narrow_gaps.push_back(place);
        }
        // If the gap is wide enough, erases half a line's width less at each jamb, so that the thickened end of the
        // wall remains.
        if (width > look_.door_mm + look_.line_mm) low += 0.5 * look_.line_mm, high -= 0.5 * look_.line_mm;
        const double deep = std::max({before, behind, look_.line_mm, gap.deep_m * on_paper_.mm_per_m}) + 0.3;
        fill(made_.ink, Loops{corners_of({middle + along * (0.5 * (low + high)), along, {0.5 * (high - low), deep}})},
             false);
    }

    void leave_out_pieces() {
        const InkPieces pieces = pieces_of(made_.ink);
        const auto small = [&](std::size_t piece) { return pieces.extent[piece] * kInkPixel_mm < look_.piece_mm; };
        for (std::size_t piece = 1; piece < pieces.pixels.size(); ++piece)
            made_.pieces_left_out += small(piece) ? 1 : 0;
        for (std::size_t i = 0; i < pieces.of.size(); ++i)
            if (pieces.of[i] && small(pieces.of[i])) made_.ink.black[i] = 0;
    }

    const plan::Storey& storey_;
    const OnPaper& on_paper_;
    const WallLook& look_;
    WallInk made_;
};

}  // namespace

std::vector<std::vector<Vec2>> OnPaper::operator()(std::vector<std::vector<Vec2>> loops_m) const {
    for (auto& loop : loops_m)
        for (Vec2& p : loop) p = (*this)(p);
    return loops_m;
}

plan::PlanBox OnPaper::operator()(plan::PlanBox box_m) const {
    box_m.middle_m = (*this)(box_m.middle_m);
    box_m.half_m *= mm_per_m;
    return box_m;
}

std::string gap_names(const plan::Storey& storey, const std::vector<std::size_t>& gaps) {
    std::vector<std::string> names;
    for (const std::size_t gap : gaps)
        names.push_back(storey.gaps[gap].name.empty() ? phrase("export.opening") : storey.gaps[gap].name);
    return names_list(names);
}

std::size_t join_near(Ink& walls, double clear_mm) {
    std::size_t joined = 0;
    for (int round = 0; round < 4; ++round) {
        const Ink narrow = narrow_white(walls, clear_mm);
        const std::size_t places = pieces_of(narrow).pixels.size() - 1;
        if (places == 0) break;
        if (round == 0) joined = places;
        for (std::size_t i = 0; i < narrow.black.size(); ++i)
            if (narrow.black[i]) walls.black[i] = 1;
    }
    return joined;
}

void cut_off(Ink& walls, const Vec2& low_mm, const Vec2& high_mm, double least_mm) {
    // Returns how far inside the rectangle the pixel is; negative if it is outside.
    const auto depth_mm = [&](std::size_t pixel) {
        const auto wide = static_cast<std::size_t>(walls.wide);
        const Vec2 at = (Vec2(pixel % wide, pixel / wide) + Vec2(0.5)) * kInkPixel_mm;
        const Vec2 inside = glm::min(at - low_mm, high_mm - at);
        return std::min(inside.x, inside.y);
    };
    std::vector<std::uint8_t> was_cut(walls.black.size(), 0);
    const auto cut_next_to = [&](std::size_t pixel) {
        const auto wide = static_cast<std::size_t>(walls.wide);
        for (const std::size_t next : {pixel - 1, pixel + 1, pixel - wide, pixel + wide})
            if (next < was_cut.size() && was_cut[next]) return true;
        return false;
    };
    for (std::size_t i = 0; i < walls.black.size(); ++i)
        if (walls.black[i] && depth_mm(i) < 0.0) walls.black[i] = 0, was_cut[i] = 1;
    const InkPieces pieces = pieces_of(walls);
    std::vector<std::uint8_t> touches(pieces.pixels.size(), 0), deep(pieces.pixels.size(), 0);
    for (std::size_t i = 0; i < pieces.of.size(); ++i) {
        if (!pieces.of[i]) continue;
        if (depth_mm(i) >= least_mm) deep[pieces.of[i]] = 1;
        if (cut_next_to(i)) touches[pieces.of[i]] = 1;
    }
    for (std::size_t i = 0; i < pieces.of.size(); ++i)
        if (touches[pieces.of[i]] && !deep[pieces.of[i]]) walls.black[i] = 0;
}

WallInk ink_of_walls(const plan::Storey& storey, const OnPaper& on_paper, double width_mm, double height_mm,
                     const WallLook& look) {
    return Inker(storey, on_paper, look).make(width_mm, height_mm);
}

namespace {

std::uint32_t room_on(const plan::RoomGrid& rooms, const Vec2& at_mm) {
    const int x = static_cast<int>(std::floor(at_mm.x / kInkPixel_mm)),
              y = static_cast<int>(std::floor(at_mm.y / kInkPixel_mm));
    return rooms.holds(x, y) ? rooms.room[rooms.at(x, y)] : navigation::kNothing;
}

// Returns the possible places of the lines across a flight of stairs. Each line is as long as the flight is wide.
std::vector<plan::PlanBox> lines_across(const std::vector<std::vector<Vec2>>& loops_m, const OnPaper& on_paper,
                                        double line_mm, double clear_mm) {
    std::vector<Vec2> all;
    for (const auto& loop : on_paper(loops_m)) all.insert(all.end(), loop.begin(), loop.end());
    std::vector<plan::PlanBox> lines;
    const plan::PlanOutline hull = plan::convex_hull(std::move(all));
    if (hull.empty()) return lines;
    const plan::PlanBox box = plan::box_around(hull);
    // Distance from line to line; slightly larger than needed, or the next line would not fit.
    const double pitch_mm = line_mm + clear_mm + 0.2;
    for (double at = -box.half_m.x; at <= box.half_m.x + 1e-9; at += pitch_mm)
        lines.push_back({box.middle_m + box.along * at,
                         Vec2(-box.along.y, box.along.x),
                         {box.half_m.y + 0.2 * on_paper.mm_per_m, 0.5 * line_mm}});
    return lines;
}

// Calls `draw(line)` for the lines of every flight. `draw` returns whether it drew the line.
template <class Draw>
StairInk lines_of_flights(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms,
                          double line_mm, double clear_mm, Draw draw) {
    StairInk ink;
    const auto draw_flight = [&](const std::vector<std::vector<Vec2>>& loops_m, auto allowed) {
        const std::size_t before = ink.lines.size();
        for (plan::PlanBox line : lines_across(loops_m, on_paper, line_mm, clear_mm))
            if (allowed(line.middle_m) && draw(line)) ink.lines.push_back(line);
        return ink.lines.size() > before;
    };
    for (std::uint32_t i = 0; i < storey.rooms.size(); ++i)
        if (storey.rooms[i].kind == navigation::RoomKind::Stairs &&
            draw_flight(storey.rooms[i].loops_m, [](const Vec2&) { return true; }))
            ink.drawn.push_back(i);
    for (std::uint32_t i = 0; i < storey.stairs_of_others.size(); ++i) {
        const plan::StoreyStairs& flight = storey.stairs_of_others[i];
        const auto in_well = [&](const Vec2& at) {
            return room_on(rooms, at) == flight.room &&
                   plan::floor_at(storey, on_paper.world(at)) == navigation::kNothing;
        };
        if (draw_flight(flight.loops_m, in_well)) ink.of_others.push_back(i);
    }
    return ink;
}

bool black_at(const Ink& ink, const Vec2& mm) {
    const int x = static_cast<int>(std::floor(mm.x / kInkPixel_mm)),
              y = static_cast<int>(std::floor(mm.y / kInkPixel_mm));
    return ink.holds(x, y) && ink.black[ink.at(x, y)];
}

// Adjusts a line for which there is too little space between walls. An end near a wall is extended into that wall; the
// other end keeps the distance `clear_mm` from the nearest black. Returns false if the line is then too short, or if
// black next to it is too near.
bool reaches_walls(plan::PlanBox& line, const Ink& walls, double clear_mm, double least_mm) {
    if (black_at(walls, line.middle_m)) return false;
    constexpr double kIntoWall_mm = 0.3;
    // Length of line next to a wall on which black is ignored, because the wall may slant.
    constexpr double kNextToWall_mm = 0.8;
    const double half = line.half_m.x;
    const Vec2 across(-line.along.y, line.along.x);
    const auto is_clear = [&](const Vec2& way, double far) {
        for (double aside = -line.half_m.y - clear_mm; aside <= line.half_m.y + clear_mm; aside += kInkPixel_mm)
            if (black_at(walls, line.middle_m + way * far + across * aside)) return false;
        return true;
    };
    std::array<double, 2> end{};
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const Vec2 way = side == 0 ? line.along : -line.along;
        double free = 0.0, clear = 0.0;
        while (free <= half + clear_mm && !black_at(walls, line.middle_m + way * free)) free += kInkPixel_mm;
        const bool into_wall = free <= half + clear_mm;
        const double most = into_wall ? free - kNextToWall_mm : half + clear_mm;
        while (clear <= most && is_clear(way, clear)) clear += kInkPixel_mm;
        if (clear > most) end[side] = into_wall ? free + kIntoWall_mm : half;
        else if (into_wall) return false;
        else end[side] = clear - clear_mm - kInkPixel_mm;
    }
    line.middle_m += line.along * (0.5 * (end[0] - end[1]));
    line.half_m.x = 0.5 * (end[0] + end[1]);
    return 2.0 * line.half_m.x >= least_mm;
}

bool contains(const std::vector<std::uint32_t>& places, std::uint32_t place) {
    return std::find(places.begin(), places.end(), place) != places.end();
}

}  // namespace

StairInk stair_lines(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places& places,
                     double line_mm, double clear_mm, double least_mm) {
    return lines_of_flights(storey, on_paper, rooms, line_mm, clear_mm, [&](plan::PlanBox& line) {
        while (line.half_m.x >= 0.5 * least_mm && !places.fits(line)) line.half_m.x -= 0.25;
        if (line.half_m.x < 0.5 * least_mm) return false;
        places.take(corners_of(line));
        return true;
    });
}

StairInk stair_rungs(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places free,
                     Ink& walls, double line_mm, double clear_mm, double least_mm) {
    const StairInk lines = stair_lines(storey, on_paper, rooms, free, line_mm, clear_mm, least_mm);
    plan::Storey narrow = storey;
    for (std::uint32_t i = 0; i < narrow.rooms.size(); ++i)
        if (contains(lines.drawn, i)) narrow.rooms[i].kind = navigation::RoomKind::Room;
    for (std::uint32_t i = 0; i < narrow.stairs_of_others.size(); ++i)
        if (contains(lines.of_others, i)) narrow.stairs_of_others[i].loops_m.clear();
    return lines_of_flights(narrow, on_paper, rooms, line_mm, clear_mm, [&](plan::PlanBox& line) {
        if (!reaches_walls(line, walls, clear_mm, least_mm)) return false;
        fill(walls, Loops{corners_of(line)}, true);
        return true;
    });
}

ThingFit fit_of_thing(const plan::StoreyThing& thing, const OnPaper& on_paper, const Places& places, double least_mm) {
    plan::PlanBox box = on_paper(thing.box);
    const double least = 0.5 * least_mm;
    if (thing.landmark) box.half_m = glm::max(box.half_m, Vec2(least));
    if (box.half_m.y < least - 1e-9) return {};
    ThingFit fit{places.largest_fit(box, least), false};
    fit.shrunk = fit.box && fit.box->half_m.x * fit.box->half_m.y < 0.8 * box.half_m.x * box.half_m.y;
    return fit;
}

std::optional<BaseArrow> arrow_of_base(const plan::StoreyBase& base, const OnPaper& on_paper, const Ink& walls,
                                       const Places& places, const Vec2& half_mm) {
    const Vec3 forward = forward_of_heading(base.heading_rad);
    const Vec2 ahead(forward.x, forward.y), side(-ahead.y, ahead.x), at = on_paper(base.place_m);
    const auto place = places.nearest_fit(
        at, 12.0,
        [&](const Vec2& p) {
            return plan::PlanBox{p, ahead, half_mm};
        },
        [&](const Vec2& p) { return clear_between(walls, at, p); });
    if (!place) return std::nullopt;
    return BaseArrow{{*place + ahead * half_mm.x, *place - ahead * half_mm.x + side * half_mm.y,
                      *place - ahead * half_mm.x - side * half_mm.y},
                     glm::distance(*place, at)};
}

namespace {

// Least distance of a sign from a door. The sign of the ground outside keeps a larger distance, because it has plenty
// of space.
constexpr double kBeforeDoor_mm = 2.0, kBeforeHouse_mm = 12.0;

// Returns whether a box overlaps the area that belongs to a doorway. `clear_mm`: half depth of that area, measured from
// the middle of the wall.
bool in_doorway(const plan::Storey& storey, const OnPaper& on_paper, const plan::PlanBox& box, double clear_mm) {
    return std::any_of(storey.gaps.begin(), storey.gaps.end(), [&](const plan::StoreyGap& gap) {
        const Vec2 off = box.middle_m - on_paper(gap.place_m), across(-gap.along.y, gap.along.x);
        const auto extent = [&](const Vec2& way) {
            return std::abs(way.x) * box.half_m.x + std::abs(way.y) * box.half_m.y;
        };
        return std::abs(glm::dot(off, gap.along)) < 0.5 * gap.width_m * on_paper.mm_per_m + extent(gap.along) &&
               std::abs(glm::dot(off, across)) < clear_mm + extent(across);
    });
}

}  // namespace

std::optional<Vec2> place_of_sign(const plan::Storey& storey, std::size_t room, const OnPaper& on_paper,
                                  const plan::RoomGrid& rooms, const Places& places, const Places& things_apart,
                                  const Vec2& half_mm, const std::vector<plan::PlanBox>& others) {
    const plan::StoreyRoom& mine = storey.rooms[room];
    const double reach = glm::distance(on_paper(mine.min_m), on_paper(mine.max_m)) + 5.0;
    const auto box_at = [&](const Vec2& p) { return plan::PlanBox{p, {1.0, 0.0}, half_mm}; };
    // Greatest distance of a room's sign from the room's floor. The floor begins a walker's radius inside the walls.
    // Farther out, nobody would know to which room the sign belongs, even if no wall is between them.
    constexpr double kNextToFloor_m = 0.35;
    const Vec2 low = on_paper(mine.min_m - Vec2(kNextToFloor_m)), high = on_paper(mine.max_m + Vec2(kNextToFloor_m));
    const auto is_mine = [&](const Vec2& p) {
        return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y && room_on(rooms, p) == room;
    };
    // If a floor without walls is narrower than the sign, the sign may extend over its edges.
    const auto is_mine_or_beyond = [&](const Vec2& p) {
        return is_mine(p) || room_on(rooms, p) == storey.rooms.size();
    };
    bool reaches_over = false;
    const auto in_room = [&](const Vec2& p) {
        if (!is_mine(p)) return false;
        const std::array<Vec2, 4> corners = box_at(p).corners_m();
        return (std::all_of(corners.begin(), corners.end(), is_mine) ||
                (reaches_over && std::all_of(corners.begin(), corners.end(), is_mine_or_beyond))) &&
               !in_doorway(storey, on_paper, box_at(p), mine.outside ? kBeforeHouse_mm : kBeforeDoor_mm) &&
               !is_near_any(box_at(p), others, kBetweenSigns_mm);
    };
    const Vec2 middle = on_paper(mine.middle_m);
    std::optional<Vec2> place = things_apart.nearest_fit(middle, reach, box_at, in_room);
    if (!place) place = places.nearest_fit(middle, reach, box_at, in_room);
    const std::vector<std::uint8_t>& beyond = storey.floor.beyond;
    reaches_over = std::find(beyond.begin(), beyond.end(), 1) != beyond.end();
    if (!place && reaches_over) place = places.nearest_fit(middle, reach, box_at, in_room);
    return place;
}

}  // namespace handrail::exports
