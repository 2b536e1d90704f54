#include "app/main/hand_in_use.h"

#include <fmt/ostream.h>

#include <utility>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

constexpr double kServoPeriod_s = 1e-3;

}  // namespace

// ---- the current hand ----

void HandInUse::let_go() {
    if (servo_) servo_->stop();
    if (servo_ && guarded_) report_guard();
}

void HandInUse::report_guard() {
    for (std::string& sentence : guarded_->take_news()) parts_.say(std::move(sentence));
}

// Replaces the current hand. `device` is the opened device, or null for a simulated hand or none.
void HandInUse::use(const core::HandFacts& facts, std::unique_ptr<drivers::GuardedDevice> device) {
    let_go();
    parts_.driver.drive(0, nullptr);
    servo_.reset();
    simulated_.reset();
    guarded_ = device.get();
    facts_ = facts;
    core::Session& app = parts_.app;
    const settings::Settings& settings = parts_.settings.values();
    tool_ = {};
    scheduling_reported_ = guard_missed_ = false;
    app.apply(core::HandChanged{facts, settings, facts.simulated && wanted() == "auto"}, parts_.clock.now_s());
    if (!facts.present) return;
    std::unique_ptr<device::HapticDevice> held = std::move(device);
    if (facts.simulated) {
        simulated_ = std::make_shared<device::SimulatedHand>();
        held = std::make_unique<device::SimulatedDevice>(facts.spec, simulated_);
    }
    servo_ = std::make_unique<servo::ServoLoop>(
        std::move(held), parts_.clock, kServoPeriod_s,
        servo::ServoLoop::Links{&parts_.switches, &parts_.contacts, parts_.recording});
    if (const auto opened = servo_->open(); opened) {
        parts_.driver.drive(0, servo_.get(), simulated_);
        return servo_->start();
    }
    // The device was open a moment ago, so this failure means that the device was disconnected since then.
    servo_.reset();
    guarded_ = nullptr;
    facts_ = {};
    app.apply(core::HandChanged{{}, settings}, parts_.clock.now_s());
}

void HandInUse::read() {
    if (servo_) tool_ = servo_->tool();
}

void HandInUse::report_scheduling() {
    if (!guarded_) return;
    if (const servo::ServoReport& report = servo_->report();
        !scheduling_reported_ && report.scheduling != servo::Scheduling::NotStarted) {
        scheduling_reported_ = true;
        if (report.scheduling == servo::Scheduling::Ordinary) parts_.say(servo::scheduling_sentence(report.scheduling));
        if (!report.memory_locked) parts_.say(servo::memory_sentence(report.memory_locked));
        for (std::string& sentence : guarded_->unprotected())  // unprotected() reports each limit only once
            if (report.memory_locked || sentence != phrase("guard.memory_not_locked")) parts_.say(std::move(sentence));
    }
    report_guard();
}

void HandInUse::watch_sleep(const servo::ToolState* left) {
    if (!sleep_ && (guarded_ || left)) sleep_.emplace([this] { parts_.switches.stop(); });
    if (!sleep_) return;
    const bool no_force = tool_.force_n == Vec3(0.0) && (!left || left->force_n == Vec3(0.0));
    if (no_force && sleep_->delays_sleep()) sleep_->let_sleep();
    if (sleep_->take_woken()) parts_.say(phrase("program.has_slept"));
}

// ---- the search and newly connected devices ----

void HandInUse::begin(double requested_s) {
    requested_s_ = requested_s;
    const std::string name = wanted();
    const auto hand = hand_without_looking(name);
    if (hand) use(hand->facts, nullptr);
    else if (name == "auto") use(simulated_hand("sim-t").facts, nullptr);
    if (!hand) search_.emplace(name);
    else if (name != "none") plug_watch_.emplace(std::nullopt);
}

void HandInUse::begin_for_set_up() {
    const std::string name = wanted();
    if (const auto hand = hand_without_looking(name)) use(hand->facts, nullptr);
    else search_.emplace(name);
}

void HandInUse::look_for_set_up(std::vector<std::string>& news) {
    if (!search_) return;
    const bool ready = search_->ready();
    for (std::string& sentence : search_->take_news()) news.push_back(std::move(sentence));
    if (!ready) return;
    auto found = search_->take();
    search_.reset();
    if (!found) news.push_back(found.error().sentence());
    else if (found->device) use(found->facts, std::move(found->device));
}

bool HandInUse::can_be_set_up() const { return servo_ && (guarded_ || (simulated_ && hand_without_looking(wanted()))); }

bool HandInUse::look(std::ostream& err) {
    if (plug_watch_) plug_watch_->rest(search_.has_value() || guarded_ != nullptr);
    if (search_) {
        const bool ready = search_->ready();
        for (std::string& sentence : search_->take_news()) parts_.say(std::move(sentence), requested_s_);
        return !ready || take_found(err);
    }
    if (parts_.app.requests().take_offered_hand() && offer_) {
        requested_s_ = parts_.clock.now_s();
        parts_.say(phrase("program.opening", {{"device", offer_->spoken_name}}), requested_s_);
        search_.emplace(offer_->name);
        return true;
    }
    look_at_plugs();
    return true;
}

bool HandInUse::take_found(std::ostream& err) {
    auto found = search_->take();
    search_.reset();
    if (!plug_watch_) plug_watch_.emplace(found ? std::optional(std::move(found->plugged)) : std::nullopt);
    if (!found) return do_without(found.error(), err);
    if (!found->device) return true;
    use(found->facts, std::move(found->device));
    offer_calibration();
    return true;
}

// Continues although the wanted device is not available. Returns false if the session cannot continue.
bool HandInUse::do_without(const Error& problem, std::ostream& err) {
    parts_.say(problem.sentence());
    // The lost device will not come back, so a simulated hand replaces it.
    if (guarded_) use(simulated_hand("sim-t").facts, nullptr);
    if (servo_) return true;  // the current hand remains in use
    if (parts_.arguments.device) {
        fmt::print(err, "{}\n", problem.sentence());
        return false;
    }
    parts_.say(phrase("program.simulated_instead_plug"));
    use(simulated_hand("sim-t").facts, nullptr);
    return true;
}

void HandInUse::look_at_plugs() {
    if (guarded_ && !guard_missed_ && guarded_->guard_ended()) {
        guard_missed_ = true;
        const device::DeviceSpec& spec = servo_->device_spec();
        offer(drivers::PluggedHand{std::string(spec.name), spec.spoken_name(), {}, {}});
    }
    if (!plug_watch_) return;
    for (drivers::PluggedHand& hand : plug_watch_->take_new()) {
        if (hand.problem.empty()) offer(std::move(hand));
        else parts_.say(core::found_words(hand.spoken_name) + " " + hand.problem);
    }
}

void HandInUse::offer(drivers::PluggedHand hand) {
    parts_.app.apply(core::HandOffered{hand.spoken_name}, parts_.clock.now_s());
    offer_ = std::move(hand);
}

// Offers to set up the current device if the device has no profile yet.
void HandInUse::offer_calibration() {
    if (parts_.settings.values().profiles.contains(settings::profile_key(facts_.spec.name, facts_.serial))) return;
    parts_.say(phrase("program.not_set_up", {{"device", facts_.spec.spoken_name()},
                                             {"keys", parts_.app.keys().keys_of(core::Command::Calibrate)}}),
               requested_s_);
}

}  // namespace handrail::program
