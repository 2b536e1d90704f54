// Names that a person has given to rooms: how the side file stores them, and whether they still fit after the world was
// edited. Pure functions over plain values; app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

struct RoomNameGiven {
    std::string name;
    Vec3 at_m{0.0};        // a place on the floor of the room
    double area_m2 = 0.0;  // area of the room at that time; 0: unknown
    std::string world;     // checksum of the world's file at that time; empty: unknown
    bool fits = true;      // determined when the rooms are known, not stored
    SideEntry kept;        // keys of the file that this version does not know
};

// In an edited world, the room at that place counts as the same one if its area has changed by at most this factor, up
// or down.
inline constexpr double kSameRoomArea = 1.5;

// In the order of the file. Entries without a valid name or a place are left out but stay in the file; `faults`
// receives an error for each.
std::vector<RoomNameGiven> read_room_names(const SideFile& file, std::vector<Error>& faults);
void write_room_names(SideFile& file, const std::vector<RoomNameGiven>& names);

// Gives each name that still fits to the room at its place. In the same version of the world, a name fits if there is a
// room. In an edited one, the room must also be about as large as before. A room takes only the first of several names.
void lay_room_names(navigation::RoomGraph& graph, const navigation::WalkSpace& space, const SideFile& file,
                    std::vector<RoomNameGiven>& names);
// "This world has changed since you named rooms. 2 of 5 names no longer fit: Larder; Shop." Empty if all fit.
std::string unfit_sentence(const std::vector<RoomNameGiven>& names);

// Index in `names` of the name that this room has; kNothing: none.
std::uint32_t name_of_room(const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                           const std::vector<RoomNameGiven>& names, std::uint32_t room);

}  // namespace handrail::core
