// What happens in a session, as facts for whoever follows it (a recording, a lesson, a test) beside what is said and
// played. Told by features through the context; who listens is not their business. Plain data; metres of the world,
// seconds of the session's clock.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/core/dialogue/command.h"
#include "worlds/scene/scene.h"

namespace handrail {

// A hand came to touch something else than before.
struct Touched {
    FeatureId feature;
    bool left = false;   // the left one of two hands
    Vec3 at_m{0.0};      // the ball's middle
    double force_n = 0;  // of the contacts
};
// The body came into a room, by its number in the room graph.
struct RoomEntered {
    std::uint32_t room = 0;
    std::string name;
};
// By what somebody is at a thing: a hand touches it, it was asked about, or it is faced.
enum class VisitedBy : std::uint8_t { Hand, Asking, Facing };
// The person stands at a thing: once for each stay.
struct ThingVisited {
    FeatureId feature;
    VisitedBy by = VisitedBy::Hand;
};
// A question was answered by typing.
struct Answered {
    std::string question, text;
};
// All of a wall is known by now.
struct WallDone {
    FeatureId feature;
    std::uint32_t room = 0;
};
// The person asked where they are, what is around or which ways lead out.
struct HelpAsked {
    Command command;
};
// The person opened or shut a door, pressed a button or called a lift.
struct DoorUsed {
    FeatureId feature;
};
// The body was put somewhere else.
struct Teleported {
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

// By what somebody is brought somewhere: a pull on the hand, lines under it, words step by step, a sound at the goal.
enum class LedBy : std::uint8_t { Hand, Lines, Ear, Beacon };
// From now on the person is led to a goal, or to the next stop of a way, or on from elsewhere; as it is told.
struct Led {
    std::string goal;
    LedBy by = LedBy::Ear;
};
// The body, or the hand that is pulled, is off the way it is led along.
struct LeftRoute {
    std::string goal;
    LedBy by = LedBy::Ear;
};
// A stop of a kept way is reached, and the way goes on from it.
struct StopPassed {
    std::string stop;
    LedBy by = LedBy::Ear;
};
// The end of what one was led along is reached: the goal, or where one gets nearest to it.
struct Arrived {
    std::string goal;
    LedBy by = LedBy::Ear;
    bool to_nearest = false;
};
// From now on the person is led by anything at all, or by nothing any more.
struct Leading {
    bool on = false;
};
// A list or a question is open from now on, or none is any more.
struct ListShown {
    bool open = false;
};

// What somebody in a lesson asks of whoever teaches.
enum class LessonWish : std::uint8_t { Done, MoreHelp, LessHelp, Leave };
struct LessonWished {
    LessonWish wish = LessonWish::Done;
};

using Happening = std::variant<Touched, RoomEntered, ThingVisited, Answered, WallDone, HelpAsked, DoorUsed, Teleported,
                               Led, LeftRoute, StopPassed, Arrived, Leading, ListShown, LessonWished>;

struct SessionEvent {
    double time_s = 0.0;
    Happening what;
};

// In the order in which they happened, until they are taken. Nobody need take them: the oldest go where there are more
// than kMost. App thread only.
class Events {
public:
    static constexpr std::size_t kMost = 4096;

    void tell(Happening what, double now_s);
    std::vector<SessionEvent> take();
    // Set by the session: each as it is told, for features that follow what happens.
    std::function<void(const SessionEvent&)> on_told;

private:
    std::vector<SessionEvent> waiting_;
    std::size_t oldest_ = 0;  // once it is full, a ring
};

}  // namespace handrail
