// A building as plans drawn from above say it: spaces with outlines on levels, doors on those outlines, what leads up
// and down. Between a file (OpenStreetMap, IMDF) and the Scene. Plain values; metres, x east, y north.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/geometry/flat_parts.h"

namespace handrail {

struct PlanLevel {
    double number = 0.0;  // as the file has it: 0 is at the ground
    std::string name;     // fit to be spoken
    double floor_m = 0.0;
};

// Room: walls all round. Corridor and Area: none towards one another, walls where nothing lies beyond.
enum class PlanSpaceKind : std::uint8_t { Room, Corridor, Area, Stairs, Escalator, Lift };

struct PlanSpace {
    PlanSpaceKind kind = PlanSpaceKind::Room;
    bool walled = true;               // like a room, whatever it is
    std::string name;                 // fit to be spoken; may be empty
    std::string number;               // "A101"; may be empty
    std::string id;                   // of the file, fit to be told: "way 12"
    std::vector<Ring> rings;          // by the even-odd rule
    std::vector<std::size_t> levels;  // places in FloorPlan::levels, rising; stairs and lifts join them
    std::vector<std::string> facts;   // sentences about it, in the language spoken
    std::optional<double> height_m;   // from floor to ceiling, where the file says it
    double raised_m = 0.0;            // its floor over that of its level, where it is on one alone; negative: below it
    std::string floor_material;       // a name of the material library; may be empty
    int line = 0;                     // of the file; 0: unknown
};

enum class PlanDoorKind : std::uint8_t { Hinged, Sliding, Revolving, Opening };

// Of those that lead outside, the first to be a start.
enum class PlanEntrance : std::uint8_t { Main, Plain, Emergency };

struct PlanDoor {
    PlanDoorKind kind = PlanDoorKind::Hinged;
    Vec2 at{0.0};
    std::optional<Vec2> along;      // unit, where the file says how it lies
    std::optional<double> width_m;  // where the file says it
    std::string name, id;
    PlanEntrance entrance = PlanEntrance::Plain;
    bool by_itself = false;           // opens as one comes near
    bool guessed = false;             // the file has none there
    std::vector<std::size_t> levels;  // as above
    // Of each of its levels the spaces it joins, places in FloorPlan::spaces; empty: by what lies on its two sides.
    std::vector<std::vector<std::size_t>> spaces;
    int line = 0;
};

// A wall drawn by itself.
struct PlanWall {
    Vec2 from{0.0}, to{0.0};
    std::size_t level = 0;
};

enum class PlanThingKind : std::uint8_t { Object, Pillar, Guidance };

// What stands in a space, or lies on its floor (Guidance: ground to follow with the feet).
struct PlanThing {
    PlanThingKind kind = PlanThingKind::Object;
    std::string name;        // fit to be spoken
    bool made_name = false;  // it is one of our own names (kind.NAME)
    std::string message;
    std::vector<Ring> parts;  // convex, counter-clockwise
    double height_m = 0.8;
    std::size_t level = 0;
    double from_m = 0.0;   // above the floor
    bool window = false;   // a pane on a wall
    bool fixture = false;  // part of the building, no furniture
    bool landmark = false, clue = false;
    std::string material;  // a name of the material library; may be empty
    int line = 0;
};

// Where one can begin; the first is the base. Without any: before the doors that lead outside.
struct PlanStart {
    Vec2 at{0.0};
    std::size_t level = 0;
    double heading_rad = 0.0;
    std::string name;
    int line = 0;
    double raised_m = 0.0;  // over the floor of the level
};

// A platform without walls and doors that goes up from one space to another, through the floors between.
struct PlanLift {
    std::string name;
    Ring ring;                      // convex, counter-clockwise
    std::size_t from = 0, to = 0;   // places in FloorPlan::spaces
    std::size_t low = 0, high = 0;  // places in FloorPlan::levels, of those spaces
    int line = 0;
};

// Stairs without a room of their own, from one space to another through the floors between. They fill a rectangle.
struct PlanFlight {
    std::string name;
    Vec2 least{0.0}, most{0.0};
    Vec2 up{0.0, 1.0};              // unit, along a side: where they climb to
    bool back = false;              // with a landing there, from which they come back over their foot
    std::size_t from = 0, to = 0;   // places in FloorPlan::spaces
    std::size_t low = 0, high = 0;  // places in FloorPlan::levels, of those spaces
    int line = 0;
};

// A way that one walks along outside rooms: a floor of its own, level or from level to level.
struct PlanWay {
    std::string name, id;
    bool steps = false, escalator = false;
    bool area = false;            // `line` is the outline of a level place
    Ring line;                    // points in order; ways that share one lead into each other
    std::vector<Ring> further;    // of an area: its other outlines, by the even-odd rule
    std::vector<double> floor_m;  // of each
    double width_m = 2.0;
    std::vector<std::string> facts;
};

// Of an area: all its outlines.
inline std::vector<Ring> rings_of_way(const PlanWay& way) {
    std::vector<Ring> rings{way.line};
    rings.insert(rings.end(), way.further.begin(), way.further.end());
    return rings;
}

// Another building, or a part that stands over the ground: one solid.
struct PlanBlock {
    std::string name;
    std::vector<Ring> rings;
    double from_m = 0.0, to_m = 3.0;
};

struct FloorPlan {
    std::string name;    // of the building; may be empty
    std::string format;  // as ReadReport::format has it
    std::string schema;  // of the file, fit to be told
    double storey_m = 3.0;
    double wall_m = 0.12;           // how thick walls are, half on each side of an outline
    bool measures_known = false;    // storeys and walls are as the file has them
    std::string wall_material;      // a name of the material library; may be empty
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
    std::vector<std::string> guessed, simplified, left_out;     // sentences of the reader
    std::vector<std::pair<std::string, std::string>> warnings;  // what is wrong, and what was done then
};

}  // namespace handrail
