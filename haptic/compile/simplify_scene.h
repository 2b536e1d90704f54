// Changes what is too small to feel at a scale, for the hand alone (G2). Doorways narrower than a fingertip can find
// are widened, with their leaves; things too small to distinguish from the wall are left out. Walking, sound, routes
// and drawing keep the true scene. Walls are never made thicker: the proxy cannot pass even a thin one, and each side
// has its own name. Pure functions over a Scene; app or background thread. World metres, unless a name says hand.
//
// There is first a plan and then a scene: most scales change nothing in most worlds, and then nothing is copied.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/scene/scene.h"

namespace handrail::compile {

// A quarter and an eighth of an inch, from tactile graphics: the smallest gap that people find, and the smallest thing
// that they feel at all.
inline constexpr double kLeastGap_hand_m = 0.0064, kLeastThing_hand_m = 0.0032;

struct SimplifyOptions {
    double world_m_per_hand_m = 0.0;  // 0: nothing counts as too small
    std::vector<Vec3> openings_m;     // for each doorway without a door a point on its floor
    std::vector<Vec3> kept_m;  // things at these places stay, however small: marks, and the destination of a route
};

// A doorway that is too narrow to feel. Offsets are along `along` and along left(); the others are heights.
struct NarrowOpening {
    std::vector<FeatureId> doors;  // its leaves; empty: an opening without a door
    int place = -1;                // for an opening without a door, its index in SimplifyOptions::openings_m
    Vec3 along{1.0, 0.0, 0.0};     // unit vector, level, across the opening
    double low_m = 0.0, high_m = 0.0;
    double felt_low_m = 0.0, felt_high_m = 0.0;  // after widening
    double front_m = 0.0, back_m = 0.0;          // range of the cut, along left()
    double floor_m = 0.0, top_m = 0.0;
    // Wanted width. Greater than the felt one if widening had to stop at another wall, another opening, or a solid that
    // cannot be cut.
    double wanted_m = 0.0;

    bool operator==(const NarrowOpening&) const = default;
    Vec3 left() const { return {-along.y, along.x, 0.0}; }
    double width_m() const { return high_m - low_m; }
    double felt_width_m() const { return felt_high_m - felt_low_m; }
    bool widened() const { return felt_width_m() > width_m() + 1e-3; }
    bool stays_narrow() const { return felt_width_m() < wanted_m - 1e-3; }
    Vec3 middle_m() const {
        return along * (0.5 * (low_m + high_m)) + left() * (0.5 * (front_m + back_m)) + Vec3(0.0, 0.0, floor_m);
    }
    // The volume that is removed from the walls.
    std::vector<Plane> cut() const;
    // Everything at the doorway is stretched along `along` by this factor, so that a leaf still closes it from hinge to
    // handle.
    double times() const { return felt_width_m() / width_m(); }
    Vec3 drawn_apart(const Vec3& p) const;
};

struct Simplification {
    std::vector<NarrowOpening> openings;  // includes those that could not be changed
    std::vector<FeatureId> left_out;

    bool operator==(const Simplification&) const = default;
    bool changes_nothing() const;
    std::size_t widened() const;
    std::size_t staying_narrow() const;                  // includes those that were widened partly
    const NarrowOpening* of_door(FeatureId door) const;  // null: not widened
};

// Cost: O(things + doors x what is near them). The result does not depend on the order of the solids. If a stop is
// requested from another thread, the plan stays empty and the call returns soon. `looks` is called before each piece of
// the world, opening and thing.
Simplification plan_simplification(const Scene& scene, const SimplifyOptions& options, const std::stop_token& stop = {},
                                   const std::function<void()>& looks = {});

// The scene as the hand should feel it: without surfaces, starts and sounds; features and indices of placed things are
// as in the true scene. Only for a plan that changes something.
Scene simplified(const Scene& scene, const Simplification& plan);

// The felt pose of a placed thing whose true pose is `at`.
Placement felt_placement(const Simplification& plan, FeatureId thing, const Placement& at);

}  // namespace handrail::compile
