// Finds faults of a world, for people who make or prepare it. It searches the scene, and the rooms and routes that were
// found in the scene. Each fault has a place, a line in the file and advice. Pure functions; any thread may call them.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/check/route_lacks.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/scene.h"

namespace handrail::check {

// Ordered by severity: first faults that stop or endanger a walker, then those that mislead, then missing landmarks.
enum class FaultKind : std::uint8_t {
    NowhereToStand,    // the world has no floor
    StartLost,         // nobody can stand at this start
    RoomOutOfReach,    // no walking route leads from the base to the room
    ImpassableDoor,    // a door that nobody fits through, or that cannot open
    MissingPart,       // a part has a shape in the file, but is missing here in whole or in part
    DoorOnNoWall,      // a door that is not in a wall
    DoorOverLevels,    // a door that extends across the floors of two storeys
    FloorEnds,         // an edge of the floor with neither a floor below nor a railing
    UnguardedDrop,     // an edge that is too high for routes to lead a walker down
    CrossingOutline,   // the outline that the file states for a room crosses itself
    OverlappingRooms,  // two rooms in the same place
    OpenToOutside,     // an opening without a door from a covered room into the open
    OpenRoof,          // a part of a covered room has no roof
    Crack,             // a gap between two walls or floors that nearly touch
    DoorToNoRoom,      // a door with no room of the file on either side
    UnlikeFile,        // the file connects two rooms here, but nobody can walk from one to the other
    StairsInOneGo,   // stairs on which nobody can walk step by step, so that a single movement leads from foot to head
    OddName,         // a room that contains stairs, although its name does not say so
    DoorCutFree,     // a doorway from which an obstacle was cut away
    AlikeMaterials,  // materials that a hand cannot distinguish
    ThingOutside,    // a thing that is far from every place that a person can reach
    ThingTwice,      // two equal things in exactly the same place
    ThingBuried,     // a thing below a floor or within a wall
    ThingInTheAir,   // a thing that touches nothing
    DamagedInFile,   // the reader found damage in the file and continued
    UnnamedRoom,
    NoLandmark,  // a room without any thing that is fixed and the only one of its kind
};

struct FaultRow {
    FaultKind kind;
    std::string_view word;  // name in files and in the keys of texts: "room_out_of_reach"
    bool blocks;            // true if the fault would stop, hurt or mislead a person who learns this world
};
const FaultRow& row_of(FaultKind kind);

struct WorldFault {
    FaultKind kind = FaultKind::UnnamedRoom;
    // Place of the fault in world metres. If people walk there, the place is on the floor. For stairs and for a room
    // out of reach, it is where the route is too low or too narrow, or has too high a step.
    Vec3 at_m{0.0};
    SourcePlace source = {};         // place of the fault in the file; line 0: unknown
    FeatureId feature = kNoFeature;  // the door or thing with the fault
    // Index in the graph of the room with the fault, or of the room that it is in; kNothing: none.
    std::uint32_t room = navigation::kNothing;
    // Spoken names for the sentence: the room or thing, and a second one if the sentence needs it.
    std::string name = {}, other = {};
    std::string why = {};  // for an impassable door that was tested: the reason, as a part of a sentence
    // Metres: the width of a crack or door, the height of a drop, or the size that the passage on the route has.
    double amount = 0.0;
    Lack lack = Lack::Nothing;  // what a route over these stairs, or to this room out of reach, lacks
    double needed_m = 0.0;      // the size in metres that the passage would need
    // For a room without a landmark: things that could be one, the best first; at most 3.
    std::vector<FeatureId> candidates = {};
};

// Returns the most severe faults first. Faults of one kind are in the order of rooms, doors and things. `space` and
// `graph` must belong to the world; they are null if nobody can stand in it. The time grows with the number of spans
// and with the number of pairs of adjacent solids.
std::vector<WorldFault> find_faults(const Scene& scene, const navigation::WalkSpace* space,
                                    const navigation::RoomGraph* graph);
// Returns a fault that explains why no walking route leads from the base to that room. Empty if there is a route. Makes
// up to four walkable spaces of the scene.
std::optional<WorldFault> why_out_of_reach(const Scene& scene, const navigation::WalkSpace& space,
                                           const navigation::RoomGraph& graph, std::uint32_t room,
                                           const std::stop_token& stop = {});
// True if the fault has a place in the world. False for faults that concern a line of the file.
inline bool has_place(const WorldFault& fault) {
    return fault.kind != FaultKind::DamagedInFile &&
           (fault.kind != FaultKind::AlikeMaterials || fault.feature != kNoFeature);
}
inline bool blocks(const WorldFault& fault) { return row_of(fault.kind).blocks; }

// Returns the fault as a sentence: "Room 5 cannot be reached on foot from the base."
std::string fault_words(const Scene& scene, const WorldFault& fault);
// Returns a sentence with advice on how to mend the fault. It names the candidates if there are any.
std::string fault_advice(const Scene& scene, const WorldFault& fault);

}  // namespace handrail::check
