// Reads the doors, lifts, buttons, trains, turning parts, switches and teleporters of a map. The classes are func_door,
// func_plat, func_button, func_train with its path_corner, func_rotating and trigger_*. Their keys have the meaning
// that the game of 1996 and its successors gave them. Swinging doors of buildings are read too. The reader stores the
// entities one by one and connects them after the last one, because a target may come later in the file.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

struct ReadMover {
    Mover mover;
    Aabb bounds_m;
    // `door` is true for a door. If `linked` is true, the door moves together with doors that touch it; the map may
    // forbid that.
    bool door = false, linked = true;
    std::string name, target;  // the keys targetname and target, in lower case
    std::string direction;     // value of the key `opens`: a side, "up", "down", "slide", or empty
    TextPlace direction_place, target_place;
    double lip_units = 0.0, angle_deg = 0.0, speed_units = 100.0, height_units = 0.0;
    bool has_angle = false, lift = false, has_wait = false, has_speed = false;
    bool train = false, turns = false, starts_on = false;
    std::optional<Vec3> turns_about_units;  // middle of the entity's brush with the texture "origin"
    std::string of_lift;                    // for a door with the key `lift`: the lift's targetname in lower case
    TextPlace of_lift_place;
};
// A possible stop of trains (path_corner).
struct ReadCorner {
    std::string name, target;
    Vec3 at_units{0.0};
    double wait_s = 0.0;
};
struct ReadSwitch {
    Switch act;
    std::string target;
    TextPlace place;
    bool teleports = false;
};
struct ReadDestination {
    std::string name;
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

struct ReadMovers {
    std::vector<ReadMover> movers;
    std::vector<ReadSwitch> switches;
    std::vector<ReadDestination> destinations;
    std::vector<ReadCorner> corners;
    std::set<std::string> names;  // all targetnames of the map
};

// Stores the targetname of an entity. Call for every entity.
void note_name(ReadMovers& found, const MapEntity& entity);

// Stores an entity whose brushes became `feature`. Does nothing if the entity's class does not move. `origin_units` is
// the middle of the entity's brush with the texture "origin".
void note_mover(ReadMovers& found, const MapEntity& entity, std::string_view class_name, FeatureId feature,
                const MapKeys& keys, const std::optional<Vec3>& origin_units = {});
// Stores a path_corner, which may be a stop of a train.
void note_corner(ReadMovers& found, const MapEntity& entity, const MapKeys& keys);
// note_switch stores the volume of a trigger or teleporter. note_destination stores a place to which teleporters lead.
void note_switch(ReadMovers& found, const MapEntity& entity, std::string_view class_name, FeatureId feature);
void note_destination(ReadMovers& found, const MapEntity& entity, const Vec3& feet_m, double heading_rad);

// Call after the whole file, when it is known whether the map is a building. Fills Scene::movers and Scene::switches.
// Reports each target that is not the name of an entity.
void attach_movers(ReadMovers& found, Scene& scene, Diagnostics& diagnostics);

}  // namespace handrail::readers
