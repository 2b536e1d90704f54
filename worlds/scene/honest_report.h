// What was understood of a building whose file states rooms and doors itself, and what is to be checked before anybody
// trusts it: the same for speech, terminal and JSON. Pure functions over a Scene; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"

namespace handrail {

// The gravest first: what cannot be walked, then what is told wrongly, then what may be so in the building itself.
enum class ToCheck : std::uint8_t {
    MissingPart,      // it has a form in the file, and not here, or not all of it
    ImpassableDoor,   // no body came through, even after cutting
    DoorToNoRoom,     // the file's rooms lie on neither side of it
    OddName,          // the room holds stairs and its name does not say so
    RoomWithoutName,  // neither name nor number
    DoorCutFree,      // something stood in it
    RoomWithoutWay,   // no door or stairs of the file lead to it; it may lie open to the room beside it
};

struct CheckPoint {
    ToCheck what = ToCheck::OddName;
    std::uint32_t index = 0;  // of StatedBuilding::rooms, portals or missing, as `what` says
    Vec3 at_m{0.0};           // on the floor, world metres
    SourcePlace source;
};
bool is_of_a_room(ToCheck what);
// "odd_name", for files.
std::string_view word_of(ToCheck what);

struct HonestReport {
    // Understood.
    int storeys = 0, storeys_with_rooms = 0, rooms = 0, doors = 0, windows = 0, openings = 0;
    int stairs = 0, ramps = 0, lifts = 0, escalators = 0, walkways = 0, furnishings = 0;
    int doors_of_two_rooms = 0, doors_of_one_room = 0, doors_of_no_room = 0;
    int largest_connected = 0;  // rooms of the largest group joined by doors, openings and stairs
    int landmarks = 0;          // things that the file marks so
    // Not, or not quite.
    int parts_missing = 0;                          // or with another volume than in the file
    int openings_uncut = 0;                         // stay wall
    int doors_cut_free = 0;                         // something in the way was cut away
    int doors_impassable = 0;                       // and these could not be
    int guessed = 0, simplified = 0, left_out = 0;  // kinds of each, as the sentences of ReadReport
    int problems = 0;                               // warnings met while reading
    std::vector<CheckPoint> check;                  // the gravest first, then in file order
};

// scene.stated must be there.
HonestReport honest_report(const Scene& scene);

// "21 rooms on 2 of 4 storeys, 14 doors, ... Check first: ...".
std::string honest_sentence(const Scene& scene, const HonestReport& report);
// What the doors join, openings, the largest connected part, landmarks, each storey; a sentence each.
std::vector<std::string> honest_details(const Scene& scene, const HonestReport& report);
// How much was guessed, made simpler, left out and found wrong while reading any file; where each is told.
std::string honest_counts(const ReadReport& report);
// "North wall, 2O2Fr$t4X7Zf8NOew3FLOH, on Level 1, is not there: Handrail does not read IFCSWEPTDISKSOLID"; no stop at
// the end.
std::string missing_words(const MissingPart& part);
// Why nobody passes a door: "in its way stands Lining"; empty where that is not known.
std::string door_trial_words(const StatedPortal& portal);
// "Room B105 holds stairs, and its name does not say so"; no stop at the end.
std::string check_words(const Scene& scene, const CheckPoint& point);

}  // namespace handrail
