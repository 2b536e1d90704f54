// Removes the force before the computer sleeps. A suspended program sends no commands, and a device with its own power
// supply would keep applying the last force. logind announces each sleep and waits, by default up to 5 s, for programs
// that have a delay inhibitor. The app thread owns one SleepWatch for the program. A separate thread talks to logind
// over the system bus and never waits for an answer. If there is no bus or no logind, the class does nothing.
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
    // Calls `release` on the thread of this object as soon as logind announces a sleep. `release` must not wait.
    explicit SleepWatch(std::function<void()> release);
    ~SleepWatch();
    SleepWatch(const SleepWatch&) = delete;
    SleepWatch& operator=(const SleepWatch&) = delete;

    // delays_sleep() returns true while logind delays the sleep because of our inhibitor. Call let_sleep() once no
    // force is left. After kMostDelay_s, the thread of this object lets the computer sleep in any case. Any thread may
    // call both functions.
    bool delays_sleep() const;
    void let_sleep();
    // Returns true once after each sleep. App thread.
    bool take_woken() { return woken_.exchange(false); }

    static constexpr double kMostDelay_s = 1.0;

private:
    void run(const std::stop_token& end);
    void take(DBusMessage* message);
    void subscribe();
    void inhibit();

    std::function<void()> release_;
    // Members that only the thread of this object uses.
    DBusConnection* bus_ = nullptr;
    unsigned hello_ = 0, inhibit_ = 0;  // serial numbers of calls whose answers are awaited
    double announced_s_ = 0.0;

    mutable std::mutex mutex_;
    Descriptor inhibitor_{-1};  // guarded by mutex_; logind delays the sleep until this descriptor is closed
    bool delaying_ = false;     // guarded by mutex_; true while logind delays the sleep because of our inhibitor
    std::atomic<bool> woken_{false};
    std::jthread thread_;
};

}  // namespace handrail::program
