#include "app/companions/companion_devices.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/core/dialogue/words.h"
#include "worlds/base/contract.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"

namespace handrail::companions {
namespace {

constexpr unsigned kButtons = 14;

double together(double a, double b) { return std::clamp(a + b, -1.0, 1.0); }

}  // namespace

std::optional<core::Command> command_of(drivers::CompanionButton button) {
    static constexpr std::array<std::optional<core::Command>, kButtons> kMeans{
        core::Command::WhereAmI, core::Command::WhatIsThis, core::Command::Repeat, core::Command::Heading,
        core::Command::TurnLeft, core::Command::TurnRight, core::Command::StopSpeech, core::Command::StopEverything,
        core::Command::Home, std::nullopt,
        // The last four are the buttons up, right, down and left, in the order of CompanionButton.
        core::Command::Forward, core::Command::TurnRight, core::Command::Back, core::Command::TurnLeft};
    return kMeans.at(static_cast<std::size_t>(button));
}

void CompanionDevices::start() {
    if (!thread_.joinable())
        thread_ = std::thread([this] {
            name_this_thread("companions");
            run();
        });
}

void CompanionDevices::stop() {
    stop_requested_.store(true, std::memory_order_release);
    if (thread_.joinable()) thread_.join();
    plugged_.clear();
    count_ = 0;
}

core::Steering CompanionDevices::steering() {
    const std::lock_guard guard(mutex_);
    return steering_;
}

std::vector<core::Command> CompanionDevices::take_commands() {
    const std::lock_guard guard(mutex_);
    return std::exchange(commands_, {});
}

std::vector<std::string> CompanionDevices::take_news() {
    const std::lock_guard guard(mutex_);
    return std::exchange(news_, {});
}

void CompanionDevices::give(const device::FingerCue& cue) {
    contract_pre(cue.nearness >= 0.0 && cue.nearness <= 1.0 && cue.hardness >= 0.0 && cue.hardness <= 1.0);
    const std::lock_guard guard(mutex_);
    cue_ = cue;
}

void CompanionDevices::run() {
    double next_s = clock_.now_s();
    while (!stop_requested_.load(std::memory_order_acquire)) {
        step();
        next_s = std::max(next_s + (plugged_.empty() ? 10.0 * kPeriod_s : kPeriod_s), clock_.now_s());
        clock_.sleep_until_s(next_s);
    }
    plugged_.clear();
}

// Finds, opens and announces new devices. If opening a device fails, this function tries again only after the device
// was disconnected.
void CompanionDevices::look_around(double now_s) {
    looked_s_ = now_s;
    std::vector<drivers::FoundCompanion> found = drivers::find_companions();
    std::erase_if(refused_, [&](const std::string& path) {
        return std::none_of(found.begin(), found.end(), [&](const auto& f) { return f.path == path; });
    });
    std::vector<std::string> news;
    for (drivers::FoundCompanion& one : found) {
        const bool known =
            refused_.contains(one.path) ||
            std::any_of(plugged_.begin(), plugged_.end(), [&](const Plugged& p) { return p.found.path == one.path; });
        if (known) continue;
        auto opened = drivers::open_companion(one);
        if (!opened) {
            refused_.insert(one.path);
            news.push_back(opened.error().sentence());
            continue;
        }
        news.push_back(core::found_words(one.model) + " " + one.how_to);
        Plugged plugged;
        plugged.found = std::move(one);
        plugged.device = std::move(*opened);
        plugged_.push_back(std::move(plugged));
    }
    const std::lock_guard guard(mutex_);
    news_.insert(news_.end(), std::make_move_iterator(news.begin()), std::make_move_iterator(news.end()));
}

// Reads a device and sends `cue` to it. Returns false if the device was disconnected.
bool CompanionDevices::serve(Plugged& plugged, const device::FingerCue& cue, double now_s, core::Steering& sum) {
    const std::uint32_t was = plugged.state.buttons;
    if (!plugged.device->read(plugged.state, now_s)) return false;
    sum = {together(sum.ahead, plugged.state.ahead), together(sum.right, plugged.state.right),
           together(sum.turn_right, plugged.state.turn_right),
           sum.cane_right_rad_per_s + plugged.state.yaw_right_rad_per_s};
    for (unsigned i = 0; i < kButtons; ++i) {
        if (!((plugged.state.buttons & ~was) >> i & 1U)) continue;
        const std::lock_guard guard(mutex_);
        if (const auto command = command_of(static_cast<drivers::CompanionButton>(i))) commands_.push_back(*command);
    }
    const bool due =
        cue != plugged.sent ? now_s - plugged.sent_s >= kCueEvery_s : now_s - plugged.sent_s >= kCueAgain_s;
    if (!due) return true;
    plugged.sent = cue;
    plugged.sent_s = now_s;
    return plugged.device->cue(cue);
}

void CompanionDevices::step() {
    const double now_s = clock_.now_s();
    if (now_s - looked_s_ >= kLookAgain_s) look_around(now_s);
    device::FingerCue cue;
    {
        const std::lock_guard guard(mutex_);
        cue = cue_;
    }
    core::Steering sum;
    std::vector<std::string> gone;
    std::erase_if(plugged_, [&](Plugged& plugged) {
        if (serve(plugged, cue, now_s, sum)) return false;
        gone.push_back(phrase("companion.unplugged", {{"device", plugged.found.model}}));
        return true;
    });
    count_ = plugged_.size();
    const std::lock_guard guard(mutex_);
    steering_ = sum;
    news_.insert(news_.end(), std::make_move_iterator(gone.begin()), std::make_move_iterator(gone.end()));
}

}  // namespace handrail::companions
