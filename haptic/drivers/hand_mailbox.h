// What the program and its two guard processes share: the newest force one way, the newest sample the other, and what
// each guard is about, in memory that all map. Nobody waits for another or takes a lock, and nobody trusts what stands
// here further than a force or a sample goes. All are built from the same sources; kMailboxMark is compared all the
// same.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "haptic/device/haptic_device.h"
#include "worlds/base/latest_value.h"

namespace handrail {

// What the second guard is about.
enum class ReliefState : std::uint8_t {
    Watching,  // the first guard holds the device, or nothing is to be held yet
    Zeroing,   // the first guard is gone, or is being ended; the device may push
    Zero,      // the device took a force of zero, or the first guard had let it go before it ended
    Failed,    // the device could not be reached; it may push
};

struct HandMailbox {
    static constexpr std::uint64_t kMailboxMark =
        0x68616e647261696cULL + sizeof(ForceCommand) * 256 + sizeof(DeviceSample);

    std::uint64_t mark = kMailboxMark;
    LatestValue<ForceCommand> command;    // program -> guard; device frame
    LatestValue<DeviceSample> answer;     // guard -> program; one for each exchange
    std::atomic<std::uint32_t> beats{0};  // the guard counts its rounds, at least one in 5 ms while it holds the device
    std::atomic<std::uint32_t> relief_beats{0};              // the second guard counts its looks, one in 10 ms
    std::atomic<bool> holds{false};                          // the guard's: a device is open, so it may push
    std::atomic<ReliefState> relief{ReliefState::Watching};  // the second guard's
    std::atomic<bool> memory_locked{true},
        spared{true};  // either guard sets false: its memory may be swapped out; it may be ended for want of memory
};

static_assert(std::is_trivially_copyable_v<ForceCommand> && std::is_trivially_copyable_v<DeviceSample>);
static_assert(std::atomic<std::uint8_t>::is_always_lock_free && std::atomic<std::uint32_t>::is_always_lock_free &&
                  std::atomic<bool>::is_always_lock_free,
              "a lock in shared memory would be held by a dead program for ever");

}  // namespace handrail
