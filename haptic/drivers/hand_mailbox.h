// What the program and the guard process share: the newest force one way, the newest sample the other, in memory that both map. Neither side
// waits for the other or takes a lock. Both are built from the same sources; kMailboxMark is compared all the same.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "haptic/device/haptic_device.h"
#include "worlds/base/latest_value.h"

namespace handrail {

struct HandMailbox {
    static constexpr std::uint64_t kMailboxMark = 0x68616e647261696cULL + sizeof(ForceCommand) * 256 + sizeof(DeviceSample);

    std::uint64_t mark = kMailboxMark;
    LatestValue<ForceCommand> command;  // program -> guard; device frame
    LatestValue<DeviceSample> answer;   // guard -> program; one for each exchange
};

static_assert(std::is_trivially_copyable_v<ForceCommand> && std::is_trivially_copyable_v<DeviceSample>);
static_assert(std::atomic<std::uint8_t>::is_always_lock_free, "a lock in shared memory would be held by a dead program for ever");

}  // namespace handrail
