// Defines an interface for real time, which SteadyClock and VirtualClock implement. Each object that needs the time
// receives a clock from its owner, so every test can control the time.
#pragma once

#include <atomic>

namespace handrail {

class Clock {
public:
    virtual ~Clock() = default;
    virtual double now_s() const = 0;  // seconds since an arbitrary start; never decreases; any thread may call it
    virtual void sleep_until_s(double time_s) = 0;  // sleeps until `time_s`; returns at once if that time has passed
};

// The real clock of the system. It uses CLOCK_MONOTONIC and sleeps until absolute times, so that pacing does not drift.
class SteadyClock final : public Clock {
public:
    double now_s() const override;
    void sleep_until_s(double time_s) override;
};

// A clock that advances only when its owner advances it or when a caller sleeps. Any thread may read the time; only one
// thread may advance it.
class VirtualClock final : public Clock {
public:
    double now_s() const override { return now_s_.load(std::memory_order_acquire); }
    void sleep_until_s(double time_s) override {
        if (time_s > now_s()) now_s_.store(time_s, std::memory_order_release);
    }
    void advance_s(double seconds) { sleep_until_s(now_s() + seconds); }

private:
    std::atomic<double> now_s_{0.0};
};

}  // namespace handrail
