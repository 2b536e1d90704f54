// What is too small to feel at a scale, changed for the hand alone (G2): doorways narrower than a fingertip can find
// are widened, with their leaves; things too small to be told from the wall are left out. Walking, sound, ways and
// drawing keep the true scene. Walls are never made thicker: no ball gets through a thin one, and each side is named
// for what it is. Pure functions over a Scene; app or worker thread. World metres, unless a name says hand.
//
// A plan first, then the scene: most scales change nothing in most worlds, and then nothing is copied.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Tactile graphics' quarter and eighth of an inch: what is to be found as a gap, and what is felt at all.
inline constexpr double kLeastGap_hand_m = 0.0064, kLeastThing_hand_m = 0.0032;

struct SimplifyOptions {
    double world_m_per_hand_m = 0.0;  // 0: nothing is too small
    std::vector<Vec3> openings_m;     // of doorways without a door, where soles would stand in them
    std::vector<Vec3> kept_m;         // what stands here is wanted however small it is: marks, where one goes
};

// A doorway narrower than it should be felt. Offsets along `along`, and along what is left of it; heights.
struct NarrowOpening {
    std::vector<FeatureId> doors;  // its leaves; none: an opening without a door
    int place = -1;                // then its number in SimplifyOptions::openings_m
    Vec3 along{1.0, 0.0, 0.0};     // unit, level, across the opening
    double low_m = 0.0, high_m = 0.0;
    double felt_low_m = 0.0, felt_high_m = 0.0;  // after widening
    double front_m = 0.0, back_m = 0.0;          // of what is cut, along left()
    double floor_m = 0.0, top_m = 0.0;
    double wanted_m = 0.0;  // width; more than the felt one where widening had to stop: at another wall, another
                            // opening, at what cannot be cut

    bool operator==(const NarrowOpening&) const = default;
    Vec3 left() const { return {-along.y, along.x, 0.0}; }
    double width_m() const { return high_m - low_m; }
    double felt_width_m() const { return felt_high_m - felt_low_m; }
    bool widened() const { return felt_width_m() > width_m() + 1e-3; }
    bool stays_narrow() const { return felt_width_m() < wanted_m - 1e-3; }
    Vec3 middle_m() const {
        return along * (0.5 * (low_m + high_m)) + left() * (0.5 * (front_m + back_m)) + Vec3(0.0, 0.0, floor_m);
    }
    // What is taken out of the walls.
    std::vector<Plane> cut() const;
    // Everything at the doorway is drawn apart along `along` by this much, so that a leaf goes on closing it from hinge
    // to handle.
    double times() const { return felt_width_m() / width_m(); }
    Vec3 drawn_apart(const Vec3& p) const;
};

struct Simplification {
    std::vector<NarrowOpening> openings;  // also those where nothing could be done
    std::vector<FeatureId> left_out;

    bool operator==(const Simplification&) const = default;
    bool changes_nothing() const;
    std::size_t widened() const;
    std::size_t staying_narrow() const;                  // also after some widening
    const NarrowOpening* of_door(FeatureId door) const;  // null: not widened
};

// O(things + doors x what is near them). The same for any order of the solids. Where a stop is asked for from another
// thread nothing is planned, and what was begun ends soon. `looks` is told of every piece of the world, opening and
// thing before it is looked at.
Simplification plan_simplification(const Scene& scene, const SimplifyOptions& options, const std::stop_token& stop = {},
                                   const std::function<void()>& looks = {});

// The scene as a hand is to feel it: no surfaces, starts or sounds, features and numbers of placed things as in the
// true one. Only for a plan that changes something.
Scene simplified(const Scene& scene, const Simplification& plan);

// Where a placed thing stands for the hand that truly stands at `at`.
Placement felt_placement(const Simplification& plan, FeatureId thing, const Placement& at);

}  // namespace handrail
