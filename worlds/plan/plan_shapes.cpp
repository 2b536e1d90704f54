#include "worlds/plan/plan_shapes.h"

#include <algorithm>
#include <limits>

namespace handrail::plan {

std::array<Vec2, 4> PlanBox::corners_m() const {
    const Vec2 x = along * half_m.x, y = Vec2(-along.y, along.x) * half_m.y;
    return {middle_m - x - y, middle_m + x - y, middle_m + x + y, middle_m - x + y};
}

PlanBox box_around(const PlanOutline& hull) {
    PlanBox best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 side = hull[(i + 1) % hull.size()] - hull[i];
        const double length = glm::length(side);
        if (length < 1e-9) continue;
        const Vec2 along = side / length, across(-along.y, along.x);
        Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
        for (const Vec2& p : hull) {
            const Vec2 q(glm::dot(p, along), glm::dot(p, across));
            low = glm::min(low, q);
            high = glm::max(high, q);
        }
        const Vec2 size = high - low;
        // The tolerance ensures that, of several equally small boxes, every machine chooses the first.
        if (size.x * size.y > least * (1.0 - 1e-6)) continue;
        least = size.x * size.y;
        const Vec2 middle = 0.5 * (low + high);
        best = {along * middle.x + across * middle.y, along, 0.5 * size};
        if (size.y > size.x) {
            best.along = across;
            best.half_m = {0.5 * size.y, 0.5 * size.x};
        }
    }
    return best;
}

bool within(const PlanOutline& outline, const Vec2& at) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& a = outline[i];
        if (cross_of(outline[(i + 1) % outline.size()] - a, at - a) < -1e-9) return false;
    }
    return outline.size() >= 3;
}

bool within_loop(const std::vector<Vec2>& loop, const Vec2& at) {
    bool within = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)) within = !within;
    }
    return within;
}

double narrowest_m(const PlanOutline& outline) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
        const double length = glm::length(side);
        if (length < 1e-9) continue;
        double far = 0.0;
        for (const Vec2& p : outline) far = std::max(far, std::abs(cross_of(side / length, p - outline[i])));
        least = std::min(least, far);
    }
    return least;
}

std::optional<SquaredWall> squared_wall(const PlanOutline& outline) {
    constexpr double kThin_m = 0.05, kThick_m = 1.0;
    // Least and greatest cosine of the angle between a side and a mitred end; a mitre is about half of a right angle.
    constexpr double kLeastSlant = 0.4, kMostSlant = 0.92;
    if (outline.size() != 4) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
        // Tests whether the side from a to b is a mitred end. The two sides next to it must be parallel.
        const Vec2 &before = outline[(i + 3) % 4], &a = outline[i], &b = outline[(i + 1) % 4],
                   &behind = outline[(i + 2) % 4];
        const double end = glm::distance(a, b), side_a = glm::distance(a, before), side_b = glm::distance(b, behind);
        if (end < 1e-6 || side_a < 1e-6 || side_b < 1e-6) continue;
        const Vec2 way = (a - before) / side_a;
        const double thick = std::abs(cross_of(way, b - a)), slant = glm::dot(way, b - a) / end;
        if (std::abs(cross_of(way, (b - behind) / side_b)) > 1e-3 || glm::dot(way, b - behind) <= 0.0) continue;
        if (thick < kThin_m || thick > kThick_m || std::min(side_a, side_b) < thick) continue;
        if (std::abs(slant) < kLeastSlant || std::abs(slant) > kMostSlant) continue;
        SquaredWall made{outline, {}};
        const bool a_is_short = slant > 0.0;
        Vec2& moved = made.outline[a_is_short ? i : (i + 1) % 4];
        made.added = {a, b, moved + way * std::abs(glm::dot(way, b - a))};
        moved = made.added[2];
        return made;
    }
    return std::nullopt;
}

}  // namespace handrail::plan
