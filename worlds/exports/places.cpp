#include "worlds/exports/places.h"

#include <algorithm>

namespace handrail::exports {

std::vector<Vec2> corners_of(const plan::PlanBox& box) {
    const auto corners = box.corners_m();
    return {corners.begin(), corners.end()};
}

double distance_to_loop_mm(const std::vector<Vec2>& loop, const Vec2& at) {
    double least = 1e300;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2& a = loop[i];
        const Vec2 way = loop[(i + 1) % loop.size()] - a;
        const double squared = glm::dot(way, way);
        const double t = squared > 0.0 ? std::clamp(glm::dot(at - a, way) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, glm::distance(at, a + way * t));
    }
    return least;
}

bool clear_between(const Ink& ink, const Vec2& from_mm, const Vec2& to_mm) {
    const int steps = std::max(1, static_cast<int>(glm::distance(from_mm, to_mm) / (2.0 * kInkPixel_mm)));
    for (int i = 0; i <= steps; ++i) {
        const Vec2 at = from_mm + (to_mm - from_mm) * (static_cast<double>(i) / steps);
        const int x = static_cast<int>(at.x / kInkPixel_mm), y = static_cast<int>(at.y / kInkPixel_mm);
        if (ink.holds(x, y) && ink.black[ink.at(x, y)]) return false;
    }
    return true;
}

bool is_near_any(const plan::PlanBox& box, const std::vector<plan::PlanBox>& others, double gap_mm) {
    return std::any_of(others.begin(), others.end(), [&](const plan::PlanBox& other) {
        const Vec2 apart = glm::abs(box.middle_m - other.middle_m) - box.half_m - other.half_m;
        return glm::length(glm::max(apart, Vec2(0.0))) < gap_mm;
    });
}

Places::Places(const Ink& black, double clear_mm, const Vec2& low_mm, const Vec2& high_mm)
    : taken_(near_black(black, clear_mm / kInkPixel_mm + 1.0, false)),
      clear_mm_(clear_mm),
      low_mm_(low_mm),
      high_mm_(high_mm) {}

void Places::take(const std::vector<Vec2>& loop_mm) {
    Vec2 low(1e300), high(-1e300);
    for (const Vec2& p : loop_mm) low = glm::min(low, p), high = glm::max(high, p);
    const auto pixel = [](double mm) { return static_cast<int>(std::floor(std::clamp(mm, -1e4, 1e4) / kInkPixel_mm)); };
    const int last_x = std::min(taken_.wide - 1, pixel(high.x + clear_mm_));
    const int last_y = std::min(taken_.high - 1, pixel(high.y + clear_mm_));
    for (int y = std::max(0, pixel(low.y - clear_mm_)); y <= last_y; ++y)
        for (int x = std::max(0, pixel(low.x - clear_mm_)); x <= last_x; ++x) {
            std::uint8_t& there = taken_.black[taken_.at(x, y)];
            if (there) continue;
            const Vec2 at = Vec2(x + 0.5, y + 0.5) * kInkPixel_mm;
            there =
                plan::within_loop(loop_mm, at) || distance_to_loop_mm(loop_mm, at) <= clear_mm_ + kInkPixel_mm ? 1 : 0;
        }
}

bool Places::is_free(const Vec2& at_mm) const {
    if (at_mm.x < low_mm_.x || at_mm.y < low_mm_.y || at_mm.x > high_mm_.x || at_mm.y > high_mm_.y) return false;
    const int x = static_cast<int>(at_mm.x / kInkPixel_mm), y = static_cast<int>(at_mm.y / kInkPixel_mm);
    return taken_.holds(x, y) && !taken_.black[taken_.at(x, y)];
}

bool Places::fits(const plan::PlanBox& box_mm) const {
    const Vec2 across(-box_mm.along.y, box_mm.along.x);
    const auto steps = [](double half) { return std::max(1, static_cast<int>(std::ceil(2.0 * half / 0.5))); };
    const int nx = steps(box_mm.half_m.x), ny = steps(box_mm.half_m.y);
    for (int i = 0; i <= nx; ++i)
        for (int j = 0; j <= ny; ++j) {
            const Vec2 at = box_mm.middle_m + box_mm.along * (box_mm.half_m.x * (2.0 * i / nx - 1.0)) +
                            across * (box_mm.half_m.y * (2.0 * j / ny - 1.0));
            if (!is_free(at)) return false;
        }
    return true;
}

std::optional<Vec2> Places::nearest_fit(const Vec2& from_mm, double reach_mm,
                                        const std::function<plan::PlanBox(const Vec2&)>& box_at,
                                        const std::function<bool(const Vec2&)>& allowed) const {
    constexpr double kStep_mm = 0.5;
    const int reach = static_cast<int>(reach_mm / kStep_mm);
    std::optional<Vec2> best;
    double least = reach_mm;
    // A hall can be far larger than the page, so only places on the page are tried.
    const auto first = [&](int axis) {
        return static_cast<int>(std::floor(std::max(-reach_mm, low_mm_[axis] - from_mm[axis]) / kStep_mm));
    };
    const auto last = [&](int axis) {
        return static_cast<int>(std::ceil(std::min(reach_mm, high_mm_[axis] - from_mm[axis]) / kStep_mm));
    };
    const int first_i = first(0), last_i = last(0), first_j = first(1), last_j = last(1);
    const auto take_nearer = [&](int i, int j) {
        const Vec2 off = Vec2(i, j) * kStep_mm;
        const double far = glm::length(off);
        if (far >= least || !is_free(from_mm + off) || !allowed(from_mm + off) || !fits(box_at(from_mm + off))) return;
        least = far;
        best = from_mm + off;
    };
    // Tests rings of squares around the start, from the innermost outwards.
    for (int ring = 0; ring <= reach && ring * kStep_mm <= least; ++ring)
        for (int i = std::max(-ring, first_i); i <= std::min(ring, last_i); ++i) {
            if (std::abs(i) == ring) {
                for (int j = std::max(-ring, first_j); j <= std::min(ring, last_j); ++j) take_nearer(i, j);
                continue;
            }
            if (-ring >= first_j && -ring <= last_j) take_nearer(i, -ring);
            if (ring <= last_j && ring >= first_j) take_nearer(i, ring);
        }
    return best;
}

std::optional<plan::PlanBox> Places::largest_fit(const plan::PlanBox& box_mm, double least_half_mm) const {
    const Vec2 across(-box_mm.along.y, box_mm.along.x);
    std::optional<plan::PlanBox> best;
    double area = 0.0;
    for (int i = 20; i >= 4; --i)
        for (int j = 20; j >= 4; --j) {
            const Vec2 half = box_mm.half_m * (Vec2(i, j) / 20.0);
            if (half.x < least_half_mm - 1e-9 || half.y < least_half_mm - 1e-9 || half.x * half.y <= area) continue;
            for (const double x : {0.0, -1.0, 1.0, -0.5, 0.5})
                for (const double y : {0.0, -1.0, 1.0, -0.5, 0.5}) {
                    if ((i == 20 && x != 0.0) || (j == 20 && y != 0.0) || half.x * half.y <= area) continue;
                    const plan::PlanBox tried{box_mm.middle_m + box_mm.along * (x * (box_mm.half_m.x - half.x)) +
                                                  across * (y * (box_mm.half_m.y - half.y)),
                                              box_mm.along, half};
                    if (!fits(tried)) continue;
                    best = tried;
                    area = half.x * half.y;
                }
        }
    return best;
}

}  // namespace handrail::exports
