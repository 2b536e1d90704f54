// Defines a building as a drawn plan states it: spaces with outlines on levels, doors on those outlines, and the
// connections between levels. Readers of files (OpenStreetMap, IMDF, room descriptions) make a FloorPlan, and
// scene_of_plan turns it into a Scene. Plain values in metres, x east, y north.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/geometry/flat_parts.h"

namespace handrail::floorplan {

struct PlanLevel {
    double number = 0.0;  // number of the level as in the file; level 0 is at the ground
    std::string name;     // name for speech
    double floor_m = 0.0;
};

// A Room has walls on all sides. A Corridor or an Area has walls only where no other space adjoins it; Corridors and
// Areas that adjoin are open to each other.
enum class PlanSpaceKind : std::uint8_t { Room, Corridor, Area, Stairs, Escalator, Lift };

struct PlanSpace {
    PlanSpaceKind kind = PlanSpaceKind::Room;
    bool walled = true;               // the space has walls on all sides, like a room, whatever its kind
    std::string name;                 // name for speech; may be empty
    std::string number;               // number of the space, such as "A101"; may be empty
    std::string id;                   // identifier from the file, in the form that is reported to the person: "way 12"
    std::vector<Ring> rings;          // outline and holes by the even-odd rule
    std::vector<std::size_t> levels;  // rising indices into FloorPlan::levels; stairs and lifts connect these levels
    std::vector<std::string> facts;   // sentences about the space, in the spoken language
    std::optional<double> height_m;   // from floor to ceiling; empty if the file does not state it
    // For a space on a single level: the height of its floor above the level; negative if it is below.
    double raised_m = 0.0;
    std::string floor_material;  // name in the material library; may be empty
    int line = 0;                // line of the file; 0: unknown
};

enum class PlanDoorKind : std::uint8_t { Hinged, Sliding, Revolving, Opening };

// The kind of a door that leads outside, in the order in which such doors become starting points.
enum class PlanEntrance : std::uint8_t { Main, Plain, Emergency };

struct PlanDoor {
    PlanDoorKind kind = PlanDoorKind::Hinged;
    Vec2 at{0.0};
    std::optional<Vec2> along;      // unit vector along the wall; empty if the file does not state it
    std::optional<double> width_m;  // width of the door; empty if the file does not state it
    std::string name, id;
    PlanEntrance entrance = PlanEntrance::Plain;
    bool by_itself = false;           // the door opens automatically when a person comes near
    bool guessed = false;             // Handrail made the door; the file has no door there
    std::vector<std::size_t> levels;  // the levels of the door, as rising indices into FloorPlan::levels
    // For each of these levels, the spaces that the door connects, as indices into FloorPlan::spaces. If this is empty,
    // the spaces are found on the two sides of the door.
    std::vector<std::vector<std::size_t>> spaces;
    int line = 0;
};

// A wall that is drawn separately and is not the outline of a space.
struct PlanWall {
    Vec2 from{0.0}, to{0.0};
    std::size_t level = 0;
};

enum class PlanThingKind : std::uint8_t { Object, Pillar, Guidance };

// An object in a space. Guidance is a tactile strip in the floor that people follow with their feet.
struct PlanThing {
    PlanThingKind kind = PlanThingKind::Object;
    std::string name;        // name for speech
    bool made_name = false;  // the name is one of Handrail's own, with a text under kind.NAME
    std::string message;
    std::vector<Ring> parts;  // convex outlines, counter-clockwise
    double height_m = 0.8;
    std::size_t level = 0;
    double from_m = 0.0;   // height of the lower edge above the floor
    bool window = false;   // the object is a pane on a wall
    bool fixture = false;  // the object is part of the building, not furniture
    bool landmark = false, clue = false;
    std::string material;  // material of the object: a name in the material library; may be empty
    int line = 0;
};

// A starting point. The first one is the base. If the plan has none, walks start outside the doors that lead outside.
struct PlanStart {
    Vec2 at{0.0};
    std::size_t level = 0;
    double heading_rad = 0.0;
    std::string name;
    int line = 0;
    double raised_m = 0.0;  // height above the floor of the level
};

// A lift platform without walls and doors that rises from one space to another, through the floors between them.
struct PlanLift {
    std::string name;
    Ring ring;                      // convex outline, counter-clockwise
    std::size_t from = 0, to = 0;   // the spaces that the lift connects, as indices into FloorPlan::spaces
    std::size_t low = 0, high = 0;  // the levels of these spaces, as indices into FloorPlan::levels
    int line = 0;
};

// Stairs that are not a space themselves and lead from one space to another, through the floors between them. They fill
// a rectangle.
struct PlanFlight {
    std::string name;
    Vec2 least{0.0}, most{0.0};
    Vec2 up{0.0, 1.0};  // unit vector along a side of the rectangle, in the climbing direction
    bool back = false;  // the stairs turn back at a landing, so that the second flight ends above the foot of the first
    std::size_t from = 0, to = 0;   // the spaces that the stairs connect, as indices into FloorPlan::spaces
    std::size_t low = 0, high = 0;  // the levels of these spaces, as indices into FloorPlan::levels
    int line = 0;
};

// A path that people walk along outside rooms. It has its own floor, which is level or slopes between levels.
struct PlanWay {
    std::string name, id;
    bool steps = false, escalator = false;
    bool area = false;            // the way is a level area whose outline is `line`
    Ring line;                    // points in order; ways that share a point lead into each other
    std::vector<Ring> further;    // further outlines of an area; the even-odd rule applies to all outlines together
    std::vector<double> floor_m;  // height of the floor at each point of `line`
    double width_m = 2.0;
    std::vector<std::string> facts;
};

// Returns all outlines of an area.
inline std::vector<Ring> rings_of_way(const PlanWay& way) {
    std::vector<Ring> rings{way.line};
    rings.insert(rings.end(), way.further.begin(), way.further.end());
    return rings;
}

// Another building, or a part of one that is above the ground. It becomes a single solid.
struct PlanBlock {
    std::string name;
    std::vector<Ring> rings;
    double from_m = 0.0, to_m = 3.0;
};

struct FloorPlan {
    std::string name;    // name of the building; may be empty
    std::string format;  // name of the format, for ReadReport::format
    std::string schema;  // version of the file's format, in the form that is reported to the person
    double storey_m = 3.0;
    double wall_m = 0.12;           // thickness of walls; half of it is on each side of an outline
    bool measures_known = false;    // the file states the heights of storeys and the thickness of walls
    std::string wall_material;      // name in the material library; may be empty
    std::vector<PlanLevel> levels;  // ordered from the lowest up
    std::vector<PlanSpace> spaces;
    std::vector<PlanDoor> doors;
    std::vector<PlanWall> walls;
    std::vector<PlanThing> things;
    std::vector<PlanLift> lifts;
    std::vector<PlanFlight> flights;
    std::vector<PlanWay> ways;
    std::vector<PlanBlock> blocks;
    std::vector<PlanStart> starts;
    // Sentences for the report about what was guessed, simplified and left out.
    std::vector<std::string> guessed, simplified, left_out;
    // Warnings, each with the fault and the action that was taken.
    std::vector<std::pair<std::string, std::string>> warnings;
};

}  // namespace handrail::floorplan
