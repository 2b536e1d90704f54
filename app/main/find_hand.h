// Which hand there is. Devices are looked for and opened on a thread of their own, for both can take seconds, while the
// program is used by keyboard; what goes on is told in sentences. App thread; the search's own thread touches nothing
// but what its mutex guards.
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

namespace handrail {

// Which hand, and for a real one how the guard finds it.
struct Hand {
    HandFacts facts;
    std::vector<std::string> guard_arguments;  // empty: no real device
};

Hand simulated_hand(std::string_view name);

// What can be said of `wanted` without looking at any device: none and the simulated ones.
std::optional<Hand> hand_without_looking(const std::string& wanted);

// By name or serial number, or auto: what is plugged in. Takes up to a second. No hand and no failure: auto found
// nothing that can be used, or what is wanted has no hand.
Result<std::optional<Hand>> choose_hand(const std::string& wanted, std::vector<std::string>& news);

// A search under way, from its construction on. Destruction gives it up and waits for its thread, at most about a
// second.
class HandSearch {
public:
    struct Found {
        HandFacts facts;
        std::unique_ptr<GuardedDevice> device;  // open; null where nothing can be used, and the news say why
        std::vector<PluggedHand> plugged;       // what was there when the search began
    };

    explicit HandSearch(std::string wanted);
    ~HandSearch();
    HandSearch(const HandSearch&) = delete;
    HandSearch& operator=(const HandSearch&) = delete;

    // Sentences since the last call.
    std::vector<std::string> take_news();
    bool ready() const { return found_.ready(); }
    // Once, when ready. Fails if a device that was asked for by name is not there or cannot be used.
    Result<Found> take() { return found_.take().value_or(Found{}); }

private:
    Result<Found> search(const std::string& wanted);
    void tell(std::string sentence);

    std::mutex mutex_;  // guards news_ and opening_
    std::vector<std::string> news_;
    GuardedDevice* opening_ = nullptr;  // while it is waited for
    bool given_up_ = false;
    BackgroundTask<Result<Found>> found_{on_threads(), "hand-search"};  // last: its thread uses the others
};

// Looks every two seconds for devices that can push a hand and were not there before. Asks them nothing but their
// names, on a thread of its own.
class PlugWatch {
public:
    // known: what is not new; none: whatever the first look finds.
    explicit PlugWatch(std::optional<std::vector<PluggedHand>> known);
    ~PlugWatch();
    PlugWatch(const PlugWatch&) = delete;
    PlugWatch& operator=(const PlugWatch&) = delete;

    // Newly plugged in since the last call.
    std::vector<PluggedHand> take_new();
    // Not while a device is in use: the guard that holds it looks for it itself.
    void rest(bool resting) { resting_.store(resting, std::memory_order_relaxed); }

private:
    void run();

    std::optional<std::vector<PluggedHand>> known_;  // the watch's thread
    std::mutex mutex_;                               // guards new_ and, with ended_, the wait
    std::condition_variable wake_;
    std::vector<PluggedHand> new_;
    bool ended_ = false;
    std::atomic<bool> resting_{false};
    std::thread thread_;  // last
};

}  // namespace handrail
