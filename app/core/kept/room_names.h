// Names that a person has given to rooms: how they are kept in the side file, and whether they still fit a world that
// was edited since. Pure functions over plain values; app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/navigation/rooms.h"

namespace handrail {

struct RoomNameGiven {
    std::string name;
    Vec3 at_m{0.0};        // a place in the room, where soles stand
    double area_m2 = 0.0;  // of the room then; 0: unknown
    std::string world;     // checksum of the world's file then; empty: unknown
    bool fits = true;      // found out when the rooms are known, not kept
    SideEntry kept;        // keys of the file that this version does not know
};

// In a world that was edited, a room of that place counts as the same one up to so many times the area, or that part of
// it.
inline constexpr double kSameRoomArea = 1.5;

// In the order of the file. Entries without a good name or a place are left out and stay in the file; `faults` tells of
// each.
std::vector<RoomNameGiven> read_room_names(const SideFile& file, std::vector<Error>& faults);
void write_room_names(SideFile& file, const std::vector<RoomNameGiven>& names);

// Gives each name that still fits to the room around its place. Those of this very world always fit; of an edited one
// those whose room is there, is about as large as it was and has no earlier name of the list.
void lay_room_names(RoomGraph& graph, const WalkSpace& space, const SideFile& file, std::vector<RoomNameGiven>& names);
// "This world has changed since you named rooms. 2 of 5 names no longer fit: Larder; Shop." Empty when all fit.
std::string unfit_sentence(const std::vector<RoomNameGiven>& names);

// The place in `names` of the one that room has; kNothing: none.
std::uint32_t name_of_room(const RoomGraph& graph, const WalkSpace& space, const std::vector<RoomNameGiven>& names,
                           std::uint32_t room);

}  // namespace handrail
