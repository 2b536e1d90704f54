// Makes a report on a building whose file states rooms and doors. It lists what Handrail understood, and what must be
// checked before anybody relies on it. Speech, terminal and JSON all use it. Pure functions over a Scene; any thread
// may call them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"

namespace handrail {

// Ordered by severity: first faults that stop a walker, then faults that make announcements wrong, then oddities that
// may exist in the building itself.
enum class ToCheck : std::uint8_t {
    MissingPart,       // a part has a shape in the file, but is missing here in whole or in part
    ImpassableDoor,    // a door that a walker could not pass even after obstacles were cut away
    DoorToNoRoom,      // a door with no room of the file on either side
    OddName,           // a room that contains stairs, although its name does not say so
    RoomWithoutName,   // a room with neither a name nor a number
    DoorCutFree,       // a doorway from which an obstacle was cut away
    RoomWithoutRoute,  // a room that no door or stairs of the file lead to; it may be open to the room next to it
};

struct CheckPoint {
    ToCheck what = ToCheck::OddName;
    std::uint32_t index = 0;  // index into StatedBuilding::rooms, portals or missing, depending on `what`
    Vec3 at_m{0.0};           // on the floor, in world metres
    SourcePlace source;
};
bool is_of_a_room(ToCheck what);
// Returns the name used in files, such as "odd_name".
std::string_view word_of(ToCheck what);

struct HonestReport {
    // The numbers of what Handrail understood.
    int storeys = 0, storeys_with_rooms = 0, rooms = 0, doors = 0, windows = 0, openings = 0;
    int stairs = 0, ramps = 0, lifts = 0, escalators = 0, walkways = 0, furnishings = 0;
    int doors_of_two_rooms = 0, doors_of_one_room = 0, doors_of_no_room = 0;
    int largest_connected = 0;  // number of rooms in the largest group that doors, openings and stairs connect
    int landmarks = 0;          // number of things that the file marks as landmarks
    // The numbers of what Handrail did not understand, or only in part.
    int parts_missing = 0;     // number of parts that are missing or have another volume than in the file
    int openings_uncut = 0;    // number of openings that could not be cut and so remain solid wall
    int doors_cut_free = 0;    // number of doors that were blocked until an obstacle was cut away
    int doors_impassable = 0;  // number of doors that remained blocked
    int guessed = 0, simplified = 0, left_out = 0;  // numbers of entries in the lists of ReadReport with these names
    int problems = 0;                               // number of warnings while reading
    std::vector<CheckPoint> check;  // what to check, most severe first; findings of one kind are in file order
};

// Makes the report. Requires scene.stated.
HonestReport honest_report(const Scene& scene);

// Returns the summary: "21 rooms on 2 of 4 storeys, 14 doors, ... Check first: ...".
std::string honest_sentence(const Scene& scene, const HonestReport& report);
// Returns one sentence each about the rooms that doors connect, the openings, the largest connected part, the landmarks
// and each storey.
std::vector<std::string> honest_details(const Scene& scene, const HonestReport& report);
// Returns the numbers of guessed, simplified, left out and faulty items in a file of any format, and where to find the
// details.
std::string honest_counts(const ReadReport& report);
// Describes a missing part, without a full stop: "North wall, 2O2Fr$t4X7Zf8NOew3FLOH, on Level 1, is not there:
// Handrail does not read IFCSWEPTDISKSOLID".
std::string missing_words(const MissingPart& part);
// Returns the reason why nobody can walk through a door: "in its way stands Lining". Empty if the reason is unknown.
std::string door_trial_words(const StatedPortal& portal);
// Describes a finding, without a full stop: "Room B105 holds stairs, and its name does not say so".
std::string check_words(const Scene& scene, const CheckPoint& point);

}  // namespace handrail
