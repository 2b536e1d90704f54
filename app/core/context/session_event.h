// What happens in a session, as facts for a recording, a lesson or a test, as well as what is said and played. Features
// report them through the context and do not know who listens. Plain data; world metres, seconds of the session's
// clock.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/core/dialogue/command.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A hand began to touch another feature, or nothing.
struct Touched {
    FeatureId feature;
    bool left = false;   // the left of two hands
    Vec3 at_m{0.0};      // centre of the proxy
    double force_n = 0;  // of all contacts
};
// The walker entered a room; the number is that of the room graph.
struct RoomEntered {
    std::uint32_t room = 0;
    std::string name;
};
// How the person visits a thing: the hand touches it, the person asks about it, or faces it.
enum class VisitedBy : std::uint8_t { Hand, Asking, Facing };
// The person is at a thing; reported once per stay.
struct ThingVisited {
    FeatureId feature;
    VisitedBy by = VisitedBy::Hand;
};
// The person answered a question by typing.
struct Answered {
    std::string question, text;
};
// The person now knows all of a wall.
struct WallDone {
    FeatureId feature;
    std::uint32_t room = 0;
};
// The person asked where they are, what is around, or which exits there are.
struct HelpRequested {
    Command command;
};
// The person opened or closed a door, pressed a button or called a lift.
struct DoorUsed {
    FeatureId feature;
};
// The walker was moved to another place.
struct Teleported {
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

// How the person is guided: a pull on the hand, lines under the hand, words step by step, or a sound at the goal.
enum class LedBy : std::uint8_t { Hand, Lines, Ear, Beacon };
// Guidance begins to a goal or to the next stop of a route, or begins again from another place. `goal` is the spoken
// name.
struct Led {
    std::string goal;
    LedBy by = LedBy::Ear;
};
// The walker, or the hand that is pulled, has left the route.
struct LeftRoute {
    std::string goal;
    LedBy by = LedBy::Ear;
};
// A stop of a saved route was reached, and the route continues.
struct StopPassed {
    std::string stop;
    LedBy by = LedBy::Ear;
};
// The end of the guidance is reached: the goal, or the nearest place to it that can be reached.
struct Arrived {
    std::string goal;
    LedBy by = LedBy::Ear;
    bool to_nearest = false;
};
// Whether the person is being guided by anything has changed.
struct Leading {
    bool on = false;
};
// A list or a question opened, or the last one closed.
struct ListShown {
    bool open = false;
};

// What a learner requests of whoever teaches.
enum class LessonWish : std::uint8_t { Done, MoreHelp, LessHelp, Leave };
struct LessonWished {
    LessonWish wish = LessonWish::Done;
};

using Happening = std::variant<Touched, RoomEntered, ThingVisited, Answered, WallDone, HelpRequested, DoorUsed,
                               Teleported, Led, LeftRoute, StopPassed, Arrived, Leading, ListShown, LessonWished>;

struct SessionEvent {
    double time_s = 0.0;
    Happening what;
};

// The events in order until they are taken. If nobody takes them, the oldest beyond kMost are dropped. App thread only.
class Events {
public:
    static constexpr std::size_t kMost = 4096;

    void tell(Happening what, double now_s);
    std::vector<SessionEvent> take();
    // Set by the session; called with each event at once, for features that react to events.
    std::function<void(const SessionEvent&)> on_told;

private:
    std::vector<SessionEvent> waiting_;
    std::size_t oldest_ = 0;  // start of the ring buffer once it is full
};

}  // namespace handrail::core
