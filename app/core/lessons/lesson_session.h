// Lessons and the first minutes in a session: what they are told of what happens, when they speak, where they lead. App
// thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/core/context/asked_to_leave.h"
#include "app/core/context/session_part.h"
#include "app/core/lessons/lesson.h"

namespace handrail {

class LessonSession : SessionPart {
public:
    // asked_to_leave: whoever was asked before the lesson began is not asked again.
    LessonSession(const SessionContext& context, AskedToLeave& asked_to_leave);

    // The first minutes, before a world is entered or in one, from where they were left. who_speaks:
    // "speech-dispatcher"; owner_sets_up: the owner runs the set-up by voice when it is asked for, else that part is
    // left out.
    void begin_first_minutes(const std::string& who_speaks, bool owner_sets_up, double now_s);
    // Nobody will answer them any more, or they are not wanted: the world greets as it does otherwise.
    void leave(double now_s);
    // The first minutes have not come to the world yet.
    bool greeting_waits() const;
    // The owner's set-up, which the first minutes asked for, is over, or left.
    void know_set_up_over() { set_up_over_ = true; }

    // Before anything is done. True: the command was the lesson's, or is not to be done.
    bool takes(Command command, double now_s);
    // A line of a terminal, without blanks around it, while the first step waits for a key.
    bool take_line(std::string_view line, double now_s);
    // What happens, until the next tick.
    void note(Command command) { did_.push_back(command); }
    void note_bump(FeatureId feature) { bumped_.push_back(feature); }
    // The list of lessons, and the first minutes from the beginning. False: it is another's.
    bool act(Command command, double now_s);
    void tick(double now_s);
    // What happened has been looked at, and nothing waits to be said.
    bool idle() const;

    // Set by the session.
    std::function<bool()> beacon_calls, at_beacon;    // the body is at what the beacon is on, or was
    std::function<std::string()> world_greeting;      // of the world one is in
    std::function<void(double now_s)> on_begin_here;  // the workspace belongs to where the hand is now
    std::function<void(double now_s)> on_hunt;        // in a larger building
    std::function<void(double now_s)> on_worlds;      // to be chosen from
    std::function<void(double now_s)> on_settings;    // likewise

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

    AskedToLeave& asked_to_leave_;
    std::optional<LessonRun> run_;
    std::vector<Command> did_;       // since the last tick
    std::vector<FeatureId> bumped_;  // likewise
    struct SaidLater {
        double due_s = 0.0;
        std::string text;
    };
    std::vector<SaidLater> said_later_;
    enum class After { Nothing, Choose, Lessons } after_ = After::Nothing;
    std::string who_speaks_;
    bool owner_sets_up_ = false, set_up_over_ = true;
};

}  // namespace handrail
