// Lessons of a few steps each, for the tutorial and the first minutes. Each step is announced and ends when the person
// has done it; there is no time limit. Pure state machine: it receives what was met and pressed, and returns what to
// announce. App thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

enum class LessonGoal {
    Begin,      // Enter
    SetUp,      // the set-up by voice, run by the owner, who reports its end
    Middle,     // the hand at the middle of its workspace
    MeetWall,   // a wall that the hand touches or the walker meets
    NextWall,   // a different wall, which means a corner
    MeetNamed,  // the thing that the step names
    MeetDoor,
    Ask,   // the question where the person is
    Look,  // the question what is around
    GoHome,
    ForcesOff,
    ForcesOn,
    SetBeacon,    // on anything
    ReachBeacon,  // until the beacon ends
};

struct LessonStep {
    LessonGoal goal;
    // Keys of texts.
    std::string_view hand;    // announced to a person whose hand is on a device, real or simulated
    std::string_view body;    // announced to a person who walks by keys only; empty: the step is skipped for them
    std::string_view praise;  // announced when it is done
    std::string_view named{};
};

struct Lesson {
    std::string_view name;  // key of its text: "Find a wall"
    std::span<const LessonStep> steps;
};

// The tutorial lessons, each under two minutes.
std::span<const Lesson> lessons();
// From the welcome to the first corner and back to the door, in the first room.
const Lesson& first_minutes();

// What happened since the last tick.
struct LessonSense {
    std::vector<FeatureId> met;  // touched or bumped into now
    std::vector<Command> did;    // commands since the last tick
    bool at_home = false;
    double off_middle_m = 0.0;  // distance of the hand from the middle of its workspace, hand metres
    bool forces_on = true;
    bool beacon = false;     // the beacon is sounding
    bool at_beacon = false;  // the beacon was reached and has stopped
    bool set_up = false;     // the set-up by voice is over, or there is none
};

struct LessonReply {
    std::string praise;       // for the step that is done
    std::string instruction;  // for the next step
    bool done = false;        // a step is done
    bool begin_here = false;  // the workspace is to be placed where the hand is now
    bool at_once = false;     // the praise comes before the name of what was met
    bool set_up = false;      // the owner must begin the set-up
    bool finished = false;
};

class LessonRun {
public:
    // at: the step to begin with, as returned by at().
    LessonRun(const Lesson& lesson, bool hand, std::string who_speaks, std::size_t at = 0);

    LessonReply begin();
    LessonReply tick(const LessonSense& sense, const Scene& scene);
    // The instruction of the present step, word for word.
    std::string instruction() const;
    LessonGoal goal() const { return lesson_.steps[at_].goal; }
    const Lesson& lesson() const { return lesson_; }
    std::size_t at() const { return at_; }
    // Call it when a device was connected or removed.
    void set_hand(bool hand) { hand_ = hand; }

private:
    LessonReply enter(std::size_t at, LessonReply reply);
    bool is_left_out(const LessonStep& step) const;

    const Lesson& lesson_;
    bool hand_;
    std::string who_speaks_;
    std::size_t at_;
    FeatureId last_wall_ = kNoFeature;
};

}  // namespace handrail::core
