// Lessons: a few steps each, told one after the other, each over when the person has done it. Pure state machine: it is
// told what was met and pressed and says what is to be heard. No lesson has a time limit. Used for the tutorial and for
// the first minutes. App thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"
#include "worlds/scene/scene.h"

namespace handrail {

enum class LessonGoal {
    Begin,      // Enter
    SetUp,      // the set-up by voice, run by whoever owns the device; over when that says so
    Middle,     // the hand at the middle of its reach
    MeetWall,   // a wall touched by the hand or met by the body
    NextWall,   // another wall than the one before, so a corner
    MeetNamed,  // the thing whose name the step holds
    MeetDoor,
    Ask,   // where am I
    Look,  // around me
    GoHome,
    ForcesOff,
    ForcesOn,
    SetBeacon,    // on anything
    ReachBeacon,  // until it ends
};

struct LessonStep {
    LessonGoal goal;
    // Keys of texts.
    std::string_view hand;    // what is said to one whose hand is on a device, real or simulated
    std::string_view body;    // to one who walks by keys alone; empty: the step is left out then
    std::string_view praise;  // when it is done
    std::string_view named{};
};

struct Lesson {
    std::string_view name;  // key of its text: "Find a wall"
    std::span<const LessonStep> steps;
};

// The tutorial, each under two minutes.
std::span<const Lesson> lessons();
// From the welcome to the first corner and back to the door, in the first room.
const Lesson& first_minutes();

// What happened since the last tick.
struct LessonSense {
    std::vector<FeatureId> met;  // touched or bumped into now
    std::vector<Command> did;    // commands since the last tick
    bool at_home = false;
    double off_middle_m = 0.0;  // hand metres
    bool forces_on = true;
    bool beacon = false;     // it calls
    bool at_beacon = false;  // it was reached and calls no more
    bool set_up = false;     // the set-up by voice is over, or there is none
};

struct LessonReply {
    std::string praise;       // of the step that is done
    std::string instruction;  // of the next one
    bool done = false;        // a step is done
    bool begin_here = false;  // the workspace belongs to where the hand is now
    bool at_once = false;     // the praise comes before the name of what was met
    bool set_up = false;      // the owner is to begin the set-up
    bool finished = false;
};

class LessonRun {
public:
    // at: step to begin with, as at() gave it.
    LessonRun(const Lesson& lesson, bool hand, std::string who_speaks, std::size_t at = 0);

    LessonReply begin();
    LessonReply tick(const LessonSense& sense, const Scene& scene);
    // The instruction of this step, word for word.
    std::string instruction() const;
    LessonGoal goal() const { return lesson_.steps[at_].goal; }
    const Lesson& lesson() const { return lesson_; }
    std::size_t at() const { return at_; }
    // A device came or went.
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

}  // namespace handrail
