// Puts planned routes into words: the features on a route in their present state, and a whole route with its stops.
// Functions of the context. Planning costs one call of Navigation::plan for each leg. Use them on the app thread only.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/route_words.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Returns the instructions for a route, including present obstacles at its passages.
std::vector<RouteNode> nodes_to(const SessionContext& context, const navigation::Route& route, const std::string& goal);

// Returns the first rooms between the ends of a route: "Hall, Study". The text is empty if there are none. Call it only
// after the rooms have been found.
std::string rooms_between(const Rooms& rooms, const navigation::Route& route);

// Returns the whole route from its first stop on, with the directions to each stop. Call it only after the rooms have
// been found.
std::string whole_route_words(const SessionContext& context, const Rooms& rooms, const std::string& name,
                              std::span<const Stop> stops);

// Appends to `legs` those behind the first passage of the route without legs, where the given ones end. On which side a
// lift is left is not known, so they begin without a turn.
void append_legs_behind(std::vector<std::string>& legs, const SessionContext& context, const navigation::Route& route,
                        const std::string& goal);
// Returns the room where the walker is and the direction that it faces: "Hall, facing west."
std::string place_facing_words(const SessionContext& context, const Rooms& rooms);

}  // namespace handrail::core
