// Hands the newest value from one producer thread to one consumer thread without locks: a triple buffer. The consumer
// always sees a whole value; values it was too slow for are overwritten. Neither side allocates, waits or fails.
// It may lie in memory that another process writes too: every index that is read from it is masked to kIndex, and there
// are as many slots as the mask lets through (three in use, the fourth for an index that no sound process writes), so
// whatever stands there, nothing outside is touched.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace handrail {

template <class T>
class LatestValue {
public:
    LatestValue() = default;
    explicit LatestValue(const T& first) { slots_.fill(first); }

    // Producer thread only.
    void publish(const T& value) {
        slots_[back_ & kIndex] = value;
        const std::uint8_t old =
            middle_.exchange(static_cast<std::uint8_t>((back_ & kIndex) | kFresh), std::memory_order_acq_rel);
        back_ = old & kIndex;
    }

    // Consumer thread only. True if something newer than the last call had been published; read() then shows it.
    bool refresh() {
        if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
        front_ = middle_.exchange(front_ & kIndex, std::memory_order_acq_rel) & kIndex;
        return true;
    }
    // Consumer thread only. The value taken by the last refresh().
    const T& read() const { return slots_[front_ & kIndex]; }

private:
    static constexpr std::uint8_t kFresh = 4;
    static constexpr std::uint8_t kIndex = 3;
    std::array<T, kIndex + 1> slots_{};
    std::atomic<std::uint8_t> middle_{1};
    std::uint8_t back_ = 0;   // producer thread only
    std::uint8_t front_ = 2;  // consumer thread only
};

}  // namespace handrail
