// A building as a drawn plan states it: spaces with outlines on levels, doors on those outlines, and what connects the
// levels. This is the stage between a file (OpenStreetMap, IMDF) and the Scene. Plain values; metres, x east, y north.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/geometry/flat_parts.h"

namespace handrail::floorplan {

struct PlanLevel {
    double number = 0.0;  // as in the file: 0 is at the ground
    std::string name;     // can be spoken
    double floor_m = 0.0;
};

// A Room has walls all round. A Corridor or an Area has walls only where no other space adjoins; other Corridors and
// Areas are open to it.
enum class PlanSpaceKind : std::uint8_t { Room, Corridor, Area, Stairs, Escalator, Lift };

struct PlanSpace {
    PlanSpaceKind kind = PlanSpaceKind::Room;
    bool walled = true;               // walls all round like a room, whatever the kind
    std::string name;                 // can be spoken; may be empty
    std::string number;               // such as "A101"; may be empty
    std::string id;                   // from the file, as reported to the person: "way 12"
    std::vector<Ring> rings;          // by the even-odd rule
    std::vector<std::size_t> levels;  // indices in FloorPlan::levels, rising; stairs and lifts join them
    std::vector<std::string> facts;   // sentences about the space, in the language spoken
    std::optional<double> height_m;   // from floor to ceiling; nothing if the file does not state it
    // For a space on a single level: how far its floor is above that of the level; negative: below.
    double raised_m = 0.0;
    std::string floor_material;  // name in the material library; may be empty
    int line = 0;                // line of the file; 0: unknown
};

enum class PlanDoorKind : std::uint8_t { Hinged, Sliding, Revolving, Opening };

// Kind of a door that leads outside, in the order in which such doors become starts.
enum class PlanEntrance : std::uint8_t { Main, Plain, Emergency };

struct PlanDoor {
    PlanDoorKind kind = PlanDoorKind::Hinged;
    Vec2 at{0.0};
    std::optional<Vec2> along;      // unit vector along the wall, if the file states it
    std::optional<double> width_m;  // if the file states it
    std::string name, id;
    PlanEntrance entrance = PlanEntrance::Plain;
    bool by_itself = false;           // opens automatically when someone comes near
    bool guessed = false;             // made by Handrail; the file has no door there
    std::vector<std::size_t> levels;  // indices in FloorPlan::levels, rising
    // For each of its levels, the spaces that it joins, as indices in FloorPlan::spaces. Empty: they are found on its
    // two sides.
    std::vector<std::vector<std::size_t>> spaces;
    int line = 0;
};

// A wall that is drawn separately, not as the outline of a space.
struct PlanWall {
    Vec2 from{0.0}, to{0.0};
    std::size_t level = 0;
};

enum class PlanThingKind : std::uint8_t { Object, Pillar, Guidance };

// An object in a space or on its floor. Guidance is a tactile strip to follow with the feet.
struct PlanThing {
    PlanThingKind kind = PlanThingKind::Object;
    std::string name;        // can be spoken
    bool made_name = false;  // the name is one of Handrail's own (kind.NAME)
    std::string message;
    std::vector<Ring> parts;  // convex, counter-clockwise
    double height_m = 0.8;
    std::size_t level = 0;
    double from_m = 0.0;   // height of the lower edge above the floor
    bool window = false;   // a pane on a wall
    bool fixture = false;  // part of the building, not furniture
    bool landmark = false, clue = false;
    std::string material;  // name in the material library; may be empty
    int line = 0;
};

// A starting point; the first is the base. Without any, people start outside the doors that lead outside.
struct PlanStart {
    Vec2 at{0.0};
    std::size_t level = 0;
    double heading_rad = 0.0;
    std::string name;
    int line = 0;
    double raised_m = 0.0;  // above the floor of the level
};

// A lift platform without walls and doors that rises from one space to another, through the floors between.
struct PlanLift {
    std::string name;
    Ring ring;                      // convex, counter-clockwise
    std::size_t from = 0, to = 0;   // indices in FloorPlan::spaces
    std::size_t low = 0, high = 0;  // indices in FloorPlan::levels of those spaces
    int line = 0;
};

// Stairs without a room of their own, from one space to another through the floors between. They fill a rectangle.
struct PlanFlight {
    std::string name;
    Vec2 least{0.0}, most{0.0};
    Vec2 up{0.0, 1.0};              // unit vector along a side, in the climbing direction
    bool back = false;              // turns at a landing, and the second flight ends above the foot
    std::size_t from = 0, to = 0;   // indices in FloorPlan::spaces
    std::size_t low = 0, high = 0;  // indices in FloorPlan::levels of those spaces
    int line = 0;
};

// A way that people walk along outside rooms. It has its own floor, which is level or slopes between levels.
struct PlanWay {
    std::string name, id;
    bool steps = false, escalator = false;
    bool area = false;            // `line` is the outline of a level area
    Ring line;                    // points in order; ways that share a point lead into each other
    std::vector<Ring> further;    // further outlines of an area, by the even-odd rule
    std::vector<double> floor_m;  // height of each point
    double width_m = 2.0;
    std::vector<std::string> facts;
};

// All outlines of an area.
inline std::vector<Ring> rings_of_way(const PlanWay& way) {
    std::vector<Ring> rings{way.line};
    rings.insert(rings.end(), way.further.begin(), way.further.end());
    return rings;
}

// Another building, or a part of one that is above the ground, as one solid.
struct PlanBlock {
    std::string name;
    std::vector<Ring> rings;
    double from_m = 0.0, to_m = 3.0;
};

struct FloorPlan {
    std::string name;    // of the building; may be empty
    std::string format;  // for ReadReport::format
    std::string schema;  // of the file, as reported to the person
    double storey_m = 3.0;
    double wall_m = 0.12;           // thickness of walls, half on each side of an outline
    bool measures_known = false;    // the heights of storeys and thickness of walls come from the file
    std::string wall_material;      // name in the material library; may be empty
    std::vector<PlanLevel> levels;  // from the lowest up
    std::vector<PlanSpace> spaces;
    std::vector<PlanDoor> doors;
    std::vector<PlanWall> walls;
    std::vector<PlanThing> things;
    std::vector<PlanLift> lifts;
    std::vector<PlanFlight> flights;
    std::vector<PlanWay> ways;
    std::vector<PlanBlock> blocks;
    std::vector<PlanStart> starts;
    std::vector<std::string> guessed, simplified, left_out;     // sentences for the report
    std::vector<std::pair<std::string, std::string>> warnings;  // what is wrong, and what was done about it
};

}  // namespace handrail::floorplan
