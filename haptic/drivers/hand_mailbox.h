// Lays out the memory that the program and its two guard processes share. It contains the newest force for the device,
// the newest sample from the device, and the state of each guard. No process waits for another or takes a lock. Each
// process validates the forces and samples that it reads and trusts nothing else. All three processes are built from
// the same sources, but they compare kMailboxMark anyway.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "haptic/device/haptic_device.h"
#include "worlds/base/latest_value.h"

namespace handrail::drivers {

// State of the second guard.
enum class ReliefState : std::uint8_t {
    Watching,  // the first guard holds the device, or no device is open yet
    Zeroing,   // the first guard has ended or is being killed; the device may push
    Zero,      // the device accepted a force of zero, or the first guard released the device before it ended
    Failed,    // the second guard could not reach the device, which may push
};

struct HandMailbox {
    static constexpr std::uint64_t kMailboxMark =
        0x68616e647261696cULL + sizeof(device::ForceCommand) * 256 + sizeof(device::DeviceSample);

    std::uint64_t mark = kMailboxMark;
    LatestValue<device::ForceCommand> command;  // from the program to the guard; device frame
    LatestValue<device::DeviceSample> answer;   // guard to program; one sample for each exchange
    // Number of the guard's rounds, at least one in 5 ms while it holds the device.
    std::atomic<std::uint32_t> beats{0};
    std::atomic<std::uint32_t> relief_beats{0};  // number of the second guard's checks, one in 10 ms
    std::atomic<bool> holds{false};              // set by the guard while a device is open, which may then push
    std::atomic<ReliefState> relief{ReliefState::Watching};  // state of the second guard, which alone writes it
    std::atomic<bool> memory_locked{true},
        // The guards set memory_locked to false if their memory may be swapped out, and spared to false if the kernel
        // may kill them when memory runs out.
        spared{true};
};

static_assert(std::is_trivially_copyable_v<device::ForceCommand> && std::is_trivially_copyable_v<device::DeviceSample>);
static_assert(std::atomic<std::uint8_t>::is_always_lock_free && std::atomic<std::uint32_t>::is_always_lock_free &&
                  std::atomic<bool>::is_always_lock_free,
              "a lock in shared memory would be held by a dead program for ever");

}  // namespace handrail::drivers
