// Who is here, as a list in the program: chosen, told what is remembered of them, and put in the place of who was here
// before. Names of learners are in no recording but their own, so the recording of a session ends before the list is
// told. App thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/learners/learners.h"
#include "app/main/commands.h"
#include "app/main/session_recording.h"
#include "app/main/session_voice.h"

namespace handrail {

class LearnersHere {
public:
    // All outlive this object.
    LearnersHere(const ExploreArguments& arguments, Session& app, SessionRecording& recording, const SessionVoice& say);

    // Once a frame, before the session's tick.
    void turn(double now_s);
    // Who is to be here instead, by id; empty: nobody by name. The session ends for them.
    const std::optional<std::string>& next() const { return next_; }

private:
    void show(double now_s);
    void choose(std::size_t at, double now_s);
    std::string told_of(const Learner& learner) const;

    const ExploreArguments& arguments_;
    Session& app_;
    SessionRecording& recording_;
    const SessionVoice& say_;
    const Learners learners_;
    std::vector<Learner> shown_;  // behind nobody by name
    std::optional<std::string> next_;
};

}  // namespace handrail
