// What a map says of its doors, lifts, buttons, trains, turning parts, switches and teleporters: classes func_door,
// func_plat, func_button, func_train with its path_corner, func_rotating, trigger_*, with the meaning that the game of
// 1996 and its children gave their keys, and doors of buildings, which swing. Read entity by entity; who sets whom
// going is known only after the last.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct ReadMover {
    Mover mover;
    Aabb bounds_m;
    bool door = false, linked = true;  // doors that touch go together unless the map forbids it
    std::string name, target;          // targetname and target, lower case
    std::string wish;                  // the key `opens`: a side, "up", "down", "slide" or empty
    TextPlace wish_place, target_place;
    double lip_units = 0.0, angle_deg = 0.0, speed_units = 100.0, height_units = 0.0;
    bool has_angle = false, lift = false, has_wait = false, has_speed = false;
    bool train = false, turns = false, starts_on = false;
    std::optional<Vec3> turns_about_units;  // middle of its brush textured "origin"
    std::string of_lift;                    // the key `lift` of a door: a lift's targetname, lower case
    TextPlace of_lift_place;
};
// A place on the way of trains.
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
    std::set<std::string> names;  // every targetname of the map
};

// Any entity: its targetname is known from now on.
void note_name(ReadMovers& found, const MapEntity& entity);

// An entity whose brushes became `feature`. Nothing where the class does not move. `origin_units`: the middle of its
// brush textured "origin".
void note_mover(ReadMovers& found, const MapEntity& entity, std::string_view class_name, FeatureId feature,
                const MapKeys& keys, const std::optional<Vec3>& origin_units = {});
// A path_corner.
void note_corner(ReadMovers& found, const MapEntity& entity, const MapKeys& keys);
// A trigger's or teleporter's volume, or a place where teleporters lead.
void note_switch(ReadMovers& found, const MapEntity& entity, std::string_view class_name, FeatureId feature);
void note_destination(ReadMovers& found, const MapEntity& entity, const Vec3& feet_m, double heading_rad);

// After the whole file, when it is known whether this is a building: fills Scene::movers and Scene::switches. A target
// that nothing answers to is told.
void attach_movers(ReadMovers& found, Scene& scene, Diagnostics& diagnostics);

}  // namespace handrail
