// Finds the thing that the person means by "this": what the hand touches, or else what is straight ahead of the walker.
// Use it on the app thread only.
#pragma once

#include <optional>

#include "app/core/context/session_context.h"

namespace handrail::core {

struct ThingHere {
    FeatureId id;
    Vec3 place_m{0.0};  // where the hand touches it or the person faces it, in world metres
};
// Returns no value if neither the hand nor the view ahead meets a thing with a name. Costs at most one ray.
std::optional<ThingHere> thing_here(const SessionContext& context);

}  // namespace handrail::core
