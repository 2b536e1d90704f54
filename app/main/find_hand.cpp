#include "app/main/find_hand.h"

#include <algorithm>
#include <chrono>

#include "app/companions/companion_session.h"
#include "app/core/dialogue/words.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

constexpr std::chrono::seconds kLookEvery{2};

Hand real_hand(const drivers::FoundDevice& device) {
    Hand hand{core::HandFacts{true, false, *device.spec, device.serial}, {device.name}};
    if (!device.serial.empty()) hand.guard_arguments.push_back(device.serial);
    return hand;
}

}  // namespace

Hand simulated_hand(std::string_view name) {
    return {core::HandFacts{true, true, *device::find_device_spec(name), {}}, {}};
}

std::optional<Hand> hand_without_looking(const std::string& wanted) {
    if (wanted == "none") return Hand{};
    const device::DeviceSpec* spec = device::find_device_spec(wanted);
    if (spec && spec->name.starts_with("sim-")) return simulated_hand(spec->name);
    return std::nullopt;
}

Result<std::optional<Hand>> choose_hand(const std::string& wanted, std::vector<std::string>& news) {
    const device::DeviceSpec* spec = device::find_device_spec(wanted);
    const std::vector<drivers::FoundDevice> found = drivers::find_devices();
    if (wanted == "auto") {
        for (const drivers::FoundDevice& device : found) {
            if (device.kind != drivers::DeviceKind::Kinesthetic) continue;
            news.push_back(core::found_words(device.model));
            if (device.usable) return real_hand(device);
            news.push_back(device.problem);
        }
        // If no device is connected, return no news: a person who has not requested a hand does not want to hear about
        // it.
        if (!news.empty()) news.push_back(phrase("program.simulated_instead"));
        return std::nullopt;
    }
    for (const drivers::FoundDevice& device : found) {
        if (!drivers::is_meant(device, wanted)) continue;
        if (device.kind != drivers::DeviceKind::Kinesthetic) {
            news.push_back(companions::cues_and_walking_sentence(device.model));
            return std::nullopt;
        }
        if (!device.usable)
            return fail(phrase("program.not_usable_yet", {{"device", device.model}, {"problem", device.problem}}));
        return real_hand(device);
    }
    if (companions::is_companion(wanted)) {
        news.push_back(companions::no_companion_sentence(wanted));
        return std::nullopt;
    }
    if (!spec) {
        std::vector<std::string> names = device::device_names();
        for (std::string& name : drivers::companion_names()) names.push_back(std::move(name));
        for (const drivers::FoundDevice& device : found) names.push_back(device.name);
        return fail(phrase("program.no_such_device", {{"device", wanted}, {"nearest", nearest_name(wanted, names)}}));
    }
    const std::vector<std::string> drivable = drivers::openable_device_names();
    if (std::find(drivable.begin(), drivable.end(), spec->name) == drivable.end())
        return fail(phrase("program.not_driven", {{"device", spec->spoken_name()}}));
    if (drivers::is_found_only_by_opening(spec->name))
        return Hand{core::HandFacts{true, false, *spec, {}}, {std::string(spec->name)}};
    return fail(phrase("program.not_plugged", {{"device", spec->spoken_name()}}));
}

HandSearch::HandSearch(std::string wanted) {
    found_.begin([this, wanted = std::move(wanted)](const std::stop_token&) { return search(wanted); });
}

HandSearch::~HandSearch() {
    const std::lock_guard guard(mutex_);
    given_up_ = true;
    if (opening_) opening_->give_up();
}

void HandSearch::report(std::string sentence) {
    const std::lock_guard guard(mutex_);
    if (!sentence.empty()) news_.push_back(std::move(sentence));
}

std::vector<std::string> HandSearch::take_news() {
    const std::lock_guard guard(mutex_);
    return std::exchange(news_, {});
}

Result<HandSearch::Found> HandSearch::search(const std::string& wanted) {
    std::vector<drivers::PluggedHand> plugged = drivers::plugged_hands();
    std::vector<std::string> news;
    auto hand = choose_hand(wanted, news);
    for (std::string& sentence : news) report(std::move(sentence));
    if (!hand) return tl::unexpected(hand.error());
    if (!*hand) return Found{{}, nullptr, std::move(plugged)};
    auto device = std::make_unique<drivers::GuardedDevice>((*hand)->facts.spec, drivers::find_guard_program(),
                                                           (*hand)->guard_arguments);
    device->report_while_opening([this](const std::string& sentence) { report(sentence); });
    {
        const std::lock_guard guard(mutex_);
        if (given_up_) return Found{};
        opening_ = device.get();
    }
    const auto opened = device->open();
    {
        const std::lock_guard guard(mutex_);
        opening_ = nullptr;
    }
    device->report_while_opening(nullptr);
    device->take_news();  // discards the device's sentences, which were all announced while it was opening
    if (!opened) {
        report(opened.error().sentence());
        return Found{{}, nullptr, std::move(plugged)};
    }
    return Found{(*hand)->facts, std::move(device), std::move(plugged)};
}

PlugWatch::PlugWatch(std::optional<std::vector<drivers::PluggedHand>> known)
    : known_(std::move(known)), thread_([this] {
          name_this_thread("plugs");
          run();
      }) {}

PlugWatch::~PlugWatch() {
    {
        const std::lock_guard guard(mutex_);
        ended_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

std::vector<drivers::PluggedHand> PlugWatch::take_new() {
    const std::lock_guard guard(mutex_);
    return std::exchange(new_, {});
}

void PlugWatch::run() {
    if (!known_) known_ = drivers::plugged_hands();
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, kLookEvery, [this] { return ended_; })) {
        if (resting_.load(std::memory_order_relaxed)) continue;
        lock.unlock();
        std::vector<drivers::PluggedHand> there = drivers::plugged_hands();
        lock.lock();
        for (const drivers::PluggedHand& hand : there)
            if (std::find(known_->begin(), known_->end(), hand) == known_->end()) new_.push_back(hand);
        known_ = std::move(there);
    }
}

}  // namespace handrail::program
