// What is wrong with a world, for those who make or prepare it: found by looking at the scene and at the rooms and ways
// found in it. Each fault has a place, the line of the file and what to do. Pure functions; any thread.
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

namespace handrail {

// The gravest first: what stops or endangers somebody who walks, then what misleads, then what is missing.
enum class FaultKind : std::uint8_t {
    NowhereToStand,    // no floor at all
    StartLost,         // nobody can stand where a start is
    RoomOutOfReach,    // no way on foot from the base
    ImpassableDoor,    // no body gets through, or it cannot open
    MissingPart,       // it has a form in the file, and not here, or not all of it
    DoorOnNoWall,      // stands free
    DoorOverLevels,    // reaches over the floors of two storeys
    FloorEnds,         // with nothing below and nothing to stop at
    UnguardedDrop,     // higher than a body is led down
    CrossingOutline,   // the outline of a room, as the file states it, crosses itself
    OverlappingRooms,  // two rooms in one place
    OpenToOutside,     // from a covered room one comes under the sky where there is no door
    OpenRoof,          // a part of a covered room lies under the sky
    Crack,             // two walls or floors that nearly touch
    DoorToNoRoom,      // the file's rooms lie on neither side of it
    UnlikeFile,        // the file joins two rooms there, and nobody walks from one to the other
    StairsInOneGo,     // nobody walks on them, so they are taken in one go
    OddName,           // the room holds stairs and its name does not say so
    DoorCutFree,       // something stood in it
    AlikeMaterials,    // a hand cannot tell them apart
    ThingOutside,      // far from all that can be reached
    ThingTwice,        // two things in the very same place
    ThingBuried,       // under a floor or within a wall
    ThingInTheAir,     // touches nothing
    DamagedInFile,     // the reader met it and went on
    UnnamedRoom,
    NoLandmark,  // a room without a thing that is fixed and the only one of its kind
};

struct FaultRow {
    FaultKind kind;
    std::string_view word;  // for files, and the key of its texts: "room_out_of_reach"
    bool blocks;            // somebody who learns here would be stopped, hurt or led astray
};
const FaultRow& row_of(FaultKind kind);
std::vector<FaultKind> all_fault_kinds();

struct WorldFault {
    FaultKind kind = FaultKind::UnnamedRoom;
    Vec3 at_m{0.0};                          // world metres; on the floor where it concerns a place to walk; of a room
                                             // out of reach, and of stairs, where the way lacks something
    SourcePlace source = {};                 // 0: unknown
    FeatureId feature = kNoFeature;          // the door or thing
    std::uint32_t room = kNothing;           // of the graph, where it concerns one or lies in one
    std::string name = {}, other = {};       // what it concerns, as it is spoken: the room, the thing; and a second
    std::string why = {};                    // of an impassable door, where a body tried it; fit for a sentence
    double amount = 0.0;                     // metres: of a crack, a drop, a door's width, what a way has
    Lack lack = Lack::Nothing;               // of the way to a room out of reach, or over stairs
    double needed_m = 0.0;                   // what it would have to have
    std::vector<FeatureId> candidates = {};  // for a landmark, the best first; at most 3
};

// `space` and `graph` are those of the world; null where nobody can stand in it. The gravest first, those of a kind in
// the order of rooms, doors and things. Goes with the spans and with the pairs of solids that lie side by side.
std::vector<WorldFault> find_faults(const Scene& scene, const WalkSpace* space, const RoomGraph* graph);
// Why nobody comes to that room from the base, as find_faults tells it; nothing: one comes there. Makes up to four
// spaces of the scene.
std::optional<WorldFault> why_out_of_reach(const Scene& scene, const WalkSpace& space, const RoomGraph& graph,
                                           std::uint32_t room, const std::stop_token& stop = {});
// False for what concerns a line of the file rather than a place in the world.
inline bool has_place(const WorldFault& fault) {
    return fault.kind != FaultKind::DamagedInFile &&
           (fault.kind != FaultKind::AlikeMaterials || fault.feature != kNoFeature);
}
inline bool blocks(const WorldFault& fault) { return row_of(fault.kind).blocks; }

// "Room 5 cannot be reached on foot from the base."
std::string fault_words(const Scene& scene, const WorldFault& fault);
// What to do about it, in a sentence; candidates by name.
std::string fault_advice(const Scene& scene, const WorldFault& fault);

}  // namespace handrail
