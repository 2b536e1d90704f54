// Finds faults of a world, for people who make or prepare it, in the scene and in the rooms and routes found in it.
// Each fault has a place, the line of the file and an advice. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/check/way_lacks.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail::check {

// Ordered by gravity: first what stops or endangers a walker, then what misleads, then what is missing.
enum class FaultKind : std::uint8_t {
    NowhereToStand,    // there is no floor at all
    StartLost,         // nobody can stand at a start
    RoomOutOfReach,    // no walking route from the base leads there
    ImpassableDoor,    // nobody fits through, or it cannot open
    MissingPart,       // has a form in the file, but is missing here in whole or in part
    DoorOnNoWall,      // not in a wall
    DoorOverLevels,    // reaches over the floors of two storeys
    FloorEnds,         // an edge with nothing below and nothing to hold on to
    UnguardedDrop,     // an edge higher than a walker is led down
    CrossingOutline,   // the outline of a room, as the file states it, crosses itself
    OverlappingRooms,  // two rooms at one place
    OpenToOutside,     // a way from a covered room into the open without a door
    OpenRoof,          // a part of a covered room is under the sky
    Crack,             // two walls or floors that nearly touch
    DoorToNoRoom,      // no room of the file is on either side
    UnlikeFile,        // the file joins two rooms there, but nobody can walk from one to the other
    StairsInOneGo,     // stairs that nobody can walk on, so they are climbed in one go
    OddName,           // the room contains stairs, but its name does not say so
    DoorCutFree,       // something in the doorway was cut away
    AlikeMaterials,    // a hand cannot tell them apart
    ThingOutside,      // far from everything that can be reached
    ThingTwice,        // two things at exactly the same place
    ThingBuried,       // under a floor or within a wall
    ThingInTheAir,     // touches nothing
    DamagedInFile,     // the reader found damage and went on
    UnnamedRoom,
    NoLandmark,  // the room has no thing that is fixed and the only one of its kind
};

struct FaultRow {
    FaultKind kind;
    std::string_view word;  // its name in files and in the keys of its texts: "room_out_of_reach"
    bool blocks;            // true if it would stop, hurt or mislead a person who learns this world
};
const FaultRow& row_of(FaultKind kind);
std::vector<FaultKind> all_fault_kinds();

struct WorldFault {
    FaultKind kind = FaultKind::UnnamedRoom;
    // World metres; for places to walk, on the floor. For a room out of reach and for stairs: where the route lacks
    // something.
    Vec3 at_m{0.0};
    SourcePlace source = {};         // 0: unknown
    FeatureId feature = kNoFeature;  // the door or thing
    std::uint32_t room =
        navigation::kNothing;           // index in the graph of the room that it concerns or is in; kNothing: none
    std::string name = {}, other = {};  // spoken names of what it concerns: the room or thing, and a second one
    std::string why = {};               // for an impassable door that was tested: the reason, as part of a sentence
    double amount = 0.0;        // metres: the width of a crack or door, the height of a drop, or what the route has
    Lack lack = Lack::Nothing;  // what the route to a room out of reach, or over stairs, lacks
    double needed_m = 0.0;      // what the route would need
    std::vector<FeatureId> candidates = {};  // things that could be a landmark, the best first; at most 3
};

// `space` and `graph` belong to the world; null if nobody can stand in it. Returns the gravest faults first; those of
// one kind are in the order of rooms, doors and things. The time grows with the spans and with the pairs of adjacent
// solids.
std::vector<WorldFault> find_faults(const Scene& scene, const navigation::WalkSpace* space,
                                    const navigation::RoomGraph* graph);
// Why no walking route leads from the base to that room, as in find_faults; empty if there is a route. Makes up to four
// walkable spaces of the scene.
std::optional<WorldFault> why_out_of_reach(const Scene& scene, const navigation::WalkSpace& space,
                                           const navigation::RoomGraph& graph, std::uint32_t room,
                                           const std::stop_token& stop = {});
// False for faults of a line in the file, which have no place in the world.
inline bool has_place(const WorldFault& fault) {
    return fault.kind != FaultKind::DamagedInFile &&
           (fault.kind != FaultKind::AlikeMaterials || fault.feature != kNoFeature);
}
inline bool blocks(const WorldFault& fault) { return row_of(fault.kind).blocks; }

// "Room 5 cannot be reached on foot from the base."
std::string fault_words(const Scene& scene, const WorldFault& fault);
// What to do about it, in a sentence that names the candidates.
std::string fault_advice(const Scene& scene, const WorldFault& fault);

}  // namespace handrail::check
