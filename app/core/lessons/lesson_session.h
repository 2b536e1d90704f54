// Connects lessons and the first minutes to a session. It collects the events that lessons need, says what the lessons
// announce, and begins what follows a lesson. Use it on the app thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/core/context/leave_requested.h"
#include "app/core/context/session_part.h"
#include "app/core/lessons/lesson.h"

namespace handrail::core {

class LessonSession : SessionPart {
public:
    // `leave_requested` is shared with the session. So if the person asked to leave shortly before the lesson began, a
    // second request during the lesson leaves at once.
    LessonSession(const SessionContext& context, LeaveRequested& leave_requested);

    // Begins the first minutes, before a world is entered or in a world, at the step where the person left them.
    // `who_speaks` names the speech program, such as "speech-dispatcher". `owner_sets_up`: the owner runs the set-up by
    // voice when the session requests it; otherwise that step is skipped.
    void begin_first_minutes(const std::string& who_speaks, bool owner_sets_up, double now_s);
    // Ends the first minutes, because the person does not want them or can no longer answer. The session then greets
    // the person in the world as after any start.
    void leave(double now_s);
    // Returns true if the first minutes have not yet reached the step that greets the person in the world.
    bool greeting_waits() const;
    // Call it when the set-up that the first minutes requested from the owner has ended or the person has left the
    // set-up.
    void know_set_up_over() { set_up_over_ = true; }

    // Returns true if the lesson used the command or does not permit it. Call it before a command is carried out.
    bool takes(Command command, double now_s);
    // Processes a line typed in a terminal, without surrounding blanks, while the first step waits for a key. Returns
    // false if the lesson did not use the line.
    bool take_line(std::string_view line, double now_s);
    // Returns the instruction of the present step; empty: no lesson is under way.
    std::string instruction() const { return run_ ? run_->instruction() : std::string{}; }
    // Notes a command or a bump for the next tick.
    void note(Command command) { did_.push_back(command); }
    void note_bump(FeatureId feature) { bumped_.push_back(feature); }
    // Carries out the command that lists the lessons and the command that begins the first minutes again. Returns false
    // for other commands.
    bool act(Command command, double now_s);
    void tick(double now_s);
    // Says once more the announcement that was cut off: the instruction of the present step, or the praise for the
    // previous one.
    void announce_anew(cues::SpeechTopic topic, double now_s);
    // Returns true if the lesson has evaluated everything that happened, and no announcement is waiting.
    bool idle() const;

    // The session sets these functions. `beacon_calls` returns true while the beacon sounds. `at_beacon` returns true
    // while the walker is where the beacon sounds or sounded last.
    std::function<bool()> beacon_calls, at_beacon;
    std::function<std::string()> world_greeting;      // returns the greeting for the present world
    std::function<void(double now_s)> on_begin_here;  // places the workspace where the hand is now
    std::function<void(double now_s)> on_hunt;        // begins a hunt in a larger building
    std::function<void(double now_s)> on_worlds;      // opens the list of worlds
    std::function<void(double now_s)> on_settings;    // opens the settings

private:
    bool hand() const;
    bool in_first_minutes() const;
    void begin(const Lesson& lesson, std::size_t at, double now_s);
    LessonSense sense();
    void announce(const LessonReply& reply, double now_s);
    void say_due(double now_s);
    void keep_welcome(int step, bool done);
    void choose_what_next(double now_s);
    void open_list(double now_s);

    LeaveRequested& leave_requested_;
    std::optional<LessonRun> run_;
    std::vector<Command> did_;       // commands since the last tick
    std::vector<FeatureId> bumped_;  // features that the walker bumped into since the last tick
    struct SaidLater {
        double due_s = 0.0;
        std::string text;
        cues::SpeechTopic topic = cues::SpeechTopic::Lesson;
    };
    std::vector<SaidLater> said_later_;
    std::string praise_;  // praise for the step that was done last
    enum class After { Nothing, Choose, Lessons } after_ = After::Nothing;
    std::string who_speaks_;
    bool owner_sets_up_ = false, set_up_over_ = true;
};

}  // namespace handrail::core
