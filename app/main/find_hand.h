// Decides which hand the session uses. A separate thread searches for devices and opens them, because this can take
// seconds. Meanwhile the person already uses the program by keyboard. The search reports its progress in sentences. App
// thread; the search thread accesses only what its mutex guards.
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

// The chosen hand and, for a real device, the arguments with which its guard finds it.
struct Hand {
    core::HandFacts facts;
    std::vector<std::string> guard_arguments;  // arguments of the guard; empty: the device is not real
};

Hand simulated_hand(std::string_view name);

// Returns the hand that `wanted` names if no search for devices is needed: no hand, or a simulated one.
std::optional<Hand> hand_without_looking(const std::string& wanted);

// Chooses a hand by name or serial number, or with "auto" from the connected devices. Takes up to a second. Returns no
// hand if "auto" found nothing usable, or if the wanted device has no hand.
Result<std::optional<Hand>> choose_hand(const std::string& wanted, std::vector<std::string>& news);

// A search for a hand, which begins on construction. The destructor cancels it and waits for its thread, at most about
// a second.
class HandSearch {
public:
    struct Found {
        core::HandFacts facts;
        // The opened device. If it is null, no device can be used, and the news say why.
        std::unique_ptr<drivers::GuardedDevice> device;
        std::vector<drivers::PluggedHand> plugged;  // devices that were connected when the search began
    };

    explicit HandSearch(std::string wanted);
    ~HandSearch();
    HandSearch(const HandSearch&) = delete;
    HandSearch& operator=(const HandSearch&) = delete;

    // Returns the sentences that are new since the last call.
    std::vector<std::string> take_news();
    bool ready() const { return found_.ready(); }
    // Returns the result once, when it is ready. Fails if a device that was requested by name is missing or cannot be
    // used.
    Result<Found> take() { return found_.take().value_or(Found{}); }

private:
    Result<Found> search(const std::string& wanted);
    void report(std::string sentence);

    std::mutex mutex_;  // guards news_ and opening_
    std::vector<std::string> news_;
    drivers::GuardedDevice* opening_ = nullptr;  // the device whose opening the search thread waits for; null: none
    bool given_up_ = false;
    // Declared last, because its thread uses the other members.
    BackgroundTask<Result<Found>> found_{on_threads(), "hand-search"};
};

// Checks every two seconds whether a force device was newly connected. It only reads the names of devices, on a
// separate thread.
class PlugWatch {
public:
    // `known` lists the devices that are not new. Without a list, the devices found by the first check are not new.
    explicit PlugWatch(std::optional<std::vector<drivers::PluggedHand>> known);
    ~PlugWatch();
    PlugWatch(const PlugWatch&) = delete;
    PlugWatch& operator=(const PlugWatch&) = delete;

    // Returns the devices that were connected since the last call.
    std::vector<drivers::PluggedHand> take_new();
    // Pauses or resumes the checks. They must pause while a device is in use, because the guard process of that device
    // itself checks whether the device is connected.
    void rest(bool resting) { resting_.store(resting, std::memory_order_relaxed); }

private:
    void run();

    std::optional<std::vector<drivers::PluggedHand>> known_;  // used only by the thread of this object
    std::mutex mutex_;                                        // guards new_; together with ended_, lets the thread wait
    std::condition_variable wake_;
    std::vector<drivers::PluggedHand> new_;
    bool ended_ = false;
    std::atomic<bool> resting_{false};
    std::thread thread_;  // declared last, because it uses the other members
};

}  // namespace handrail::program
