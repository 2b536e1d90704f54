// Planned routes in words: what is met on one in its present state, and a whole route with its stops. Functions of what
// the context contains; planning costs one Navigation plan for each leg. App thread only.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/route_words.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Includes the present obstacles at passages.
std::vector<RouteNode> nodes_to(const SessionContext& context, const navigation::Route& route, const std::string& goal);

// "28 steps in all, through Hall and Study.": the length of a route and the rooms on it. Requires that the rooms are
// found.
std::string overview_words(const SessionContext& context, const Rooms& rooms, const navigation::Route& route);

// The whole route from its first stop on, each stop with the route to it. Requires that the rooms are found.
std::string whole_way_words(const SessionContext& context, const Rooms& rooms, const std::string& name,
                            std::span<const Stop> stops);

}  // namespace handrail::core
