// Records a session with a person, if the person requested it. All other parts report to this class; without a
// recording, its functions do nothing. App thread, except for the functions that the audio thread calls.
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

namespace handrail::program {

class SessionRecording {
public:
    // Begins a recording if the arguments request it. Adds a sentence to `news` that says where the recording is, or
    // why there is none. The clock must outlive this object.
    SessionRecording(const ExploreArguments& arguments, const settings::Settings& settings, Clock& clock,
                     std::vector<std::string>& news);

    // These functions return the objects into which other parts write what they do. They return null if nothing is
    // recorded.
    Arrivals* arrivals() { return arrivals_ ? &*arrivals_ : nullptr; }
    servo::HandRing* hand(std::size_t which) { return recorder_ ? &recorder_->hand(which) : nullptr; }
    dynamics::EngineRecording* bodies() { return recorder_ ? &recorder_->bodies() : nullptr; }
    void listen_to(core::Session& app);
    // Wraps the outputs, so that their use is recorded. Call noted() before the audio thread starts.
    sinks::SoundOutputs noted(sinks::SoundOutputs outputs);
    void listen_to(cues::AudioThread& sound);

    // Call after the session's tick. Records the tick and returns the events that happened in it.
    std::vector<core::SessionEvent> ticked(core::Session& app, double now_s, const servo::ToolState& tool,
                                           const servo::ToolState& left_tool);
    // See Recorder::handed_over.
    void handed_over() {
        if (recorder_) recorder_->handed_over();
    }
    void note(const char* is, std::uint64_t number = 0) {
        if (recorder_) recorder_->note(is, clock_.now_s(), number);
    }
    // Stops recording before other people are concerned. Returns false if nothing was being recorded.
    bool leave_off();
    // Call each frame. `under_way`: the set-up, not the session, leads the person. Records the beginning of each
    // set-up.
    void set_up(bool under_way);
    // If the recording ended too early, returns the reason once; otherwise nothing.
    std::optional<std::string> take_problem() { return recorder_ ? recorder_->take_problem() : std::nullopt; }
    // Call after the last word was spoken.
    void end() {
        if (recorder_) recorder_->end(clock_.now_s());
    }

private:
    Clock& clock_;
    std::unique_ptr<record::Recorder> recorder_;
    std::optional<Arrivals> arrivals_;
    std::shared_ptr<record::StepNotes> steps_ = std::make_shared<record::StepNotes>();
    bool set_up_ = false, left_off_ = false;
};

}  // namespace handrail::program
