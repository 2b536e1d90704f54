#include "app/core/session/headless_session.h"

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

constexpr long kCueEvery_ms = 5;
constexpr double kFrames_per_s = 60.0, kTick_s = 1e-3;

}  // namespace

HeadlessSession::HeadlessSession(const settings::Settings& settings, const HandFacts& hand, cues::AudioSink& audio,
                                 cues::SpeechSink& speech, const SessionOptions& options)
    : app_(settings, hand, options),
      facts_(hand),
      ears_(std::shared_ptr<cues::AudioSink>(&audio, [](cues::AudioSink*) {}),
            std::shared_ptr<cues::SpeechSink>(&speech, [](cues::SpeechSink*) {}), clock_, &hands_[0].contacts, settings,
            &hands_[1].contacts) {
    take(0, hand);
}

HeadlessSession::~HeadlessSession() { ears_.end_at_once(); }

void HeadlessSession::take(std::size_t which, const HandFacts& facts) {
    Hand& hand = hands_[which];
    hand.simulated->command.publish(still_hand());
    hand.simulated->trouble.publish(device::DeviceTrouble{});
    hand.servo.reset();
    hand.tool = {};
    if (facts.present) {
        hand.servo = std::make_unique<servo::ServoLoop>(
            std::make_unique<device::SimulatedDevice>(facts.spec, hand.simulated), clock_, kTick_s,
            servo::ServoLoop::Links{&switches_, &hand.contacts, nullptr});
        const bool opens = hand.servo->open().has_value();
        contract_pre(opens);
    }
    driver_.drive(which, hand.servo.get());
}

void HeadlessSession::change_hand(const HandFacts& facts) {
    facts_ = facts;
    take(0, facts);
    app_.apply(HandChanged{facts, app_.settings()}, now_s());
    ears_.set_two_hands(app_.two_hands());
}

void HeadlessSession::give_left_hand(const HandFacts& facts) {
    take(1, facts);
    app_.apply(LeftHandChanged{facts}, now_s());
    ears_.set_two_hands(app_.two_hands());
}

device::HandCommand HeadlessSession::still_hand() {
    device::HandCommand still;
    still.mode = device::HandMode::Move;
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

void HeadlessSession::change_settings(const settings::Settings& settings) {
    app_.apply(SettingsChanged{settings}, now_s());
    ears_.set_settings(settings);
}

void HeadlessSession::advance() {
    ++milliseconds_;
    // All input since the last frame acts at once, so that tests need not wait for the next frame.
    driver_.hand_over();
    clock_.sleep_until_s(static_cast<double>(milliseconds_) * kTick_s);
    for (Hand& hand : hands_) {
        if (!hand.servo || milliseconds_ % servo_every_ms_ != 0) continue;
        hand.servo->step();
        hand.tool = hand.servo->tool();
    }
    // If there is a servo, movable things advance with it every millisecond. Otherwise the session advances them once a
    // frame.
    if (hands_[0].servo || hands_[1].servo) app_.step_bodies(now_s());
    // A frame runs in the first millisecond at or after its time.
    if (now_s() * kFrames_per_s >= static_cast<double>(frames_)) {
        ++frames_;
        lines_.take(now_s());
        driver_.tick(now_s(), hands_[0].tool, hands_[1].tool);
    }
    if (milliseconds_ % kCueEvery_ms == 0) ears_.step();
}

}  // namespace handrail::core
