// Connects lessons and the first minutes to a session. It collects the events that lessons need, says what they
// announce, and begins what follows them. App thread only.
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
    // `asked_to_leave` is shared with the session. So if the person has already asked to leave before the lesson began,
    // that counts.
    LessonSession(const SessionContext& context, LeaveRequested& asked_to_leave);

    // Begins the first minutes, before a world is entered or in one, at the step where they were left. who_speaks:
    // "speech-dispatcher". owner_sets_up: the owner runs the set-up by voice when requested; otherwise that part is
    // skipped.
    void begin_first_minutes(const std::string& who_speaks, bool owner_sets_up, double now_s);
    // The first minutes are not wanted or can no longer be answered. The world then greets as usual.
    void leave(double now_s);
    // True if the first minutes have not yet reached the greeting of the world.
    bool greeting_waits() const;
    // The set-up that the first minutes requested from the owner is over or was left.
    void know_set_up_over() { set_up_over_ = true; }

    // Call it before a command is handled. Returns true if the lesson used the command or forbids it.
    bool takes(Command command, double now_s);
    // A terminal line without surrounding blanks, while the first step waits for a key.
    bool take_line(std::string_view line, double now_s);
    // Notes what happens until the next tick.
    void note(Command command) { did_.push_back(command); }
    void note_bump(FeatureId feature) { bumped_.push_back(feature); }
    // Handles the list of lessons, and the first minutes from the beginning. Returns false for other commands.
    bool act(Command command, double now_s);
    void tick(double now_s);
    // What this step wants, or what was said of the step before, once more, since the line with it was cut.
    void tell_anew(cues::SpeechTopic topic, double now_s);
    // What happened has been looked at, and nothing waits to be said.
    bool idle() const;

    // Set by the session.
    std::function<bool()> beacon_calls, at_beacon;    // the beacon sounds; the walker is where it sounds or sounded
    std::function<std::string()> world_greeting;      // for the present world
    std::function<void(double now_s)> on_begin_here;  // the workspace is to be placed where the hand is now
    std::function<void(double now_s)> on_hunt;        // begins a hunt in a larger building
    std::function<void(double now_s)> on_worlds;      // opens the list of worlds
    std::function<void(double now_s)> on_settings;    // opens the settings

private:
    bool hand() const;
    bool in_first_minutes() const;
    void begin(const Lesson& lesson, std::size_t at, double now_s);
    LessonSense sense();
    void tell(const LessonReply& reply, double now_s);
    void say_due(double now_s);
    void keep_welcome(int step, bool done);
    void choose_what_next(double now_s);
    void open_list(double now_s);

    LeaveRequested& asked_to_leave_;
    std::optional<LessonRun> run_;
    std::vector<Command> did_;       // since the last tick
    std::vector<FeatureId> bumped_;  // also since the last tick
    struct SaidLater {
        double due_s = 0.0;
        std::string text;
        cues::SpeechTopic topic = cues::SpeechTopic::Lesson;
    };
    std::vector<SaidLater> said_later_;
    std::string praise_;  // of the last step that was done
    enum class After { Nothing, Choose, Lessons } after_ = After::Nothing;
    std::string who_speaks_;
    bool owner_sets_up_ = false, set_up_over_ = true;
};

}  // namespace handrail::core
