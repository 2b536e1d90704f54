// What a file itself states about its building: storeys, rooms with outlines, and doors with the rooms that they join.
// Only formats with rooms fill it (such as IFC); for a .map or a mesh, worlds/navigation finds rooms by analysis. Plain
// values, built by a reader, then never changed. World metres.
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
    std::string name;  // can be spoken, as the file states it: "Level 1"
    double floor_m = 0.0;
    int rooms = 0;  // number of rooms on it
};

struct StatedRoom {
    std::string name;    // can be spoken: the long name, else the number
    std::string number;  // "A101"; may be empty
    std::string guid;    // as the file states it
    std::uint32_t storey = kNotStated;
    std::vector<std::vector<Vec2>> rings;  // outline and holes, by the even-odd rule; at least one ring of 3 points
    double floor_m = 0.0, height_m = 0.0;
    Vec3 at_m{0.0};  // on its floor, within the outline
    double area_m2 = 0.0;
    bool holds_stairs = false;  // stairs occupy more than half of it
    bool is_way = false;        // true for a footway, street or platform outside of rooms
    SourcePlace source;
};

enum class StatedPortalKind : std::uint8_t { Door, Opening, Stairs, Ramp, Lift };

struct StatedPortal {
    StatedPortalKind kind = StatedPortalKind::Door;
    std::string name;  // as the file states it
    std::string guid;
    FeatureId feature = kNoFeature;  // the first leaf of a door; for stairs and lifts the feature that is touched
    // Indices into StatedBuilding::rooms, rising; if there is only one, the other side is outside or has no name.
    std::vector<std::uint32_t> rooms;
    Vec3 place_m{0.0};  // middle, at floor height
    double width_m = 0.0, height_m = 0.0;
    bool by_boundaries = false;  // the file states the rooms; false: they were found on its two sides
    bool outside = false;        // its only room is open to the ground outside
    bool opened_by_box = false;  // a walker did not fit through the file's geometry, so a box was cut free
    bool passable = true;        // a walker can go through from both sides
    std::string why;             // if not passable and the reason is known: the key of its text, "door_trial.step"
    std::string in_the_way;      // names of parts, for that text
    double step_m = 0.0;         // for that text
    SourcePlace source;
};

// A part that has a form in the file, but is missing here or has another volume.
struct MissingPart {
    std::string name, guid, storey;  // as the file states them; may be empty
    std::string reason;              // the key of the text: "ifc.lost_unread"
    std::string detail;              // for the text: the IFC class that Handrail does not read
    double share = 0.0;              // of its volume, the share that is missing
    Vec3 at_m{0.0};                  // where the file places it
    SourcePlace source;
};

// A window or a piece of furniture, counted as in the file.
struct StatedThing {
    FeatureId feature = kNoFeature;  // the feature of the whole, if this is part of one
    Aabb bounds_m;                   // empty: the file gives it no form
};

struct StatedBuilding {
    std::string schema;                             // "IFC2X3"
    std::vector<StatedStorey> storeys;              // from the lowest up
    std::vector<StatedRoom> rooms;                  // in file order
    std::vector<StatedPortal> portals;              // in file order
    std::vector<MissingPart> missing;               // in file order
    double wall_m = 0.0;                            // thickness of its walls if all are alike; 0: unknown
    std::vector<StatedThing> windows, furnishings;  // in file order
    int openings = 0, openings_cut = 0, stairs = 0, ramps = 0, lifts = 0, escalators = 0, walkways = 0, skipped = 0;
};

// True if the place is within the outline, and between a step below the room's floor and a step below its ceiling.
bool holds(const StatedRoom& room, const Vec3& at_m);
// The sides of the least rectangle around the outline that is parallel to one of its edges. The first is the side that
// runs more from west to east.
Vec2 outline_size_m(const StatedRoom& room);
// True if stairs occupy most of the room but its name does not mention stairs, in English or German.
bool is_oddly_named(const StatedRoom& room);
// The file's name for the storey whose floor is at this height, in one line; empty if there is none.
std::string stated_storey_name(const StatedBuilding& building, double floor_m);
// Like stated_storey_name, but between two storeys it returns the name of the lower one. Empty if no storey has rooms.
std::string stated_storey_around(const StatedBuilding& building, double floor_m);
// The number of rooms in the largest group that portals, or the ground outside, join.
int largest_connected(const StatedBuilding& building);

}  // namespace handrail
