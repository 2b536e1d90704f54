// Selects grooves on the floor for the hand, along the last planned route and through nearby doorways, and converts
// them to the form of the servo. haptic/servo/guidance computes the force. Pure functions for the app thread.
#pragma once

#include <span>
#include <vector>

#include "haptic/servo/guidance.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// A straight groove at floor level.
struct GrooveLeg {
    Vec3 from_m{0.0}, to_m{0.0};
};

// Returns one groove straight through each door and opening between two rooms of the same storey.
std::vector<GrooveLeg> grooves_through_doorways(const navigation::RoomGraph& graph, const navigation::WalkSpace& space);

// The grooves nearest to a place, as many as a path of the servo can contain. They are at the height of the centre of a
// proxy that lies on the floor. While the hand is within `good_within_m` of the place, no groove that is missing is
// nearer than these. The distance is infinite if all grooves fit.
struct Grooves {
    servo::GuidancePath path;
    double good_within_m = 0.0;
};
Grooves nearest_grooves(std::span<const Vec3> way_m, std::span<const GrooveLeg> doorways, const Vec3& near_m,
                        double proxy_radius_m);

}  // namespace handrail::core
