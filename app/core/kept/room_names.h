// Stores the names that a person has given to rooms, and checks whether they still fit after the world was edited. Pure
// functions over plain values, for the app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

struct RoomNameGiven {
    std::string name;
    Vec3 at_m{0.0};        // a place on the floor of the room
    double area_m2 = 0.0;  // area of the room when it was named; 0: not known
    std::string world;     // checksum of the world's file when the room was named; empty: not known
    bool fits = true;      // true: the room still exists; this is computed when the rooms are known, and not stored
    SideEntry kept;        // keys of the side file that this version does not know
};

// In an edited world, the room at the stored place is taken for the named room if its area has grown or shrunk by at
// most this factor.
inline constexpr double kSameRoomArea = 1.5;

// Returns the names in the order of the side file. Entries without a valid name or a place stay in the file but are not
// returned. `faults` receives an error for each of them.
std::vector<RoomNameGiven> read_room_names(const SideFile& file, std::vector<Error>& faults);
void write_room_names(SideFile& file, const std::vector<RoomNameGiven>& names);

// Gives each name that still fits to the room at its place. In the same version of the world, a name fits if there is a
// room at its place. In an edited world, that room must also have about the same area as before. If several names fit a
// room, the room gets the first.
void lay_room_names(navigation::RoomGraph& graph, const navigation::WalkSpace& space, const SideFile& file,
                    std::vector<RoomNameGiven>& names);
// Returns "This world has changed since you named rooms. 2 of 5 names no longer fit: Larder; Shop.", or an empty text
// if all names fit.
std::string unfit_sentence(const std::vector<RoomNameGiven>& names);

// Returns the index in `names` of the name that this room has, or kNothing.
std::uint32_t name_of_room(const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                           const std::vector<RoomNameGiven>& names, std::uint32_t room);

}  // namespace handrail::core
