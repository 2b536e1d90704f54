// An interface for real time, passed in so that every test can control the time. SteadyClock and VirtualClock implement
// it.
#pragma once

#include <atomic>

namespace handrail {

class Clock {
public:
    virtual ~Clock() = default;
    virtual double now_s() const = 0;  // seconds since an arbitrary start; never goes back; callable from any thread
    virtual void sleep_until_s(double time_s) = 0;  // returns at once if the time has passed
};

// Uses CLOCK_MONOTONIC and sleeps until absolute times, so that pacing does not drift.
class SteadyClock final : public Clock {
public:
    double now_s() const override;
    void sleep_until_s(double time_s) override;
};

// Time that moves only when the owner advances it; sleeping advances it too. Any thread may read, one thread advances.
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
