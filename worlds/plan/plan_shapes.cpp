#include "worlds/plan/plan_shapes.h"

#include <algorithm>
#include <limits>

namespace handrail {

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
        // The tolerance makes the first of equally small boxes win on every machine.
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

}  // namespace handrail
