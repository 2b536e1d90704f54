// Planned ways in words: what is met on one as it stands there by now, and a whole way with its stops. Functions of
// what the context holds; planning costs a way of Navigation for each leg. App thread only.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/kept/ways.h"
#include "app/core/wayfinding/route_words.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

// With what is in the way there by now.
std::vector<RouteNode> nodes_to(const SessionContext& context, const Route& route, const std::string& goal);

// "28 steps in all, through Hall and Study.": how long a way is and through which rooms it leads. The rooms are found.
std::string overview_words(const SessionContext& context, const Rooms& rooms, const Route& route);

// All of it from its first stop on, each stop with the way to it. The rooms are found.
std::string whole_way_words(const SessionContext& context, const Rooms& rooms, const std::string& name,
                            std::span<const Stop> stops);

}  // namespace handrail
