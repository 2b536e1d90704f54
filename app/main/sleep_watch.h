// Removes the force before the computer sleeps. A suspended program commands nothing, and a device with its own power
// would hold the last force. logind announces each sleep and waits, by default up to 5 s, for programs that hold a
// delay inhibitor. The app thread owns one SleepWatch for the program. Its separate thread talks to logind over the
// system bus and never waits for an answer. Without a bus or logind it does nothing.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include "worlds/base/descriptor.h"

struct DBusConnection;
struct DBusMessage;

namespace handrail::program {

class SleepWatch {
public:
    // `release` runs on the watch's thread as soon as logind announces a sleep. It must not wait.
    explicit SleepWatch(std::function<void()> release);
    ~SleepWatch();
    SleepWatch(const SleepWatch&) = delete;
    SleepWatch& operator=(const SleepWatch&) = delete;

    // Any thread. True while the computer waits for us. Call let_sleep() only when no force is left. After kMostDelay_s
    // the watch lets the computer sleep in any case.
    bool delays_sleep() const;
    void let_sleep();
    // App thread: true once after each sleep.
    bool take_woken() { return woken_.exchange(false); }

    static constexpr double kMostDelay_s = 1.0;

private:
    void run(const std::stop_token& end);
    void take(DBusMessage* message);
    void subscribe();
    void inhibit();

    std::function<void()> release_;
    // Used by the watch's thread.
    DBusConnection* bus_ = nullptr;
    unsigned hello_ = 0, inhibit_ = 0;  // serial numbers of calls
    double announced_s_ = 0.0;

    mutable std::mutex mutex_;
    Descriptor inhibitor_{-1};  // under mutex_; logind waits until it is closed
    bool delaying_ = false;     // under mutex_
    std::atomic<bool> woken_{false};
    std::jthread thread_;
};

}  // namespace handrail::program
