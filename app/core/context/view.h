// Defines a plain snapshot of everything visible. In each frame, the session passes it to the window and to nothing
// else. Use it on the app thread only.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/core/dialogue/dialogue.h"
#include "worlds/base/vec.h"
#include "worlds/navigation/room_outlines.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A room as the window draws it on the plan.
struct DrawnRoom {
    std::string name;  // name as it is spoken
    Vec3 middle_m{0.0};
    double area_m2 = 0.0;
    navigation::RoomOutline outline;
};

// A movable thing that is not at its position in the scene.
struct MovedThing {
    std::uint32_t thing = 0;  // index in Scene::placed
    Placement at;

    bool operator==(const MovedThing&) const = default;
};

struct ViewState {
    std::shared_ptr<const Scene> scene;  // the scene of the world; another pointer after another world was entered
    std::vector<MovedThing> moved;       // all things that are not at their position in the scene
    Vec3 eyes_m{0.0};
    double heading_rad = 0.0;
    double tilt_rad = 0.0;  // tilt of the view; up is positive
    Vec3 feet_m{0.0};
    bool show_hand = false;  // true: there is a device or a simulated hand
    Vec3 proxy_m{0.0};
    double proxy_radius_m = 0.005;
    bool touching = false;   // true: the proxy is drawn red, otherwise green
    bool plan_view = false;  // true: the plan is shown; F3 switches it
    bool forces_on = true;
    bool north_up = true;  // true in the Map frame
    std::shared_ptr<const std::vector<DrawnRoom>>
        rooms;  // rooms in the order of the room graph; null: not known, or no plan is shown
    std::uint32_t room = navigation::kNothing;  // index of the walker's room in `rooms`
    std::string last_spoken;                    // the last announcement, which the window shows as large text
    std::vector<Vec3> path_m;                   // path that the walker has walked, oldest position first
    DialogueView dialogue;                      // the list or question that is open

    bool operator==(const ViewState&) const = default;
};

}  // namespace handrail::core
