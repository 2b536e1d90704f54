// The second guard: a process that is started with the first and whose only work is to open the device, send zero and
// close it, when the first one dies or stands still while it holds the device. It watches by itself, so it also acts
// when the program is frozen, busy or gone. Dead: the first guard's process descriptor says so at once. Standing still:
// its count of rounds in the mailbox has not moved for kStillLooks looks of kLookMs, 100 ms. Looks are counted rather
// than time, so that a machine that gives nobody any time, or comes back from sleep, accuses nobody. A first guard that
// stands still is ended before the device is opened: two must never hold it.
// The program watches this process in the same way, by relief_beats, and replaces it (guarded_device.h). These go on
// while a driver takes its time over the zero, so only a frozen process stands still.
#pragma once

#include <functional>

#include "haptic/drivers/hand_guard.h"
#include "haptic/drivers/hand_mailbox.h"
#include "worlds/base/result.h"

namespace handrail {

inline constexpr int kLookMs = 10;
inline constexpr int kStillLooks = 10;

// Counts the looks at which a process's beats had not moved.
class StillCount {
public:
    explicit StillCount(std::uint32_t beats) : beats_(beats) {}
    // One look; looks while `may_rest` count for nothing. Returns how many looks in a row saw no new beat.
    int look(std::uint32_t newest, bool may_rest) noexcept {
        still_ = !may_rest && newest == beats_ ? still_ + 1 : 0;
        beats_ = newest;
        return still_;
    }

private:
    std::uint32_t beats_;
    int still_ = 0;
};

inline constexpr double kZeroTriesS = 2.0;         // after so long without success it is told that the device may push
inline constexpr double kZeroKeepsTryingS = 30.0;  // and tried on, more slowly: it may be plugged in again

// Opens the device, sends zero, closes it. Success: the device took it.
using ZeroDevice = std::function<Result<void>()>;

// The second guard's whole life, on the calling thread. guard_fd: readable when the first guard has ended (a process
// descriptor). life_fd: socket to the program. end_guard: ends the first guard. Returns the exit status: 0 unless the
// device may still push.
int relieve_guard(HandMailbox& mailbox, int guard_fd, int life_fd, const ZeroDevice& zero_device,
                  const std::function<void()>& end_guard);

}  // namespace handrail
