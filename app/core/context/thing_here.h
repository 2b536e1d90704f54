// Finds the thing that the person means by "this": what the hand touches, or else what is ahead of the walker. Use it
// on the app thread only.
#pragma once

#include <optional>

#include "app/core/context/session_context.h"

namespace handrail::core {

struct ThingHere {
    FeatureId id;
    Vec3 place_m{0.0};  // where the hand touches it or the person faces it, in world metres
};
// Returns what the hand touches, if it touches anything. Otherwise returns the nearest thing with a name that is in
// line of sight, within 30 m and 11 degrees to either side of straight ahead, or else the surface straight ahead.
// Returns no value if none of these has a name. Costs as many rays as things_in_sight().
std::optional<ThingHere> thing_here(const SessionContext& context);

}  // namespace handrail::core
