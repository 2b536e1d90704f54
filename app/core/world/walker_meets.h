// Finds what blocks a walker of a given width and height. Pure functions for the app thread.
#pragma once

#include <optional>

#include "app/core/world/surroundings.h"
#include "app/core/world/walker.h"

namespace handrail::core {

// Returns what the walker bumps into first in that direction, ignoring what the walker can step over. Returns no value
// if nothing is within range.
std::optional<Seen> walker_meets(const WalkerWorld& world, const Vec3& feet_m, const WalkerSize& size,
                                 double bearing_rad, double range_m = kSightRange_m);

}  // namespace handrail::core
