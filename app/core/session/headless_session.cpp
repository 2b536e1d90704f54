#include "app/core/session/headless_session.h"

#include "worlds/base/contract.h"

namespace handrail {
namespace {

constexpr long kCueEvery_ms = 5;
constexpr double kFrames_per_s = 60.0;

}  // namespace

HeadlessSession::HeadlessSession(const Settings& settings, const HandFacts& hand, AudioSink& audio, SpeechSink& speech,
                                 const SessionOptions& options)
    : app_(settings, hand, options), facts_(hand), audio_(audio), speech_(speech), planner_(settings) {
    hands_[0].take(hand);
}

void HeadlessSession::Hand::take(const HandFacts& facts) {
    simulated->command.publish(still_hand());
    simulated->trouble.publish(DeviceTrouble{});
    device = facts.present ? std::make_unique<SimulatedDevice>(facts.spec, simulated) : nullptr;
    state = facts.present ? std::make_unique<ServoState>(facts.spec) : nullptr;
    tool = {};
}

void HeadlessSession::change_hand(const HandFacts& facts) {
    facts_ = facts;
    hands_[0].take(facts);
    app_.apply(HandChanged{facts, app_.settings()}, now_s());
    planner_.set_two_hands(app_.two_hands());
}

void HeadlessSession::give_left_hand(const HandFacts& facts) {
    hands_[1].take(facts);
    app_.apply(LeftHandChanged{facts}, now_s());
    planner_.set_two_hands(app_.two_hands());
}

HandCommand HeadlessSession::still_hand() {
    HandCommand still;
    still.mode = HandMode::Move;
    return still;
}

void HeadlessSession::press(Command command, int times) {
    contract_pre(static_cast<std::size_t>(command) < command_table().size());
    if (command == Command::StopEverything) switches_.stop();
    app_.apply(Stopped{switches_.stops.load()}, now_s());
    app_.apply(CommandDown{command, times}, now_s());
}

bool HeadlessSession::tap_key(const std::string& name) {
    if (app_.apply(KeyTapped{name}, now_s())) return true;
    const auto command = app_.keys().find(name);
    if (!command) return false;
    press(*command);
    app_.apply(CommandUp{*command}, now_s());
    return true;
}

void HeadlessSession::set_focus(bool focused) {
    switches_.focused = focused;
    app_.apply(FocusChanged{focused}, now_s());
}

void HeadlessSession::change_settings(const Settings& settings) {
    app_.apply(SettingsChanged{settings}, now_s());
    planner_.set_settings(settings);
}

void HeadlessSession::advance() {
    ++milliseconds_;
    for (std::size_t which = 0; which < hands_.size(); ++which)
        if (hands_[which].device && milliseconds_ % servo_every_ms_ == 0) servo(which);
    // What a hand feels moves in its rhythm; else the app moves it.
    if (hands_[0].device || hands_[1].device) app_.step_bodies(now_s());
    // Frames fall on the first millisecond at or after their time.
    if (now_s() * kFrames_per_s >= static_cast<double>(frames_)) {
        ++frames_;
        app_.tick(now_s(), hands_[0].tool, hands_[1].tool);
        if (!app_.take_setting_changes().empty()) planner_.set_settings(app_.settings());
    }
    if (milliseconds_ % kCueEvery_ms == 0) cues();
}

void HeadlessSession::servo(std::size_t which) {
    Hand& hand = hands_[which];
    const DeviceSample sample = hand.device->read(now_s());
    const HandOutput told = app_.hand(which);
    hand.device->write(servo_tick(
        *hand.state, app_.haptic_scene().get(), with_switches(told.tuning, switches_), told.pose, sample, now_s(),
        &app_.bodies(), which == 0 ? app_.desk_visit().scene().get() : nullptr, told.guidance, told.engine.get()));
    hand.tool = hand.state->tool();
    for (const ContactEvent& event : hand.state->events()) {
        contacts_.push_back(event);
        contacts_.back().hand = static_cast<std::uint8_t>(which);
    }
}

void HeadlessSession::cues() {
    if (heard_scene_ != app_.scene()) {
        heard_scene_ = app_.scene();
        if (std::exchange(heard_world_, app_.world().entered) != app_.world().entered)
            planner_.enter_world(heard_scene_);
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
