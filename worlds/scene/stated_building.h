// What a file itself says about its building: storeys, rooms with outlines, doors with the rooms they join. Only
// formats that know rooms fill it (IFC); what a .map or mesh leaves open is found by analysis (worlds/navigation).
// Plain values, built by a reader, then never changed. World metres.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"
#include "worlds/scene/source_place.h"

namespace handrail {

inline constexpr std::uint32_t kNotStated = 0xffffffffU;

struct StatedStorey {
    std::string name;  // fit to be spoken, as the file has it: "Level 1"
    double floor_m = 0.0;
    int rooms = 0;  // that lie on it
};

struct StatedRoom {
    std::string name;    // fit to be spoken: the long name, else the number
    std::string number;  // "A101"; may be empty
    std::string guid;    // of the file
    std::uint32_t storey = kNotStated;
    std::vector<std::vector<Vec2>> rings;  // outline and holes, by the even-odd rule; at least one ring of 3 points
    double floor_m = 0.0, height_m = 0.0;
    Vec3 at_m{0.0};  // on its floor, within the outline
    double area_m2 = 0.0;
    bool holds_stairs = false;  // stairs fill more than half of it
    bool is_way = false;        // a footway, a street or a platform outside rooms
    SourcePlace source;
};

enum class StatedPortalKind : std::uint8_t { Door, Opening, Stairs, Ramp, Lift };

struct StatedPortal {
    StatedPortalKind kind = StatedPortalKind::Door;
    std::string name;  // as the file has it
    std::string guid;
    FeatureId feature = kNoFeature;  // the first leaf of a door; stairs and lifts as they are felt
    std::vector<std::uint32_t>
        rooms;          // places in StatedBuilding::rooms, rising; one: the other side is outside or has no name
    Vec3 place_m{0.0};  // middle, at floor height
    double width_m = 0.0, height_m = 0.0;
    bool by_boundaries = false;  // the file states which rooms; else found by what lies on its two sides
    bool outside = false;        // its one room is open to the ground outside
    bool opened_by_box = false;  // a body did not pass through what the file gives, so a box was cut free
    bool passable = true;        // a body went through it from both sides
    std::string why;             // of one that is not, where known: the key of its text: "door_trial.step"
    std::string in_the_way;      // for its text: names of parts
    double step_m = 0.0;         // for its text
    SourcePlace source;
};

// A part that has a form in the file and stands here not at all, or with another volume.
struct MissingPart {
    std::string name, guid, storey;  // as the file has them; may be empty
    std::string reason;              // the key of its text: "ifc.lost_unread"
    std::string detail;              // for the text: a class that is not read
    double share = 0.0;              // of its volume that is missing
    Vec3 at_m{0.0};                  // of its placement
    SourcePlace source;
};

// A window or a piece of furniture, as the file counts it.
struct StatedThing {
    FeatureId feature = kNoFeature;  // that of the whole, if it is part of one
    Aabb bounds_m;                   // empty: the file gives it no form
};

struct StatedBuilding {
    std::string schema;                             // "IFC2X3"
    std::vector<StatedStorey> storeys;              // from the lowest up
    std::vector<StatedRoom> rooms;                  // in file order
    std::vector<StatedPortal> portals;              // in file order
    std::vector<MissingPart> missing;               // in file order
    double wall_m = 0.0;                            // how thick its walls are, where all are alike; 0: not known
    std::vector<StatedThing> windows, furnishings;  // in file order
    int openings = 0, openings_cut = 0, stairs = 0, ramps = 0, lifts = 0, escalators = 0, walkways = 0, skipped = 0;
};

// True when the place lies within the outline, and from a step below the room's floor to a step below its ceiling.
bool holds(const StatedRoom& room, const Vec3& at_m);
// Of the least rectangle round its outline that lies along one of its sides: first the side that runs more from west to
// east.
Vec2 outline_size_m(const StatedRoom& room);
// True when stairs all but fill the room and its name says nothing of stairs, in English or German.
bool is_oddly_named(const StatedRoom& room);
// What the file calls the storey with its floor at a height, in one line; empty if it names none there.
std::string stated_storey_name(const StatedBuilding& building, double floor_m);
// Like stated_storey_name, but between two storeys it returns the name of the lower one. Empty: no storey has rooms.
std::string stated_storey_around(const StatedBuilding& building, double floor_m);
// How many rooms the largest group has whose members are joined by portals, or by the ground outside.
int largest_connected(const StatedBuilding& building);

}  // namespace handrail
