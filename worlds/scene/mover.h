// Parts of the building that move as the map says: doors, lifts, buttons, sliding bridges; and the places that set them going or lead elsewhere. Plain
// values of a Scene: where each can be and what sets it going. app/core/mover_play moves them.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"

namespace handrail {

// Both ends of the way stand here; at part 0 it is where the file has it.
struct Mover {
    FeatureId feature = kNoFeature;
    Vec3 slide_m{0.0};                      // whole way of one that slides
    double swing_rad = 0.0;                 // whole turn of one that swings, counter-clockwise from above, about the upright line through pivot_m
    Vec3 pivot_m{0.0};                      // zero of its own frame, world metres
    double travel_s = 1.0;                  // for the whole way
    double wait_s = 3.0;                    // at the other end before it goes back by itself; negative: it stays
    bool rests_far = false;                 // rests at the other end (a lift that waits below) and is sent to where the file has it
    bool by_hand = true;                    // the person can set it going by touch or key; else only what stands in `sets_going` of others can
    Aabb approach_m;                        // a body that comes in here sets it going; empty: none does
    std::uint32_t group = 0;                // all of one group go together
    std::vector<std::uint32_t> sets_going;  // other movers, by their place in Scene::movers

    bool moves() const noexcept { return slide_m != Vec3(0.0) || swing_rad != 0.0; }
    // Of its own frame, 0 <= part <= 1.
    Placement at(double part) const { return {pivot_m + slide_m * part, rotation_about({0.0, 0.0, 1.0}, swing_rad * part), 1.0}; }
};

// A volume that acts when a body comes into it.
struct Switch {
    FeatureId volume = kNoFeature;          // a trigger's or teleporter's feature
    std::vector<std::uint32_t> sets_going;  // places in Scene::movers
    bool once = false;
    bool leads_elsewhere = false;  // puts the body at feet_m, facing heading_rad
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

}  // namespace handrail
