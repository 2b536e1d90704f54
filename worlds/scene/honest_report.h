// A report on a building whose file states rooms and doors: what Handrail understood, and what must be checked before
// anybody trusts it. Speech, terminal and JSON all use it. Pure functions over a Scene; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"

namespace handrail {

// Ordered by gravity: first what cannot be walked, then what is announced wrongly, then what may be so in the building
// itself.
enum class ToCheck : std::uint8_t {
    MissingPart,      // has a form in the file, but is missing here in whole or in part
    ImpassableDoor,   // nobody could walk through, even after it was cut free
    DoorToNoRoom,     // no room of the file is on either side
    OddName,          // the room contains stairs, but its name does not say so
    RoomWithoutName,  // neither name nor number
    DoorCutFree,      // something in the doorway was cut away
    RoomWithoutWay,   // no door or stairs of the file lead to it; it may be open to the room next to it
};

struct CheckPoint {
    ToCheck what = ToCheck::OddName;
    std::uint32_t index = 0;  // index into StatedBuilding::rooms, portals or missing, depending on `what`
    Vec3 at_m{0.0};           // on the floor, world metres
    SourcePlace source;
};
bool is_of_a_room(ToCheck what);
// The name for files: "odd_name".
std::string_view word_of(ToCheck what);

struct HonestReport {
    // What was understood.
    int storeys = 0, storeys_with_rooms = 0, rooms = 0, doors = 0, windows = 0, openings = 0;
    int stairs = 0, ramps = 0, lifts = 0, escalators = 0, walkways = 0, furnishings = 0;
    int doors_of_two_rooms = 0, doors_of_one_room = 0, doors_of_no_room = 0;
    int largest_connected = 0;  // number of rooms in the largest group joined by doors, openings and stairs
    int landmarks = 0;          // things that the file marks as landmarks
    // What was not understood, or only in part.
    int parts_missing = 0;                          // missing, or with another volume than in the file
    int openings_uncut = 0;                         // they stay wall
    int doors_cut_free = 0;                         // doors that something blocked until it was cut away
    int doors_impassable = 0;                       // doors that could not be cut free
    int guessed = 0, simplified = 0, left_out = 0;  // numbers of kinds, as in the sentences of ReadReport
    int problems = 0;                               // warnings met while reading
    std::vector<CheckPoint> check;                  // the gravest first; within one kind in file order
};

// Requires scene.stated.
HonestReport honest_report(const Scene& scene);

// "21 rooms on 2 of 4 storeys, 14 doors, ... Check first: ...".
std::string honest_sentence(const Scene& scene, const HonestReport& report);
// What the doors join, the openings, the largest connected part, the landmarks and each storey: one sentence each.
std::vector<std::string> honest_details(const Scene& scene, const HonestReport& report);
// How much was guessed, simplified, left out and found wrong while reading any file, and where the details are.
std::string honest_counts(const ReadReport& report);
// "North wall, 2O2Fr$t4X7Zf8NOew3FLOH, on Level 1, is not there: Handrail does not read IFCSWEPTDISKSOLID"; without a
// full stop.
std::string missing_words(const MissingPart& part);
// Why nobody can walk through a door: "in its way stands Lining"; empty if unknown.
std::string door_trial_words(const StatedPortal& portal);
// "Room B105 holds stairs, and its name does not say so"; without a full stop.
std::string check_words(const Scene& scene, const CheckPoint& point);

}  // namespace handrail
