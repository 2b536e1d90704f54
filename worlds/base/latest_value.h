// Hands the newest value from one producer thread to one consumer thread without locks: a triple buffer. The consumer
// always sees a complete value and misses values that were overwritten before it read them. Neither side allocates,
// waits or fails.
//
// Another process may also write the memory of this object. So every index that is read from this memory is masked with
// kIndex, and there are as many slots as the mask allows: four. Three slots are in use. The fourth exists only because
// a faulty process may write its index. So no value in that memory can cause an access outside of it.
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

    // Makes `value` the newest one. Producer thread only.
    void publish(const T& value) {
        slots_[back_ & kIndex] = value;
        const std::uint8_t old =
            middle_.exchange(static_cast<std::uint8_t>((back_ & kIndex) | kFresh), std::memory_order_acq_rel);
        back_ = old & kIndex;
    }

    // Switches to the newest value, which read() then returns. Returns true if a value was published since the last
    // call. Consumer thread only.
    bool refresh() {
        if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
        front_ = middle_.exchange(front_ & kIndex, std::memory_order_acq_rel) & kIndex;
        return true;
    }
    // Returns the value to which the last refresh() switched. Consumer thread only.
    const T& read() const { return slots_[front_ & kIndex]; }

private:
    static constexpr std::uint8_t kFresh = 4;
    static constexpr std::uint8_t kIndex = 3;
    std::array<T, kIndex + 1> slots_{};
    std::atomic<std::uint8_t> middle_{1};
    std::uint8_t back_ = 0;   // slot that the producer writes next; producer thread only
    std::uint8_t front_ = 2;  // slot that the consumer reads; consumer thread only
};

}  // namespace handrail
