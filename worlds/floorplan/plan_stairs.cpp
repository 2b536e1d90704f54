#include "worlds/floorplan/plan_stairs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handrail::floorplan {
namespace {

constexpr double kRise_m = 0.185, kSteepRise_m = 0.22, kLeastGoing_m = 0.19, kGoing_m = 0.28;
constexpr double kLane_m = 1.2, kLeastLane_m = 0.75, kLanding_m = 1.1, kLeastLanding_m = 0.7;
constexpr double kRoundIt_m = 0.95, kBeforeIt_m = 1.0, kLeastBefore_m = 0.75;
constexpr int kPlaces = 64;
constexpr double kFoot_m = 0.45, kBody_m = 0.3;

}  // namespace

int steps_of_half(double rise_m, double step_rise_m) {
    return std::max(1, static_cast<int>(std::ceil(0.5 * rise_m / step_rise_m - 1e-9)));
}

Ring StairWell::box(double from_m, double to_m, double right_m, double left_m) const {
    return {at(from_m, right_m), at(to_m, right_m), at(to_m, left_m), at(from_m, left_m)};
}

Vec2 longest_side(const std::vector<Ring>& rings) {
    Vec2 best{1.0, 0.0};
    double most = 0.0;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 side = ring[(i + 1) % ring.size()] - ring[i];
            if (const double length = glm::length(side); length > most) most = length, best = side / length;
        }
    return best;
}

std::optional<InnerBox> inner_box(const std::vector<Ring>& rings, const Vec2& along) {
    InnerBox box;
    box.along = along;
    const Vec2 up{-along.y, along.x};
    Vec2 least{1e300}, most{-1e300};
    for (const Ring& ring : rings)
        for (const Vec2& p : ring) {
            const Vec2 own{glm::dot(p, along), glm::dot(p, up)};
            least = glm::min(least, own);
            most = glm::max(most, own);
        }
    if (!(most.x - least.x > 0.3) || !(most.y - least.y > 0.3) || !(most.x - least.x < 1e4)) return {};
    // A cell is free if all its corners are inside the outline. The corners are moved slightly inwards for this test.
    const Vec2 cell = (most - least) / static_cast<double>(kPlaces);
    const auto world = [&](double x, double y) { return along * (least.x + x * cell.x) + up * (least.y + y * cell.y); };
    std::array<std::array<bool, kPlaces>, kPlaces> free{};
    for (int y = 0; y < kPlaces; ++y)
        for (int x = 0; x < kPlaces; ++x)
            free[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
                inside(rings, world(x + 0.01, y + 0.01)) && inside(rings, world(x + 0.99, y + 0.01)) &&
                inside(rings, world(x + 0.01, y + 0.99)) && inside(rings, world(x + 0.99, y + 0.99));
    // Finds the largest rectangle of free cells. For each column, `high` is the number of free cells in a line that end
    // in the current row.
    std::array<int, kPlaces> high{};
    double largest = 0.0;
    for (int y = 0; y < kPlaces; ++y) {
        for (std::size_t x = 0; x < kPlaces; ++x) high[x] = free[static_cast<std::size_t>(y)][x] ? high[x] + 1 : 0;
        for (int from = 0; from < kPlaces; ++from) {
            int low = kPlaces;
            for (int to = from; to < kPlaces && low > 0; ++to) {
                low = std::min(low, high[static_cast<std::size_t>(to)]);
                const double size = (to - from + 1) * cell.x * low * cell.y;
                if (size <= largest) continue;
                largest = size;
                box.least = {from * cell.x, (y + 1 - low) * cell.y};
                box.most = {(to + 1) * cell.x, (y + 1) * cell.y};
            }
        }
    }
    if (largest <= 0.09) return {};
    box.origin = world(0.0, 0.0);
    return box;
}

namespace {

std::optional<StairWell> laid_with(const std::vector<Ring>& rings, std::span<const Vec2> doors, double rise_m,
                                   double step_rise_m) {
    const int steps = steps_of_half(rise_m, step_rise_m);
    std::optional<StairWell> best;
    int best_doors = -1;
    double best_size = 0.0;
    const Vec2 side = longest_side(rings);
    for (const Vec2& along : {side, Vec2(-side.y, side.x)}) {
        const std::optional<InnerBox> box = inner_box(rings, along);
        if (!box) continue;
        const Vec2 up{-along.y, along.x};
        const Vec2 middle =
            box->origin + along * (0.5 * (box->least.x + box->most.x)) + up * (0.5 * (box->least.y + box->most.y));
        for (const double way : {1.0, -1.0}) {
            const double length = box->most.x - box->least.x, width = box->most.y - box->least.y;
            // Tries all combinations with and without a passage behind the stairs and on each of their sides.
            for (const double behind : {kRoundIt_m, 0.0})
                for (const double beside_left : {kRoundIt_m, 0.06})
                    for (const double beside_right : {kRoundIt_m, 0.06}) {
                        StairWell well;
                        well.along = along * way;
                        well.step_rise_m = step_rise_m;
                        well.width_m = std::min(width - beside_left - beside_right, 2.0 * kLane_m);
                        const double before = length - behind > steps * kGoing_m + kLanding_m + kBeforeIt_m
                                                  ? kBeforeIt_m
                                                  : kLeastBefore_m;
                        well.length_m = std::min(length - behind - before, steps * kGoing_m + kLanding_m);
                        well.landing_m = std::clamp(well.length_m - steps * kGoing_m, kLeastLanding_m, kLanding_m);
                        if (well.width_m < 2.0 * kLeastLane_m || well.length_m - well.landing_m < steps * kLeastGoing_m)
                            continue;
                        // Remaining space goes in front of the stairs and is divided equally between their sides.
                        const double left_over = width - beside_left - beside_right - well.width_m;
                        const double from_right = beside_right + 0.5 * left_over + 0.5 * well.width_m;
                        well.from = middle + well.along * (0.5 * length - behind - well.length_m) +
                                    Vec2(-well.along.y, well.along.x) * (from_right - 0.5 * width);
                        int reached = 0;
                        for (const Vec2& door : doors) {
                            const Vec2 off = door - well.from;
                            const double x = glm::dot(off, well.along),
                                         y = glm::dot(off, Vec2(-well.along.y, well.along.x));
                            const double far_x = std::max({-x, x - well.length_m, 0.0}),
                                         far_y = std::max(std::abs(y) - 0.5 * well.width_m, 0.0);
                            // A person at the door must be able to get to the open end of the well, if necessary by
                            // walking around the well.
                            const bool before_it = x<-kBody_m, at_side = far_y> kFoot_m + kBody_m,
                                       at_end = far_x > kFoot_m + kBody_m;
                            reached += before_it || at_side || at_end ? 1 : 0;
                        }
                        const double size = well.width_m * (well.length_m + 1.0);
                        if (reached < best_doors || (reached == best_doors && size <= best_size)) continue;
                        best = well;
                        best_doors = reached;
                        best_size = size;
                    }
        }
    }
    return best;
}

}  // namespace

std::optional<StairWell> lay_stairs(const std::vector<Ring>& rings, std::span<const Vec2> doors, double rise_m) {
    if (const std::optional<StairWell> well = laid_with(rings, doors, rise_m, kRise_m)) return well;
    return laid_with(rings, doors, rise_m, kSteepRise_m);
}

}  // namespace handrail::floorplan
