// Grooves on the floor for the hand, along the last planned route and through nearby doorways. This file selects the
// legs along which they run, in the servo's form. Pure functions, app thread. haptic/servo/guidance computes the force.
#pragma once

#include <span>
#include <vector>

#include "haptic/servo/guidance.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// On the floor.
struct GrooveLeg {
    Vec3 from_m{0.0}, to_m{0.0};
};

// One leg square through each door and opening between two rooms of one storey.
std::vector<GrooveLeg> grooves_through_doorways(const navigation::RoomGraph& graph, const navigation::WalkSpace& space);

// The grooves nearest to a place, as many as the servo can take at once, at the height of the centre of a proxy that
// lies on the floor. `good_within_m`: within this distance of the place the hand misses none; infinite if all of them
// fit.
struct Grooves {
    servo::GuidancePath path;
    double good_within_m = 0.0;
};
Grooves nearest_grooves(std::span<const Vec3> way_m, std::span<const GrooveLeg> doorways, const Vec3& near_m,
                        double ball_radius_m);

}  // namespace handrail::core
