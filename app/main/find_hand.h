// Decides which hand is used. Devices are searched and opened on a separate thread, as both can take seconds, while the
// person already uses the program by keyboard. Sentences report the progress. App thread; the search thread touches
// only what its mutex guards.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/core/session/session.h"
#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guarded_device.h"
#include "worlds/base/background_task.h"

namespace handrail::program {

// The chosen hand and, for a real device, how the guard finds it.
struct Hand {
    core::HandFacts facts;
    std::vector<std::string> guard_arguments;  // empty: no real device
};

Hand simulated_hand(std::string_view name);

// The hand that `wanted` names, if no device must be searched for that: none, or a simulated one.
std::optional<Hand> hand_without_looking(const std::string& wanted);

// Chooses by name or serial number, or with "auto" from what is connected. Takes up to a second. Success without a hand
// means that "auto" found nothing usable, or that the wanted device has no hand.
Result<std::optional<Hand>> choose_hand(const std::string& wanted, std::vector<std::string>& news);

// A search, which begins on construction. Destruction cancels it and waits for its thread, at most about a second.
class HandSearch {
public:
    struct Found {
        core::HandFacts facts;
        std::unique_ptr<drivers::GuardedDevice> device;  // open; null if no device can be used, and the news say why
        std::vector<drivers::PluggedHand> plugged;       // what was connected when the search began
    };

    explicit HandSearch(std::string wanted);
    ~HandSearch();
    HandSearch(const HandSearch&) = delete;
    HandSearch& operator=(const HandSearch&) = delete;

    // Returns the sentences since the last call.
    std::vector<std::string> take_news();
    bool ready() const { return found_.ready(); }
    // Returns the result once, when ready. Fails if a device that was requested by name is missing or cannot be used.
    Result<Found> take() { return found_.take().value_or(Found{}); }

private:
    Result<Found> search(const std::string& wanted);
    void tell(std::string sentence);

    std::mutex mutex_;  // guards news_ and opening_
    std::vector<std::string> news_;
    drivers::GuardedDevice* opening_ = nullptr;  // set while its opening is awaited
    bool given_up_ = false;
    BackgroundTask<Result<Found>> found_{on_threads(), "hand-search"};  // last: its thread uses the others
};

// Looks every two seconds for newly connected force devices. It only reads their names, and runs on a separate thread.
class PlugWatch {
public:
    // `known` lists the devices that are not new. Without a list, whatever the first look finds is not new.
    explicit PlugWatch(std::optional<std::vector<drivers::PluggedHand>> known);
    ~PlugWatch();
    PlugWatch(const PlugWatch&) = delete;
    PlugWatch& operator=(const PlugWatch&) = delete;

    // The devices connected since the last call.
    std::vector<drivers::PluggedHand> take_new();
    // Rests while a device is in use, because the guard that holds it looks for it itself.
    void rest(bool resting) { resting_.store(resting, std::memory_order_relaxed); }

private:
    void run();

    std::optional<std::vector<drivers::PluggedHand>> known_;  // used by the watch's thread
    std::mutex mutex_;                                        // guards new_, and together with ended_ the wait
    std::condition_variable wake_;
    std::vector<drivers::PluggedHand> new_;
    bool ended_ = false;
    std::atomic<bool> resting_{false};
    std::thread thread_;  // last: its thread uses the others
};

}  // namespace handrail::program
