// Hands the newest value from one producer thread to one consumer thread without locks: a triple buffer. The consumer
// always sees a complete value; values that it was too slow for are overwritten. Neither side allocates, waits or
// fails.
// The object may be in memory that another process writes too. Therefore every index read from it is masked with
// kIndex, and there are as many slots as the mask allows. Three are in use; the fourth is for an index that no correct
// process writes. So no value in that memory can cause an access outside it.
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

    // Consumer thread only. True if a newer value was published since the last call; read() then returns it.
    bool refresh() {
        if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
        front_ = middle_.exchange(front_ & kIndex, std::memory_order_acq_rel) & kIndex;
        return true;
    }
    // Consumer thread only. Returns the value that the last refresh() took.
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
