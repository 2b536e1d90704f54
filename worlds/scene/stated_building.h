// Contains the statements of a file about its building: storeys, rooms with outlines, and doors with the rooms that
// they connect. Only readers of formats with rooms (such as IFC) fill it. For a .map or a mesh, worlds/navigation finds
// rooms by analysis. Plain values in world metres. A reader builds them; afterwards they never change.
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
    std::string name;  // for speech, as the file states it: "Level 1"
    double floor_m = 0.0;
    int rooms = 0;  // number of rooms on the storey
};

struct StatedRoom {
    std::string name;    // for speech: the long name, else the number
    std::string number;  // number of the room, such as "A101"; may be empty
    std::string guid;    // identifier, as the file states it
    std::string part;    // for speech: the wing or other part of the building that the room is in; may be empty
    std::uint32_t storey = kNotStated;
    // Outline and holes by the even-odd rule; at least one ring, each with at least 3 points.
    std::vector<std::vector<Vec2>> rings;
    double floor_m = 0.0, height_m = 0.0;
    Vec3 at_m{0.0};  // on the floor of the room, within the outline
    double area_m2 = 0.0;
    bool holds_stairs = false;  // stairs occupy more than half of the room
    bool is_way = false;        // true for a footway, street or platform that is not in a room
    SourcePlace source;
};

enum class StatedPortalKind : std::uint8_t { Door, Opening, Stairs, Ramp, Lift };

struct StatedPortal {
    StatedPortalKind kind = StatedPortalKind::Door;
    std::string name;  // identifier, as the file states it
    std::string guid;
    FeatureId feature = kNoFeature;  // for a door: its first leaf; for stairs and lifts: the feature that is touched
    // The rooms that the portal connects, as rising indices into StatedBuilding::rooms. If there is only one room, the
    // other side is outside or has no name.
    std::vector<std::uint32_t> rooms;
    Vec3 place_m{0.0};  // the middle of the portal, at floor height
    double width_m = 0.0, height_m = 0.0;
    // True: the file states which rooms the portal connects; false: they were found on its two sides.
    bool by_boundaries = false;
    bool outside = false;        // the only room of the portal is open to the ground outside
    bool opened_by_box = false;  // a walker did not fit through the file's geometry, so a box was cut out of it
    bool passable = true;        // a walker can go through in both directions
    std::string why;         // if not passable and the reason is known: the key of the text about it, "door_trial.step"
    std::string in_the_way;  // names of the parts in the way, for the text `why`
    double step_m = 0.0;     // height of the step, for the text `why`
    SourcePlace source;
};

// A part that has a shape in the file, but is missing here or has another volume.
struct MissingPart {
    std::string name, guid, storey;  // as the file states them; may be empty
    std::string reason;              // the key of the text about the reason: "ifc.lost_unread"
    std::string detail;              // a value for the text `reason`: the IFC class that Handrail does not read
    double share = 0.0;              // the share of the part's volume that is missing
    Vec3 at_m{0.0};                  // position of the part, as the file states it
    SourcePlace source;
};

// A window or a piece of furniture. The list has one entry for each that the file contains.
struct StatedThing {
    FeatureId feature = kNoFeature;  // the feature of the whole thing, if this is only a part of it
    Aabb bounds_m;                   // empty if the file gives the thing no shape
};

struct StatedBuilding {
    std::string schema;                             // the version of the format: "IFC2X3"
    std::vector<StatedStorey> storeys;              // storeys, ordered from the lowest up
    std::vector<StatedRoom> rooms;                  // rooms in file order
    std::vector<StatedPortal> portals;              // doors, openings, stairs and other portals in file order
    std::vector<MissingPart> missing;               // missing parts in file order
    double wall_m = 0.0;                            // thickness of the walls if all are alike; 0: unknown
    std::vector<StatedThing> windows, furnishings;  // things in file order
    int openings = 0, openings_cut = 0, stairs = 0, ramps = 0, lifts = 0, escalators = 0, walkways = 0, skipped = 0;
};

// True if the place is within the outline and within the room's height: from a step below its floor to a step below its
// ceiling.
bool holds(const StatedRoom& room, const Vec3& at_m);
// Returns the sides of the smallest rectangle around the outline that is parallel to one of the outline's edges. The
// first side is the one that runs more from west to east.
Vec2 outline_size_m(const StatedRoom& room);
// True if stairs occupy most of the room but its name does not mention stairs, in English or German.
bool is_oddly_named(const StatedRoom& room);
// Returns the file's name for the storey whose floor is at this height, in one line. Empty if there is none.
std::string stated_storey_name(const StatedBuilding& building, double floor_m);
// Like stated_storey_name, but for a height between two storeys it returns the name of the lower one. Empty if no
// storey has rooms.
std::string stated_storey_around(const StatedBuilding& building, double floor_m);
// Returns the number of rooms in the largest group that portals, or the ground outside, connect.
int largest_connected(const StatedBuilding& building);

}  // namespace handrail
