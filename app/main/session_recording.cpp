#include "app/main/session_recording.h"

#include <utility>

#include "worlds/base/language.h"

namespace handrail::program {

SessionRecording::SessionRecording(const ExploreArguments& arguments, const settings::Settings& settings, Clock& clock,
                                   std::vector<std::string>& news)
    : clock_(clock) {
    if (!arguments.record_in || arguments.calibrate) return;
    record::RecordingHead head;
    head.program = arguments.program_version;
    head.language = spoken_language();
    head.begun_s = servo::in_whole_microseconds(clock.now_s());
    head.settings = settings;
    auto begun = record::Recorder::begin(*arguments.record_in, std::move(head));
    if (!begun) {
        news.push_back(begun.error().sentence());
        return;
    }
    recorder_ = std::move(*begun);
    arrivals_.emplace([this](std::uint64_t requested) { note("came", requested); });
    news.push_back(phrase("recording.begun"));
}

void SessionRecording::listen_to(core::Session& app) {
    if (!recorder_) return;
    app.add_input_listener({[this](const core::SessionInput& input, double now_s) { recorder_->input(input, now_s); },
                            [this] { recorder_->not_taken(); }});
}

sinks::SoundOutputs SessionRecording::noted(sinks::SoundOutputs outputs) {
    if (!recorder_) return outputs;
    outputs.audio = std::make_unique<record::RecordedSound>(std::move(outputs.audio), *recorder_, steps_);
    outputs.speech = std::make_unique<record::RecordedVoice>(std::move(outputs.speech), *recorder_, steps_);
    return outputs;
}

void SessionRecording::listen_to(cues::AudioThread& sound) {
    if (!recorder_) return;
    sound.set_step_listener(
        {[this](double now_s) { steps_->begin(now_s); },
         [this](const cues::AudioThread::Step& step) {
             recorder_->cue_step({step.now_s, step.contacts, step.left_contacts, step.posts, steps_->end()});
         }});
}

std::vector<core::SessionEvent> SessionRecording::ticked(core::Session& app, double now_s, const servo::ToolState& tool,
                                                         const servo::ToolState& left_tool) {
    std::vector<core::SessionEvent> events = app.take_events();
    if (!recorder_) return events;
    const core::Bodies::EngineRead& read = app.free_bodies().read_of_engine();
    recorder_->frame({now_s, tool.ticks, left_tool.ticks, app.scene() ? app.feet_m() : Vec3(0.0), app.heading_rad(),
                      read.engine, read.frame, read.events});
    for (const std::uint64_t order : std::exchange(recorder_->bodies().refused, {})) note("order_refused", order);
    for (const core::SessionEvent& event : events) recorder_->event(event, app.scene().get());
    return events;
}

bool SessionRecording::leave_off() {
    if (!recorder_ || std::exchange(left_off_, true)) return false;
    note("left_off");
    recorder_->end(clock_.now_s());
    return true;
}

void SessionRecording::set_up(bool under_way) {
    if (std::exchange(set_up_, under_way) != under_way && under_way) note("set_up");
}

}  // namespace handrail::program
