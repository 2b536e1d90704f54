#include "worlds/navigation/blind_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "worlds/base/contract.h"
#include "worlds/scene/models.h"
#include "worlds/scene/scene.h"

namespace handrail::navigation {
namespace {

constexpr double kPartOfCell = 0.8;  // length of one stride on the grid, as a fraction of a cell
// A walker can open a shut leaf from places up to this far before the point where the leaf stops them.
constexpr double kDoorReach_m = 0.5;
// Greatest difference in height between a walker's floor and the foot of a leaf that the walker opens. The doors of
// other storeys, past which a landing of stairs leads, are farther away.
constexpr double kDoorFoot_m = 0.5;
constexpr double kLeast_m = 1e-4;  // least distance between a walker's centre and the border of its cell
constexpr double kRiser_m = 0.03;
// Half thickness of the middle of a shut leaf, as a fraction of a cell. It is thick enough that a step between two
// neighbouring cells cannot skip it.
constexpr double kLeafMiddle = 0.75;

// Calls `visit` for the spans whose middle is nearer than `reach_m` to a leaf that is placed at `at`. If `reach_m` is
// the walker's radius, these are the spans where the walker overlaps the leaf.
template <class Visit>
void visit_leaf(const WalkSpace& space, const Aabb& own_m, const Placement& at, double reach_m, Visit visit) {
    const PlacedFrame frame(at);
    const Aabb stands = placed_bounds(own_m, at);
    const auto cell = [&](double world, double origin, std::uint32_t count) {
        return static_cast<std::uint32_t>(
            std::clamp(std::floor((world - origin) / space.cell_m), 0.0, static_cast<double>(count - 1)));
    };
    const std::uint32_t x0 = cell(stands.min_m.x - reach_m, space.origin_m.x, space.width),
                        x1 = cell(stands.max_m.x + reach_m, space.origin_m.x, space.width),
                        y0 = cell(stands.min_m.y - reach_m, space.origin_m.y, space.depth),
                        y1 = cell(stands.max_m.y + reach_m, space.origin_m.y, space.depth);
    for (std::uint32_t y = y0; y <= y1; ++y)
        for (std::uint32_t s = space.first[static_cast<std::size_t>(y) * space.width + x0];
             s < space.first[static_cast<std::size_t>(y) * space.width + x1 + 1]; ++s) {
            const Vec3 place = space.place_m(s);
            if (place.z >= stands.max_m.z || place.z + space.body.height_m <= stands.min_m.z) continue;
            const Vec3 own = frame.to_own(place);
            const double own_reach_m = reach_m / at.scale;
            if (own.x > own_m.min_m.x - own_reach_m && own.x < own_m.max_m.x + own_reach_m &&
                own.y > own_m.min_m.y - own_reach_m && own.y < own_m.max_m.y + own_reach_m)
                visit(s);
        }
}

}  // namespace

std::vector<DirectionsDoor> word_doors(const Scene& scene, std::span<const int> thing_of_mover) {
    std::vector<DirectionsDoor> doors;
    for (std::uint32_t i = 0; i < scene.movers.size(); ++i) {
        const Mover& mover = scene.movers[i];
        const Feature* feature = scene.find(mover.feature);
        if (!feature || feature->kind != FeatureKind::Door || !mover.moves() || mover.endless()) continue;
        if (i >= thing_of_mover.size() || thing_of_mover[i] < 0) continue;
        const Aabb& own = scene.placed[static_cast<std::size_t>(thing_of_mover[i])].model->bounds_m;
        // A mover wider than it is high is a bridge, not a door.
        if (own.empty() || own.size_m().z < std::min(own.size_m().x, own.size_m().y)) continue;
        auto door =
            std::find_if(doors.begin(), doors.end(), [&](const DirectionsDoor& d) { return d.group == mover.group; });
        if (door == doors.end()) {
            doors.push_back({i, mover.feature, mover.group, {}, false});
            door = doors.end() - 1;
        }
        door->leaves.push_back({own, mover.at(0.0), mover.at(1.0)});
        // The door of a lift opens only while the lift is behind it, so it is not a door that opens at any time.
        const bool opens = mover.by_hand || !mover.approach_m.empty();
        door->opens = door->opens || (opens && mover.lift == kNoMover);
    }
    return doors;
}

BlindGround::BlindGround(const WalkSpace& space, std::vector<DirectionsDoor> doors)
    : space_(space), doors_(std::move(doors)) {
    contract_pre(doors_.size() < 0xfffe);
    const std::size_t count = space_.spans.size();
    free_m_.assign(count, 0.0F);
    for (std::size_t s = 0; s < count; ++s)
        if (!space_.spans[s].stairs)
            free_m_[s] = std::max(0.0F, space_.spans[s].clearance_m - static_cast<float>(1.5 * space_.cell_m));
    if (doors_.empty()) return;
    shut_leaf_.assign(count, 0);
    open_leaf_.assign(count, 0);
    shut_middle_.assign(count, false);
    near_door_.assign(count, kNothing);
    const double radius_m = space_.body.radius_m;
    std::vector<std::uint32_t> wave;
    std::vector<double> foot_m(doors_.size(), std::numeric_limits<double>::infinity());
    const auto at_foot = [&](std::uint32_t s, std::uint32_t d) {
        return std::abs(space_.place_m(s).z - foot_m[d]) <= kDoorFoot_m;
    };
    for (std::uint32_t d = 0; d < doors_.size(); ++d)
        for (const DirectionsDoor::Leaf& leaf : doors_[d].leaves)
            foot_m[d] = std::min(foot_m[d], placed_bounds(leaf.own_m, leaf.shut).min_m.z);
    for (std::uint32_t d = 0; d < doors_.size(); ++d)
        for (const DirectionsDoor::Leaf& leaf : doors_[d].leaves) {
            visit_leaf(space_, leaf.own_m, leaf.shut, radius_m, [&](std::uint32_t s) {
                shut_leaf_[s] = static_cast<std::uint16_t>(d + 1);
                if (!at_foot(s, d)) return;
                if (near_door_[s] == kNothing) wave.push_back(s);
                near_door_[s] = d;
            });
            visit_leaf(space_, leaf.own_m, leaf.shut, kLeafMiddle * space_.cell_m,
                       [&](std::uint32_t s) { shut_middle_[s] = true; });
            visit_leaf(space_, leaf.own_m, leaf.open, radius_m,
                       [&](std::uint32_t s) { open_leaf_[s] = static_cast<std::uint16_t>(d + 1); });
        }
    find_free();
    // A door can also be opened from any span within kDoorReach_m of its leaf.
    const int rings = static_cast<int>(std::lround(kDoorReach_m / space_.cell_m));
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<std::uint32_t> next;
        for (const std::uint32_t s : wave)
            for (const std::uint32_t n : space_.spans[s].next)
                if (n != kNothing && near_door_[n] == kNothing && at_foot(n, near_door_[s])) {
                    near_door_[n] = near_door_[s];
                    next.push_back(n);
                }
        wave = std::move(next);
    }
}

// Lowers free_m_ to at most the distance from the places that leaves can occupy. That distance is estimated from below:
// the ring number of a cell is at most kDiagonal times its distance in cells.
void BlindGround::find_free() {
    constexpr double kFarthest_m = 2.0, kDiagonal = 1.42;
    std::vector<std::uint32_t> ring;
    std::vector<bool> seen(space_.spans.size(), false);
    for (std::uint32_t s = 0; s < space_.spans.size(); ++s)
        if (shut_leaf_[s] || open_leaf_[s]) {
            ring.push_back(s);
            seen[s] = true;
            free_m_[s] = 0.0F;
        }
    for (int r = 1; r * space_.cell_m < kFarthest_m && !ring.empty(); ++r) {
        const auto most = static_cast<float>(std::max(0.0, (r / kDiagonal - 1.5) * space_.cell_m));
        std::vector<std::uint32_t> next;
        for (const std::uint32_t s : ring)
            for (const std::uint32_t n : space_.spans[s].next)
                if (n != kNothing && !seen[n]) {
                    seen[n] = true;
                    free_m_[n] = std::min(free_m_[n], most);
                    next.push_back(n);
                }
        ring = std::move(next);
    }
}

// A walker, together with the borders of the walker's current cell. Most strides only read these fields, and few
// strides change them.
struct BlindGround::OnCell : BlindWalker {
    double low_m[2], high_m[2];
    std::uint32_t at_cell[2];

    OnCell(const WalkSpace& space, const BlindWalker& body) : BlindWalker(body) {
        const std::uint32_t cell = space.spans[span].cell;
        at_cell[0] = cell % space.width;
        at_cell[1] = cell / space.width;
        border(space, 0);
        border(space, 1);
    }
    void border(const WalkSpace& space, int axis) {
        low_m[axis] = (axis == 0 ? space.origin_m.x : space.origin_m.y) + at_cell[axis] * space.cell_m;
        high_m[axis] = low_m[axis] + space.cell_m;
    }
};

// Moves the walker `by_m` at once onto level floor without stairs. Returns false, without a move, if there is no such
// floor.
bool BlindGround::leap(OnCell& body, const Vec2& ahead, double by_m) const {
    const Vec2 to = body.at_m + ahead * by_m;
    const auto x = static_cast<std::int64_t>(std::floor((to.x - space_.origin_m.x) / space_.cell_m)),
               y = static_cast<std::int64_t>(std::floor((to.y - space_.origin_m.y) / space_.cell_m));
    if (x < 0 || y < 0 || x >= space_.width || y >= space_.depth) return false;
    const std::size_t cell = static_cast<std::size_t>(y) * space_.width + static_cast<std::size_t>(x);
    for (std::uint32_t s = space_.first[cell]; s < space_.first[cell + 1]; ++s)
        if (std::abs(space_.spans[s].floor_m - space_.spans[body.span].floor_m) < 0.01F && !space_.spans[s].stairs) {
            body = OnCell(space_, {to, s});
            return true;
        }
    return false;
}

BlindWalker BlindGround::body_at(const Vec3& feet_m) const {
    const std::uint32_t span = space_.nearest(feet_m, 1.0, 0.6, 3.0);
    if (span == kNothing) return {};
    const Vec3 place = space_.place_m(span);
    const double half_m = 0.5 * space_.cell_m - kLeast_m;
    return {{std::clamp(feet_m.x, place.x - half_m, place.x + half_m),
             std::clamp(feet_m.y, place.y - half_m, place.y + half_m)},
            span};
}

// Returns whether a leaf stops the walker who steps from span `from` to span `to`. A walker who already overlaps the
// leaf may move on, except into the middle of a shut leaf.
bool BlindGround::held(std::uint32_t from, std::uint32_t to, const DoorsOpen& open, bool through_doors) const {
    if (shut_leaf_.empty()) return false;
    const auto in = [&](std::uint32_t span, std::uint32_t& door) {
        if (const std::uint16_t d = shut_leaf_[span]; d && open[d - 1U] == DoorState::Shut && !through_doors) {
            door = d;
            return true;
        }
        if (const std::uint16_t d = open_leaf_[span]; d && open[d - 1U] == DoorState::Open) {
            door = d;
            return true;
        }
        return false;
    };
    std::uint32_t there = 0, here = 0;
    if (!in(to, there)) return false;
    if (!(in(from, here) && here == there)) return true;
    return shut_middle_[to] && !shut_middle_[from] && open[there - 1U] == DoorState::Shut && !through_doors;
}

// One stride, shorter than a cell. `next` contains, for each axis, the index in WalkSpan::next of the neighbour that
// the stride may enter.
struct BlindGround::Stride {
    Vec2 by_m;
    std::uint8_t next[2];

    explicit Stride(const Vec2& by) : by_m(by) {
        next[0] = by.x > 0.0 ? 0 : 2;
        next[1] = by.y > 0.0 ? 1 : 3;
    }
};

// Moves along each axis separately, so that the walker slides along walls. Returns false if neither axis allowed any
// movement.
bool BlindGround::advance(OnCell& body, const Stride& by, const DoorsOpen& open, bool through_doors, bool& edge) const {
    bool moved = false;
    for (int axis = 0; axis < 2; ++axis) {
        if (by.by_m[axis] == 0.0) continue;
        const double to = body.at_m[axis] + by.by_m[axis];
        if (!(to > body.low_m[axis] && to < body.high_m[axis])) {
            const std::uint32_t n = space_.spans[body.span].next[by.next[axis]];
            if (n == kNothing || held(body.span, n, open, through_doors)) {
                edge = edge || (n == kNothing && space_.spans[body.span].near_edge);
                continue;
            }
            body.span = n;
            body.at_cell[axis] += by.next[axis] < 2 ? 1U : ~0U;
            body.border(space_, axis);
        }
        body.at_m[axis] = to;
        moved = true;
    }
    return moved;
}

Paced BlindGround::walk(BlindWalker& walks, double heading_rad, double most_m, PaceEnd end, const DoorsOpen& open,
                        const std::function<bool(const BlindWalker&)>& each_step, double step_m) const {
    Paced paced;
    if (walks.span == kNothing) {
        paced.stopped = true;
        return paced;
    }
    OnCell body(space_, walks);
    const double stride_m = kPartOfCell * space_.cell_m;
    const Vec2 ahead{std::sin(heading_rad), std::cos(heading_rad)};
    const Stride whole(ahead * stride_m);
    const double start_z = space_.place_m(body.span).z;
    const int window = std::max(2, static_cast<int>(std::lround(kStoppedWindow_m / stride_m)));
    double window_from_m = 0.0, level_z = start_z, level_from_m = 0.0, next_step_m = step_m;
    int strides = 0, lined_up = 0;
    bool edge = false;
    // Returns whether the walk has ended: the walker has completed a flight of stairs, or `each_step` returned false.
    const auto over = [&] {
        paced.climbed = end == PaceEnd::Stairs && std::abs(level_z - start_z) > kFlightRise_m &&
                        paced.walked_m - level_from_m > kFlightOver_m;
        if (paced.climbed) return true;
        if (!each_step || paced.walked_m < next_step_m - 1e-9) return false;
        next_step_m += step_m;
        return !each_step(body);
    };
    while (paced.walked_m < most_m - 1e-9) {
        if (const auto free_m = static_cast<double>(free_m_[body.span]); free_m > 2.0 * stride_m) {
            double by_m = std::min(free_m, most_m - paced.walked_m);
            if (each_step) by_m = std::min(by_m, next_step_m - paced.walked_m);
            if (by_m > stride_m && leap(body, ahead, by_m)) {
                paced.walked_m += by_m;
                strides = 0;
                window_from_m = paced.walked_m;
                if (over()) break;
                continue;
            }
        }
        const double by_m = std::min(stride_m, most_m - paced.walked_m);
        const Vec2 was = body.at_m;
        advance(body, by_m == stride_m ? whole : Stride(ahead * by_m), open, false, edge);
        paced.walked_m += glm::length(body.at_m - was);
        if (edge) {
            paced.at_edge = paced.stopped = true;
            break;
        }
        const double z = space_.place_m(body.span).z;
        if (std::abs(z - level_z) > kRiser_m) {
            level_z = z;
            level_from_m = paced.walked_m;
        }
        if (over()) break;
        if (++strides < window) continue;
        const bool slow = paced.walked_m - window_from_m < kStoppedBelow * stride_m * strides;
        strides = 0;
        window_from_m = paced.walked_m;
        if (!slow) continue;
        // Slides the walker into the doorway whose frame stopped them.
        const std::optional<double> aside_m = lined_up < 2 ? line_up_m(body, heading_rad, open) : std::nullopt;
        if (!aside_m) {
            paced.stopped = true;
            break;
        }
        ++lined_up;
        const Stride aside(Vec2{ahead.y, -ahead.x} * std::copysign(stride_m, *aside_m));
        for (double left_m = std::abs(*aside_m); left_m > 0.0; left_m -= stride_m)
            advance(body, aside, open, false, edge);
    }
    walks = body;
    paced.rise_m = space_.place_m(body.span).z - start_z;
    return paced;
}

std::optional<double> BlindGround::line_up_m(const BlindWalker& body, double heading_rad, const DoorsOpen& open) const {
    const double stride_m = kPartOfCell * space_.cell_m;
    const Vec2 ahead{std::sin(heading_rad), std::cos(heading_rad)}, right{ahead.y, -ahead.x};
    const auto goes_m = [&](OnCell& from, const Vec2& way, double most_m, bool through_doors, double least_m = 0.0) {
        bool edge = false;
        const Vec2 start = from.at_m;
        const Stride by(way * stride_m);
        for (double left_m = most_m; left_m > 0.0 && !edge; left_m -= stride_m) {
            if (!advance(from, by, open, through_doors, edge)) break;
            // Gives up early if all remaining strides together would not reach `least_m`, which is the usual case.
            if (glm::dot(from.at_m - start, way) + left_m + kLeast_m < least_m) break;
        }
        return edge ? 0.0 : glm::dot(from.at_m - start, way);
    };
    // Returns whether the walker can go on ahead from the position `probe` through an opening that is narrow enough to
    // be a doorway.
    const auto opens_there = [&](OnCell probe) {
        const double least_m = kLineUpDeep_m - 2.0 * stride_m;
        if (goes_m(probe, ahead, kLineUpDeep_m, true, least_m) < least_m) return false;
        OnCell left = probe;
        const double left_m = goes_m(left, -right, kDoorway_m, true);
        return left_m < kDoorway_m && left_m + goes_m(probe, right, kDoorway_m, true) < kDoorway_m;
    };
    if (opens_there(OnCell(space_, body))) return 0.0;
    OnCell sides[2] = {OnCell(space_, body), OnCell(space_, body)};
    bool goes[2] = {true, true};
    for (double aside_m = stride_m; aside_m <= kLineUp_m; aside_m += stride_m)
        for (int side = 0; side < 2; ++side) {
            if (!goes[side]) continue;
            const double sign = side == 0 ? 1.0 : -1.0;
            goes[side] = goes_m(sides[side], right * sign, stride_m, false) > 0.25 * stride_m;
            // The slide is one stride longer than to the first position at which the walker fits.
            if (goes[side] && opens_there(sides[side])) return sign * (aside_m + stride_m);
        }
    return std::nullopt;
}

}  // namespace handrail::navigation
