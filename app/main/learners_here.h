// Shows the list of learners in a session. The person chooses a learner and hears what is remembered of that learner;
// the session then continues as that learner. A learner's name may only be in that learner's own recordings, so this
// class ends the recording of the session before it announces the list. App thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/learners/learners.h"
#include "app/main/commands.h"
#include "app/main/session_recording.h"
#include "app/main/session_voice.h"

namespace handrail::program {

class LearnersHere {
public:
    // All arguments must outlive this object.
    LearnersHere(const ExploreArguments& arguments, core::Session& app, SessionRecording& recording,
                 const SessionVoice& say);

    // Call once a frame, before the session's tick.
    void turn(double now_s);
    // Returns the id of the learner for whom the program continues; empty for nobody named. The session of the current
    // learner then ends. Returns nothing until another learner is chosen.
    const std::optional<std::string>& next() const { return next_; }

private:
    void show(double now_s);
    void choose(std::size_t at, double now_s);
    std::string facts_of(const learners::Learner& learner) const;

    const ExploreArguments& arguments_;
    core::Session& app_;
    SessionRecording& recording_;
    const SessionVoice& say_;
    const learners::Learners learners_;
    // Learners in the list; the first entry of the list, for nobody named, is not included.
    std::vector<learners::Learner> shown_;
    std::optional<std::string> next_;
};

}  // namespace handrail::program
