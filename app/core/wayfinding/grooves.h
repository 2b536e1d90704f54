// Grooves that the hand can feel on the floor: along the way that was planned last and through the openings of doors
// near by. Which legs they run along, as the servo takes them; pure functions, app thread. The force stands in
// haptic/servo/guidance.
#pragma once

#include <span>
#include <vector>

#include "haptic/servo/guidance.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail {

// On the floor, at the soles.
struct GrooveLeg {
    Vec3 from_m{0.0}, to_m{0.0};
};

// Through each door and opening between two rooms of one storey, square to it.
std::vector<GrooveLeg> grooves_through_doorways(const RoomGraph& graph, const WalkSpace& space);

// Those nearest to a place that the servo can take at once, so high above the floor as the middle of a ball that lies
// on it. `good_within_m`: a hand that has not gone farther than that from the place misses none; infinite where all
// could be taken.
struct Grooves {
    GuidancePath path;
    double good_within_m = 0.0;
};
Grooves nearest_grooves(std::span<const Vec3> way_m, std::span<const GrooveLeg> doorways, const Vec3& near_m,
                        double ball_radius_m);

}  // namespace handrail
