#include "app/core/headless_session.h"

namespace handrail {
namespace {

constexpr long kCueEvery_ms = 5;
constexpr double kFrames_per_s = 60.0;

}  // namespace

HeadlessSession::HeadlessSession(const Settings& settings, const HandFacts& hand, AudioSink& audio, SpeechSink& speech)
    : app_(settings, hand),
      facts_(hand),
      audio_(audio),
      speech_(speech),
      planner_(settings),
      hand_(std::make_shared<SimulatedHand>()),
      servo_state_(hand.present ? hand.spec : ideal_device_spec()) {
    if (!hand.present) return;
    HandCommand still;
    still.mode = HandMode::Move;
    hand_->command.publish(still);
    device_ = std::make_unique<SimulatedDevice>(hand.spec, hand_);
}

void HeadlessSession::change_settings(const Settings& settings) {
    app_.change_settings(settings, now_s());
    planner_.set_settings(settings);
}

void HeadlessSession::advance() {
    ++milliseconds_;
    if (device_ && milliseconds_ % servo_every_ms_ == 0) servo();
    // Frames fall on the first millisecond at or after their time.
    if (now_s() * kFrames_per_s >= static_cast<double>(frames_)) {
        ++frames_;
        app_.tick(now_s(), tool_);
        if (!app_.take_setting_changes().empty()) planner_.set_settings(app_.settings());
    }
    if (milliseconds_ % kCueEvery_ms == 0) cues();
}

void HeadlessSession::servo() {
    const DeviceSample sample = device_->read(now_s());
    device_->write(servo_tick(servo_state_, app_.haptic_scene().get(), app_.tuning(), app_.pose(), sample, now_s(), &app_.bodies()));
    tool_ = servo_state_.tool();
    for (const ContactEvent& event : servo_state_.events()) contacts_.push_back(event);
}

void HeadlessSession::cues() {
    if (heard_scene_ != app_.scene()) {
        heard_scene_ = app_.scene();
        if (std::exchange(heard_world_, app_.worlds_entered()) != app_.worlds_entered()) planner_.enter_world(heard_scene_);
        else planner_.follow_edit(heard_scene_);
    }
    for (CueRequest& request : app_.take_cues()) requests_.push_back(std::move(request));
    CueInputs inputs;
    inputs.now_s = now_s();
    inputs.contacts = contacts_;
    inputs.requests = requests_;
    inputs.listener = app_.listener();
    planner_.tick(inputs, audio_, speech_);
    contacts_.clear();
    requests_.clear();
}

}  // namespace handrail
