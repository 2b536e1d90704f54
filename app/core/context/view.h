// Defines a plain snapshot of everything visible. In each frame, the session passes it to the window and to nothing
// else. Use it on the app thread only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/workspace_scale.h"
#include "app/core/dialogue/dialogue.h"
#include "settings/settings.h"
#include "worlds/base/vec.h"
#include "worlds/navigation/room_outlines.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A room as the window draws it on the plan.
struct DrawnRoom {
    std::string name;  // name as it is spoken
    Vec3 middle_m{0.0};
    double area_m2 = 0.0;
    bool outside = false;
    navigation::RoomOutline outline;
};

// A movable thing that is not at its position in the scene.
struct MovedThing {
    std::uint32_t thing = 0;  // index in Scene::placed
    Placement at;

    bool operator==(const MovedThing&) const = default;
};

// Which pictures the window shows; the command PlanView switches to the next one.
enum class Pictures : std::uint8_t { Both, Plan, FirstPerson };

// A place with a name on the plan: a mark of the person, or the place where the beacon sounds.
struct DrawnPlace {
    std::string name;
    Vec3 place_m{0.0};

    bool operator==(const DrawnPlace&) const = default;
};

// How many of the last announcements the window shows.
inline constexpr std::size_t kShownMessages = 5;

struct ShownTexts {
    std::string title;                  // title of the window: the world, the lesson and the program
    std::vector<std::string> messages;  // the last announcements, the oldest first; at most kShownMessages
    std::string hand;                   // what the hand touches, the force, and the state of the device
    std::string task;                   // what a lesson asks for, and the next leg of the route; may be empty

    bool operator==(const ShownTexts&) const = default;
};

struct ShownGuidance {
    std::vector<Vec3> route_m;         // the planned route that the walker follows; empty: none
    std::optional<DrawnPlace> goal;    // the end of that route
    std::optional<DrawnPlace> beacon;  // where the beacon sounds
    std::vector<DrawnPlace> marks;

    bool operator==(const ShownGuidance&) const = default;
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
    bool touching = false;  // true: the proxy has another colour and a ring
    Vec3 force_n{0.0};      // force on the hand, in world axes
    Pictures pictures = Pictures::Both;
    // What the plan follows in a game: the place over which the camera is; no value: the plan follows the walker.
    std::optional<Vec3> camera_m;
    // How much of the world the plan shows; no value: the whole world, or the part around the walker if it is large.
    std::optional<NamedScale> plan_scale;
    bool forces_on = true;
    bool north_up = true;  // true in the Map frame
    std::shared_ptr<const std::vector<DrawnRoom>>
        rooms;                  // rooms in the order of the room graph; null: not known, or no plan is shown
    std::vector<bool> visited;  // for each of `rooms`: true if the walker has been there
    std::uint32_t room = navigation::kNothing;  // index of the walker's room in `rooms`
    ShownTexts texts;
    std::vector<Vec3> path_m;       // path that the walker has walked, oldest position first
    std::vector<Vec3> hand_path_m;  // the last positions of the proxy, oldest first
    ShownGuidance guidance;
    DialogueView dialogue;  // the list or question that is open
    settings::Settings::Display display;

    bool operator==(const ViewState&) const = default;
};

}  // namespace handrail::core
