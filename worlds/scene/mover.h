// Parts of the building that move as the map says: doors, lifts, buttons, sliding bridges, trains, turning parts; and
// the places that set them going or lead elsewhere. Plain values of a Scene: where each can be and what sets it going.
// app/core/world/mover_play moves them.
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"

namespace handrail {

// Where a train comes by: the zero of its frame, and how long it waits there (negative: until something sends it on).
struct TrainStop {
    Vec3 at_m{0.0};
    double wait_s = 0.0;
};

inline constexpr std::uint32_t kNoMover = 0xffffffffU;

// Most have two ends, which stand here; at part 0 they are where the file has them. A train goes from stop to stop, a
// turning part turns on and on.
struct Mover {
    FeatureId feature = kNoFeature;
    Vec3 slide_m{0.0};  // whole way of one that slides
    // Whole turn of one that swings, counter-clockwise from above, about the upright line through pivot_m.
    double swing_rad = 0.0;
    Vec3 pivot_m{0.0};       // zero of its own frame, world metres
    double travel_s = 1.0;   // for the whole way
    double wait_s = 3.0;     // at the other end before it goes back by itself; negative: it stays
    bool rests_far = false;  // rests at the other end (a lift that waits below) and is sent to where the file has it
    // The person can set it going by touch or key; else only what stands in `sets_going` of others can.
    bool by_hand = true;
    Aabb approach_m;                        // a body that comes in here sets it going; empty: none does
    std::uint32_t group = 0;                // all of one group go together
    std::vector<std::uint32_t> sets_going;  // other movers, by their place in Scene::movers
    // Its maker lets it through all that have the same number here; kNoMover: through none but its group.
    std::uint32_t passes = kNoMover;

    std::vector<double> halts;      // of a lift: the parts of its way where it stops, rising; empty: its two ends
    std::uint32_t lift = kNoMover;  // a door of that lift: open only while the lift stands at `lift_part` of its way
    double lift_part = 0.0;
    double sends_to = -1.0;  // a lift's button: to that part of the lift's way; negative: to the other end

    std::vector<TrainStop> stops;   // of a train, in their order; it stands at the first one at the start
    int after_last = -1;            // the stop that follows the last; -1: it stays there
    double speed_m_per_s = 0.0;     // of a train
    double turn_rad_per_s = 0.0;    // of a turning part, right-handed about turn_axis through pivot_m
    Vec3 turn_axis{0.0, 0.0, 1.0};  // unit
    bool starts_going = true;       // a train or turning part; else something sets it going

    // Goes on for as long as nothing stops it, and has no end at which it rests.
    bool endless() const noexcept { return stops.size() > 1 || turn_rad_per_s != 0.0; }
    bool moves() const noexcept { return slide_m != Vec3(0.0) || swing_rad != 0.0 || endless(); }
    // Of its own frame, 0 <= part <= 1. An endless one: where it is at the start.
    Placement at(double part) const {
        if (!stops.empty()) return {stops.front().at_m, {}, 1.0};
        return {pivot_m + slide_m * part, rotation_about({0.0, 0.0, 1.0}, swing_rad * part), 1.0};
    }
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
