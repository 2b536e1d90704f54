// Lists all places of a world as a table: rooms, doors, landmarks, clues, things and the person's marks, each with its
// kind, its room and its distance on foot, in four orders. Functions of the context for the app thread. Call them only
// after the rooms have been found. Building the table costs as much as the list of things to find.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/core/wayfinding/stops.h"

namespace handrail::core {

enum class PlaceKind : std::uint8_t { Room, Door, Landmark, Clue, Thing, Mark };
enum class PlaceOrder : std::uint8_t { Distance, Name, Room, Kind };
inline constexpr std::size_t kPlaceOrders = 4;

struct PlaceRow {
    std::string name;
    PlaceKind kind = PlaceKind::Thing;
    std::string room;                                 // empty for a room, and for a place in no known room
    double far_m = 0.0;                               // on foot if a route is known, else straight
    Goal goal;                                        // for a room, only the name and the middle
    std::uint32_t room_index = navigation::kNothing;  // set if the place is a room
};

// Returns all places in this order. Places that are equal in it are ordered by distance.
std::vector<PlaceRow> place_table(const SessionContext& context, const Rooms& rooms, PlaceOrder order);

// Returns one line of the table: "Sofa: thing, Living room, 9 steps."
std::string place_line(const SessionContext& context, const PlaceRow& row);

// Opens the places as a list, the nearest first. A typed "by name", "by room", "by kind" or "by distance" chooses
// nothing: it gives the whole table in that order instead, one announcement for each place. `chosen` gets the place
// that the person chooses.
void open_places(const SessionContext& context, const Rooms& rooms,
                 std::function<void(const PlaceRow& row, double now_s)> chosen, double now_s);

}  // namespace handrail::core
