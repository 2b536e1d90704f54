// Finds free space on a sheet or plate, and stores which space is already used. Plain state; only one thread at a time
// may use an object. Millimetres.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/exports/ink.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

std::vector<Vec2> corners_of(const plan::PlanBox& box);
double distance_to_loop_mm(const std::vector<Vec2>& loop, const Vec2& at);
// Returns whether the straight line between the two places crosses only white.
bool clear_between(const Ink& ink, const Vec2& from_mm, const Vec2& to_mm);

// Returns whether a box is closer than `gap_mm` to one of the other boxes. All boxes have sides parallel to the axes.
bool is_near_any(const plan::PlanBox& box, const std::vector<plan::PlanBox>& others, double gap_mm);

class Places {
public:
    Places() = default;
    // At first, all space between `low_mm` and `high_mm` is free that is at least `clear_mm` from black.
    Places(const Ink& black, double clear_mm, const Vec2& low_mm, const Vec2& high_mm);

    // Marks a closed line and its inside as used. From now on, the free space ends `clear_mm` away from the line.
    void take(const std::vector<Vec2>& loop_mm);
    // Returns whether the box is free. Tests points half a millimetre apart.
    bool fits(const plan::PlanBox& box_mm) const;
    // Returns the allowed place nearest to `from_mm` at which a box fits. Tests places on a grid of half a millimetre.
    std::optional<Vec2> nearest_fit(const Vec2& from_mm, double reach_mm,
                                    const std::function<plan::PlanBox(const Vec2&)>& box_at,
                                    const std::function<bool(const Vec2&)>& allowed) const;
    // Returns the largest free part of a box. Its half sides are at least `least_half_mm`. Returns nothing if there is
    // no such part.
    std::optional<plan::PlanBox> largest_fit(const plan::PlanBox& box_mm, double least_half_mm) const;

private:
    bool is_free(const Vec2& at_mm) const;

    Ink taken_;
    double clear_mm_ = 0.0;
    Vec2 low_mm_{0.0}, high_mm_{0.0};
};

}  // namespace handrail::exports
