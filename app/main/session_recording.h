// The recording of a session with a person, where one was asked for: one place for all that the other parts tell it,
// and nothing where there is none. App thread, but for what the ears call.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/main/commands.h"
#include "app/record/recorded_sinks.h"
#include "app/record/recorder.h"
#include "audio-cues/plan/audio_thread.h"
#include "audio-cues/sinks/sound_outputs.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/clock.h"

namespace handrail {

class SessionRecording {
public:
    // Begins one where the arguments ask for it; `news` get where it is, or why there is none. The clock outlives it.
    SessionRecording(const ExploreArguments& arguments, const Settings& settings, Clock& clock,
                     std::vector<std::string>& news);

    // For who is recorded; null: nobody is.
    Arrivals* arrivals() { return arrivals_ ? &*arrivals_ : nullptr; }
    HandRing* hand(std::size_t which) { return recorder_ ? &recorder_->hand(which) : nullptr; }
    EngineRecording* bodies() { return recorder_ ? &recorder_->bodies() : nullptr; }
    void listen_to(Session& app);
    // Before the ears start.
    SoundOutputs noted(SoundOutputs outputs);
    void listen_to(AudioThread& sound);

    // After the session's tick; gives what happened in it.
    std::vector<SessionEvent> ticked(Session& app, double now_s, const ToolState& tool, const ToolState& left_tool);
    // As Recorder has it.
    void handed_over() {
        if (recorder_) recorder_->handed_over();
    }
    void note(const char* is, std::uint64_t number = 0) {
        if (recorder_) recorder_->note(is, clock_.now_s(), number);
    }
    // Nothing is recorded from here on, as what follows concerns others. False: nothing was.
    bool leave_off();
    // Each frame: a set-up leads the person, beside the session. Said once where it begins.
    void set_up(bool under_way);
    // It ended before its time; told once.
    std::optional<std::string> take_problem() { return recorder_ ? recorder_->take_problem() : std::nullopt; }
    // After the last word.
    void end() {
        if (recorder_) recorder_->end(clock_.now_s());
    }

private:
    Clock& clock_;
    std::unique_ptr<Recorder> recorder_;
    std::optional<Arrivals> arrivals_;
    std::shared_ptr<StepNotes> steps_ = std::make_shared<StepNotes>();
    bool set_up_ = false, left_off_ = false;
};

}  // namespace handrail
