// Defines the events of a session, for a recording, a lesson or a test. Speech and sound are not events. Features
// report events through the context and do not know who listens. Plain data in world metres and in seconds of the
// session's clock.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/core/dialogue/command.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A hand has begun to touch another feature, or has stopped touching any feature.
struct Touched {
    FeatureId feature;
    bool left = false;   // true: the left of two hands
    Vec3 at_m{0.0};      // centre of the proxy
    double force_n = 0;  // sum of the forces of all contacts
};
// The walker entered a room; `room` is its number in the room graph.
struct RoomEntered {
    std::uint32_t room = 0;
    std::string name;
};
// How the person visits a thing: touching it with the hand, asking about it, or facing it.
enum class VisitedBy : std::uint8_t { Hand, Query, Facing };
// The person visits a thing. Reported once for each stay at the thing.
struct ThingVisited {
    FeatureId feature;
    VisitedBy by = VisitedBy::Hand;
};
// The person answered a question with a typed text.
struct Answered {
    std::string question, text;
};
// The person has now learnt the whole of a wall.
struct WallDone {
    FeatureId feature;
    std::uint32_t room = 0;
};
// The person requested help: their own position, the surroundings or the exits.
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

// How the person is guided: by a pull on the hand, by lines under the hand, by spoken directions, or by a sound at the
// goal.
enum class LedBy : std::uint8_t { Hand, Lines, Ear, Beacon };
// Guidance begins, or begins again from another place. `goal` is the spoken name of the goal or of the route's next
// stop.
struct Led {
    std::string goal;
    LedBy by = LedBy::Ear;
};
// The walker, or the hand that is being pulled, has left the route.
struct LeftRoute {
    std::string goal;
    LedBy by = LedBy::Ear;
};
// The person has reached a stop of a saved route, and the route continues.
struct StopPassed {
    std::string stop;
    LedBy by = LedBy::Ear;
};
// The guidance has ended: the person is at the goal, or at the nearest place to it that can be reached.
struct Arrived {
    std::string goal;
    LedBy by = LedBy::Ear;
    bool to_nearest = false;
};
// Guidance of any kind has begun or ended.
struct Leading {
    bool on = false;
};
// A list or a question opened, or the last one closed.
struct ListShown {
    bool open = false;
};

// What a learner requests from the teacher, who is a person or a lesson file.
enum class LessonRequest : std::uint8_t { Done, MoreHelp, LessHelp, Leave };
struct LessonRequested {
    LessonRequest request = LessonRequest::Done;
};

using Happening = std::variant<Touched, RoomEntered, ThingVisited, Answered, WallDone, HelpRequested, DoorUsed,
                               Teleported, Led, LeftRoute, StopPassed, Arrived, Leading, ListShown, LessonRequested>;

struct SessionEvent {
    double time_s = 0.0;
    Happening what;
};

// A queue that keeps events in order until the listener removes them. If nobody removes them, the queue drops the
// oldest ones beyond kMost. Use it on the app thread only.
class Events {
public:
    static constexpr std::size_t kMost = 4096;

    void report(Happening what, double now_s);
    std::vector<SessionEvent> take();
    // The session sets this function. The queue calls it at once with each event, so that features can react to events.
    std::function<void(const SessionEvent&)> on_reported;

private:
    std::vector<SessionEvent> waiting_;
    std::size_t oldest_ = 0;  // index of the oldest event once the ring buffer is full
};

}  // namespace handrail::core
