// Where on a sheet or plate something still fits, as what was drawn before leaves room. Plain state; any one thread.
// Millimetres.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/exports/ink.h"
#include "worlds/plan/storey.h"

namespace handrail {

std::vector<Vec2> corners_of(const PlanBox& box);
double distance_to_loop_mm(const std::vector<Vec2>& loop, const Vec2& at);
// Whether no black lies on the straight line from one place to the other.
bool clear_between(const Ink& ink, const Vec2& from_mm, const Vec2& to_mm);

// Whether a box comes nearer to one of others than that; all have their sides north and east.
bool is_near_any(const PlanBox& box, const std::vector<PlanBox>& others, double gap_mm);

class Places {
public:
    Places() = default;
    // All within `low` and `high` that is `clear_mm` from what is black.
    Places(const Ink& black, double clear_mm, const Vec2& low_mm, const Vec2& high_mm);

    // From now on what is drawn in a closed line keeps others as far away.
    void take(const std::vector<Vec2>& loop_mm);
    // Asked at places half a millimetre apart.
    bool fits(const PlanBox& box_mm) const;
    // The nearest place to `from` at which a box fits, of those that are allowed; on a grid of half a millimetre.
    std::optional<Vec2> nearest_fit(const Vec2& from_mm, double reach_mm,
                                    const std::function<PlanBox(const Vec2&)>& box_at,
                                    const std::function<bool(const Vec2&)>& allowed) const;
    // The largest part of a box that is free, each half side at least `least_half_mm`.
    std::optional<PlanBox> largest_fit(const PlanBox& box_mm, double least_half_mm) const;

private:
    bool is_free(const Vec2& at_mm) const;

    Ink taken_;
    double clear_mm_ = 0.0;
    Vec2 low_mm_{0.0}, high_mm_{0.0};
};

}  // namespace handrail
