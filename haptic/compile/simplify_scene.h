// Changes details that are too small to feel at the present scale, but only in the scene for the hand. Doorways
// narrower than a fingertip can find are widened, with their leaves. Things too small to distinguish from the wall are
// left out. Walking, sound, routes and drawing keep the true scene. Walls are never made thicker: the proxy cannot pass
// even a thin wall, and each side has its own name. Pure functions over a Scene; app thread or background thread. World
// metres, unless a name contains _hand_.
//
// plan_simplification() makes a plan, and simplified() builds the scene from it. At most scales the plan changes
// nothing in most worlds, so the scene need not be copied.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/scene/scene.h"

namespace handrail::compile {

// Sizes from tactile graphics, a quarter and an eighth of an inch: the smallest gap that people find, and the smallest
// thing that people feel at all.
inline constexpr double kLeastGap_hand_m = 0.0064, kLeastThing_hand_m = 0.0032;

struct SimplifyOptions {
    double world_m_per_hand_m = 0.0;  // world metres per hand metre; 0: nothing is too small to feel
    std::vector<Vec3> openings_m;     // for each opening without a door, a point on its floor
    std::vector<Vec3> kept_m;  // Marks, and the destination of a route. Things at these places are never left out.
};

// A doorway that is too narrow to feel. low_m and high_m are offsets along `along`, front_m and back_m along left();
// floor_m and top_m are heights.
struct NarrowOpening {
    std::vector<FeatureId> doors;  // doors whose leaves close the opening; empty: an opening without a door
    int place = -1;                // for an opening without a door, its index in SimplifyOptions::openings_m
    Vec3 along{1.0, 0.0, 0.0};     // horizontal unit vector from one side of the opening to the other
    double low_m = 0.0, high_m = 0.0;
    double felt_low_m = 0.0, felt_high_m = 0.0;  // the two sides after widening
    double front_m = 0.0, back_m = 0.0;          // depth range of the cut, along left()
    double floor_m = 0.0, top_m = 0.0;
    // Intended width. It is greater than felt_width_m() if the widening had to stop at another wall, at another
    // opening, or at a solid that cannot be cut.
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
    // Factor by which everything at the doorway is stretched along `along`, so that a leaf still closes it from hinge
    // to handle.
    double times() const { return felt_width_m() / width_m(); }
    Vec3 drawn_apart(const Vec3& p) const;
};

struct Simplification {
    std::vector<NarrowOpening> openings;  // includes openings that could not be widened
    std::vector<FeatureId> left_out;

    bool operator==(const Simplification&) const = default;
    bool changes_nothing() const;
    std::size_t widened() const;
    // Number of openings that are still too narrow to feel, including those that were widened only partly.
    std::size_t staying_narrow() const;
    const NarrowOpening* of_door(FeatureId door) const;  // null if the door's opening was not widened
};

// Plans the simplification. The time is proportional to the number of things, plus for each door the number of things
// near it. The result does not depend on the order of the solids. If another thread requests a stop, the plan stays
// empty and the call returns soon. The function calls `looks` before it examines each part, opening and thing.
Simplification plan_simplification(const Scene& scene, const SimplifyOptions& options, const std::stop_token& stop = {},
                                   const std::function<void()>& looks = {});

// Returns the scene as the hand should feel it, without surfaces, starts and sounds. Features and the indices of placed
// things are those of `scene`. Call it only if the plan changes something.
Scene simplified(const Scene& scene, const Simplification& plan);

// Returns the pose at which the hand feels a placed thing whose true pose is `at`.
Placement felt_placement(const Simplification& plan, FeatureId thing, const Placement& at);

}  // namespace handrail::compile
