// Defines lessons of a few steps each, for the tutorial and the first minutes. A lesson announces each step, and the
// step ends when the person has done it. There is no time limit. LessonRun is a pure state machine: it receives what
// the person met and which commands were given, and returns what to announce. Use it on the app thread.
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
    Begin,      // press Enter
    SetUp,      // complete the set-up by voice, which the owner runs and whose end the owner reports
    Middle,     // bring the hand to the middle of its workspace
    MeetWall,   // touch a wall with the hand, or walk into one
    NextWall,   // meet a different wall, that is, reach a corner
    MeetNamed,  // meet the thing that the step names
    MeetDoor,
    WhereAmI,  // ask where the walker is
    Look,      // ask what is around
    GoHome,
    ForcesOff,
    ForcesOn,
    SetBeacon,    // put a beacon on anything
    ReachBeacon,  // follow the beacon until it ends
};

struct LessonStep {
    LessonGoal goal;
    // All members are keys of texts.
    std::string_view hand;  // announced to a person whose hand is on a device, real or simulated
    // Announced to a person who walks by keys only. If it is empty, the step is skipped for such a person.
    std::string_view body;
    std::string_view praise;  // announced when the step is done
    std::string_view named{};
};

struct Lesson {
    std::string_view name;  // key of the lesson's name, such as "Find a wall"
    std::span<const LessonStep> steps;
};

// Returns the lessons of the tutorial, each under two minutes.
std::span<const Lesson> lessons();
// Returns the lesson that leads from the welcome to the first corner of the first room and back to the door.
const Lesson& first_minutes();

// What has happened since the last tick.
struct LessonSense {
    std::vector<FeatureId> met;  // features that the hand touches or the walker bumps into now
    std::vector<Command> did;    // commands since the last tick
    bool at_home = false;
    double off_middle_m = 0.0;  // distance of the hand from the middle of its workspace, hand metres
    bool forces_on = true;
    bool beacon = false;     // the beacon is sounding
    bool at_beacon = false;  // the person reached the beacon, and it has stopped
    bool set_up = false;     // the set-up by voice has ended, or there is none
};

struct LessonReply {
    std::string praise;       // praise for the step that is done; empty: none
    std::string instruction;  // instruction for the next step
    bool done = false;        // true: a step is done
    bool begin_here = false;  // true: the session must place the workspace where the hand is now
    bool at_once = false;     // true: the praise comes before the name of the thing that was met
    bool set_up = false;      // true: the praise is announced before the name of the thing that was met
    bool finished = false;
};

class LessonRun {
public:
    // `at` is the step to begin with, as returned by at().
    LessonRun(const Lesson& lesson, bool hand, std::string who_speaks, std::size_t at = 0);

    LessonReply begin();
    LessonReply tick(const LessonSense& sense, const Scene& scene);
    // Returns the instruction of the present step, word for word.
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
