// Determines how far directions leg by leg lead along a route. They lead over floor and stairs, and through doors that
// the person can open. A route with a lift or another passage is announced in stages: leg by leg to that passage, then
// what to do there, then leg by leg again. Functions of the context, for the app thread. Lengths are in world metres.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/route_directions.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

// Returns true if directions leg by leg can describe the passage: an opening, stairs, or a door that waits for neither
// a button nor a lift.
bool has_legs(const SessionContext& context, navigation::PassageKind kind, FeatureId feature);
// Returns the first passage of the route for which that does not hold, or no value if it holds for all passages.
std::optional<navigation::RoutePassage> without_legs(const SessionContext& context, const navigation::Route& route);

// The present stage of a route.
struct RouteStage {
    DirectionsEnd end;
    std::string name;  // name of that end, as the last leg announces it
};
// Returns the stage that begins at the beginning of the route, which leads to `end` with this name. Returns no value if
// a passage without legs is right there, so that it comes next.
std::optional<RouteStage> first_stage(const SessionContext& context, const navigation::Route& route,
                                      const DirectionsEnd& end, const std::string& name);

}  // namespace handrail::core
