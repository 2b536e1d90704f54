// Shared memory of the program and its two guard processes: the newest force one way, the newest sample the other way,
// and the state of each guard. No process waits for another or takes a lock. A process trusts nothing in it beyond the
// range of a force or a sample. All are built from the same sources; kMailboxMark is compared all the same.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "haptic/device/haptic_device.h"
#include "worlds/base/latest_value.h"

namespace handrail::drivers {

// What the second guard is doing.
enum class ReliefState : std::uint8_t {
    Watching,  // the first guard holds the device, or there is nothing to hold yet
    Zeroing,   // the first guard is gone or is being killed; the device may push
    Zero,      // the device accepted a force of zero, or the first guard released it before it ended
    Failed,    // the device could not be reached; it may push
};

struct HandMailbox {
    static constexpr std::uint64_t kMailboxMark =
        0x68616e647261696cULL + sizeof(device::ForceCommand) * 256 + sizeof(device::DeviceSample);

    std::uint64_t mark = kMailboxMark;
    LatestValue<device::ForceCommand> command;  // program to guard; device frame
    LatestValue<device::DeviceSample> answer;   // guard to program; one for each exchange
    std::atomic<std::uint32_t> beats{0};  // counts the guard's rounds, at least one in 5 ms while it holds the device
    std::atomic<std::uint32_t> relief_beats{0};              // counts the second guard's looks, one in 10 ms
    std::atomic<bool> holds{false};                          // set by the guard: a device is open, so it may push
    std::atomic<ReliefState> relief{ReliefState::Watching};  // set by the second guard
    std::atomic<bool> memory_locked{true},
        // A guard sets false if its memory may be swapped out, or if it may be killed when memory runs out.
        spared{true};
};

static_assert(std::is_trivially_copyable_v<device::ForceCommand> && std::is_trivially_copyable_v<device::DeviceSample>);
static_assert(std::atomic<std::uint8_t>::is_always_lock_free && std::atomic<std::uint32_t>::is_always_lock_free &&
                  std::atomic<bool>::is_always_lock_free,
              "a lock in shared memory would be held by a dead program for ever");

}  // namespace handrail::drivers
