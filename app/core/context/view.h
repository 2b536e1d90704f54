// A plain snapshot of what can be seen. The session passes it to the window, and to nothing else, each frame. App
// thread.
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

// A room as the plan draws it.
struct DrawnRoom {
    std::string name;  // as it is spoken
    Vec3 middle_m{0.0};
    double area_m2 = 0.0;
    navigation::RoomOutline outline;
};

// A movable thing that is on its way.
struct MovedThing {
    std::uint32_t thing = 0;  // index in Scene::placed
    Placement at;

    bool operator==(const MovedThing&) const = default;
};

struct ViewState {
    std::shared_ptr<const Scene> scene;  // a new pointer after another world was entered
    std::vector<MovedThing> moved;       // things that are not at their place in the scene
    Vec3 eyes_m{0.0};
    double heading_rad = 0.0;
    double tilt_rad = 0.0;  // up is positive
    Vec3 feet_m{0.0};
    bool show_hand = false;  // there is a device or a simulated hand
    Vec3 proxy_m{0.0};
    double ball_radius_m = 0.005;
    bool touching = false;   // drawn red, otherwise green
    bool plan_view = false;  // toggled with F3
    bool forces_on = true;
    bool north_up = true;  // Map frame
    std::shared_ptr<const std::vector<DrawnRoom>>
        rooms;                                  // of the room graph, in its order; null: not known, or no plan is shown
    std::uint32_t room = navigation::kNothing;  // index of the walker's room in `rooms`
    std::string last_spoken;                    // shown as large text
    std::vector<Vec3> path_m;                   // walked path, oldest first
    DialogueView dialogue;                      // the list or question that is open

    bool operator==(const ViewState&) const = default;
};

}  // namespace handrail::core
