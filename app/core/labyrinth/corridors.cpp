#include "app/core/labyrinth/corridors.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "worlds/navigation/walk_space.h"

namespace handrail::core {
namespace {

constexpr double kHoleBelow_m = 0.5;  // largest depth of a hole below the floor around it

struct Cells {
    int x0 = 0, y0 = 0, width = 0, depth = 0;
    std::vector<bool> free;
};

// Copies the world so that the search for walkable floor starts at the ball and on all sides of each hole. A walk
// cannot cross a hole, so one start would not reach all the floor.
Scene begun_on_the_board(const Scene& scene, const Vec3& feet_m, double beside_m) {
    Scene begun = scene;
    begun.starts.clear();
    const auto from = [&](const Vec3& place_m) {
        Start start;
        start.feet_m = place_m;
        begun.starts.push_back(std::move(start));
    };
    from(feet_m);
    for (const LabyrinthPlan::Place& hole : scene.labyrinth.holes) {
        const Vec3 middle = hole.box_m.centre_m(), half = 0.5 * hole.box_m.size_m() + Vec3(beside_m);
        for (const auto& [x, y] :
             {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(-1.0, 0.0), std::pair(0.0, -1.0)})
            from({middle.x + x * half.x, middle.y + y * half.y, hole.box_m.max_m.z});
    }
    return begun;
}

// Returns true if no part of the building is within the radius of the ball on the four sides of `middle_m`.
bool has_room(const Scene& scene, const Vec3& middle_m, double radius_m) {
    return std::none_of(scene.solids.begin(), scene.solids.end(), [&](const Solid& solid) {
        if (solid.role != SolidRole::Solid) return false;
        for (const Vec3& side : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0)})
            if (contains(solid.shape, middle_m + side * radius_m)) return true;
        return false;
    });
}

// Returns the cells that the ball's centre can be above.
Cells rolled_on(const Scene& scene, const navigation::WalkSpace& space, const Vec3& feet_m) {
    const double cell_m = space.cell_m;
    const auto column = [&](double place_m, double origin_m) {
        return static_cast<int>(std::floor((place_m - origin_m) / cell_m));
    };
    const auto middle_m = [&](int x, int y, double z) {
        return Vec3(space.origin_m.x + (x + 0.5) * cell_m, space.origin_m.y + (y + 0.5) * cell_m, z);
    };
    const auto floor_at = [&](int x, int y, double z) -> std::optional<double> {
        const Vec3 at_m = middle_m(x, y, z);
        if (const std::uint32_t span = space.at(at_m); span != navigation::kNothing) return space.place_m(span).z;
        const bool over_hole = std::any_of(
            scene.labyrinth.holes.begin(), scene.labyrinth.holes.end(), [&](const LabyrinthPlan::Place& hole) {
                const double above_m = z - hole.box_m.max_m.z;
                return at_m.x >= hole.box_m.min_m.x && at_m.x <= hole.box_m.max_m.x && at_m.y >= hole.box_m.min_m.y &&
                       at_m.y <= hole.box_m.max_m.y && above_m >= 0.0 && above_m <= kHoleBelow_m;
            });
        if (over_hole && has_room(scene, at_m + Vec3(0.0, 0.0, space.body.radius_m), space.body.radius_m)) return z;
        return std::nullopt;
    };
    std::map<std::pair<int, int>, double> reached;
    std::deque<std::pair<int, int>> next;
    const std::pair<int, int> start{column(feet_m.x, space.origin_m.x), column(feet_m.y, space.origin_m.y)};
    if (const auto floor_m = floor_at(start.first, start.second, feet_m.z)) {
        reached.emplace(start, *floor_m);
        next.push_back(start);
    }
    while (!next.empty()) {
        const auto [x, y] = next.front();
        next.pop_front();
        const double z = reached.at({x, y});
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)}) {
            if (reached.contains({x + dx, y + dy})) continue;
            if (const auto floor_m = floor_at(x + dx, y + dy, z)) {
                reached.emplace(std::pair(x + dx, y + dy), *floor_m);
                next.emplace_back(x + dx, y + dy);
            }
        }
    }
    Cells cells;
    if (reached.empty()) return cells;
    int x1 = std::numeric_limits<int>::min(), y1 = x1;
    cells.x0 = cells.y0 = std::numeric_limits<int>::max();
    for (const auto& [cell, floor_m] : reached) {
        cells.x0 = std::min(cells.x0, cell.first);
        cells.y0 = std::min(cells.y0, cell.second);
        x1 = std::max(x1, cell.first);
        y1 = std::max(y1, cell.second);
    }
    cells.width = x1 - cells.x0 + 1;
    cells.depth = y1 - cells.y0 + 1;
    cells.free.assign(static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(cells.depth), false);
    for (const auto& [cell, floor_m] : reached)
        cells.free[static_cast<std::size_t>((cell.second - cells.y0) * cells.width + cell.first - cells.x0)] = true;
    return cells;
}

// The shared border of two strips: the side of `a` on which `b` is, and the middle of the border in cells from the
// origin. meeting() returns no value if the strips do not touch.
struct SharedBorder {
    CorridorSide towards = CorridorSide::East;
    double x = 0.0, y = 0.0;
};
std::optional<SharedBorder> meeting(const CellStrip& a, const CellStrip& b) {
    const int x0 = std::max(a.x0, b.x0), x1 = std::min(a.x1, b.x1), y0 = std::max(a.y0, b.y0),
              y1 = std::min(a.y1, b.y1);
    const double x = 0.5 * (x0 + x1 + 1), y = 0.5 * (y0 + y1 + 1);
    if (y0 <= y1 && b.x0 == a.x1 + 1) return SharedBorder{CorridorSide::East, x, y};
    if (y0 <= y1 && a.x0 == b.x1 + 1) return SharedBorder{CorridorSide::West, x, y};
    if (x0 <= x1 && b.y0 == a.y1 + 1) return SharedBorder{CorridorSide::North, x, y};
    if (x0 <= x1 && a.y0 == b.y1 + 1) return SharedBorder{CorridorSide::South, x, y};
    return std::nullopt;
}

// Returns the largest rectangle of free cells whose last row is `row`. It uses the standard algorithm for the largest
// rectangle under a histogram, with a stack of rising columns. Among rectangles of equal size, it returns the
// westernmost.
CellStrip largest_in_row(const std::vector<int>& high, int row) {
    CellStrip best{0, 0, -1, -1};
    int best_area = 0;
    std::vector<int> rising;
    const int width = static_cast<int>(high.size());
    for (int x = 0; x <= width; ++x) {
        const int here = x < width ? high[static_cast<std::size_t>(x)] : 0;
        while (!rising.empty() && high[static_cast<std::size_t>(rising.back())] >= here) {
            const int tall = high[static_cast<std::size_t>(rising.back())];
            rising.pop_back();
            const int from = rising.empty() ? 0 : rising.back() + 1;
            if (tall * (x - from) > best_area) {
                best_area = tall * (x - from);
                best = {from, row - tall + 1, x - 1, row};
            }
        }
        rising.push_back(x);
    }
    return best;
}

}  // namespace

std::vector<CellStrip> largest_strips(std::vector<bool> free, int width, int depth) {
    std::vector<CellStrip> strips;
    const auto cell = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
    for (;;) {
        CellStrip best{0, 0, -1, -1};
        int best_area = 0;
        std::vector<int> high(static_cast<std::size_t>(width), 0);
        for (int y = 0; y < depth; ++y) {
            for (int x = 0; x < width; ++x) {
                int& column = high[static_cast<std::size_t>(x)];
                column = free[cell(x, y)] ? column + 1 : 0;
            }
            const CellStrip one = largest_in_row(high, y);
            const int area = one.wide() * one.deep();
            if (area > best_area || (area == best_area && std::pair(one.y0, one.x0) < std::pair(best.y0, best.x0))) {
                best_area = area;
                best = one;
            }
        }
        if (best_area == 0) return strips;
        for (int y = best.y0; y <= best.y1; ++y)
            for (int x = best.x0; x <= best.x1; ++x) free[cell(x, y)] = false;
        strips.push_back(best);
    }
}

Result<std::vector<Corridor>> corridors_of(const Scene& scene, const Vec3& ball_m, double radius_m) {
    const Vec3 feet_m = ball_m - Vec3(0.0, 0.0, radius_m);
    navigation::WalkerMeasures ball;
    ball.radius_m = radius_m;
    ball.height_m = 2.0 * radius_m;
    ball.step_up_m = 0.3 * radius_m;
    ball.cell_m = 0.5 * radius_m;
    const auto space = navigation::make_walk_space(begun_on_the_board(scene, feet_m, 2.0 * radius_m), ball);
    if (!space) return tl::unexpected(space.error());
    const Cells cells = rolled_on(scene, *space, feet_m);
    std::vector<CellStrip> strips = largest_strips(cells.free, cells.width, cells.depth);
    const double cell_m = space->cell_m, least_m = 2.0 * radius_m;
    const double ball_x = (ball_m.x - space->origin_m.x) / cell_m - cells.x0,
                 ball_y = (ball_m.y - space->origin_m.y) / cell_m - cells.y0;
    const auto holds_ball = [&](const CellStrip& strip) {
        return ball_x >= strip.x0 && ball_x < strip.x1 + 1 && ball_y >= strip.y0 && ball_y < strip.y1 + 1;
    };
    std::erase_if(strips, [&](const CellStrip& strip) {
        return std::max(strip.wide(), strip.deep()) * cell_m < least_m && !holds_ball(strip);
    });
    // Sorts the corridors by the number of corridors that the ball passes to reach them. Corridors that are connected
    // only through an omitted strip come last.
    std::vector<std::size_t> order;
    const auto come_to = [&](std::size_t strip) {
        if (std::find(order.begin(), order.end(), strip) == order.end()) order.push_back(strip);
    };
    for (std::size_t i = 0; i < strips.size(); ++i)
        if (holds_ball(strips[i])) come_to(i);
    for (std::size_t k = 0; k < strips.size(); ++k) {
        if (k == order.size())
            for (std::size_t i = 0; order.size() == k && i < strips.size(); ++i) come_to(i);
        const CellStrip& from = strips[order[k]];
        for (std::size_t i = 0; i < strips.size(); ++i)
            if (meeting(from, strips[i])) come_to(i);
    }
    std::vector<Corridor> corridors;
    const auto place_m = [&](double x, double y) {
        return Vec3(space->origin_m.x + (x + cells.x0) * cell_m, space->origin_m.y + (y + cells.y0) * cell_m, ball_m.z);
    };
    for (const std::size_t at : order) {
        const CellStrip& strip = strips[at];
        Corridor corridor;
        corridor.east = strip.wide() >= strip.deep();
        corridor.box_m.include(place_m(strip.x0, strip.y0));
        corridor.box_m.include(place_m(strip.x1 + 1, strip.y1 + 1));
        corridor.length_m = std::max(strip.wide(), strip.deep()) * cell_m;
        corridor.across_m = std::min(strip.wide(), strip.deep()) * cell_m;
        for (std::size_t i = 0; i < order.size(); ++i)
            if (const auto met = meeting(strip, strips[order[i]]))
                corridor.branches.push_back({i, corridor.along_m(place_m(met->x, met->y)), met->towards});
        std::stable_sort(corridor.branches.begin(), corridor.branches.end(),
                         [](const auto& a, const auto& b) { return a.at_m < b.at_m; });
        corridors.push_back(std::move(corridor));
    }
    return corridors;
}

}  // namespace handrail::core
