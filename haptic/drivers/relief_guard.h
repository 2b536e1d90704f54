// The second guard: a process started with the first. Its only task is to open the device, send zero and close it if
// the first guard dies or freezes while it holds the device. It watches independently, so it also acts when the program
// is frozen, busy or gone. If the first guard dies, its process descriptor reports that at once. It counts as frozen if
// its count of rounds in the mailbox has not moved for kStillLooks looks of kLookMs, 100 ms. Looks are counted instead
// of time, so that a machine that starves all processes, or wakes from sleep, raises no false alarm. A frozen first
// guard is killed before the device is opened, because two must never hold it.
//
// The program watches this process in the same way, by relief_beats, and replaces it (guarded_device.h). The beats
// continue while a driver takes its time over the zero, so only a frozen process counts as frozen.
#pragma once

#include <functional>

#include "haptic/drivers/hand_guard.h"
#include "haptic/drivers/hand_mailbox.h"
#include "worlds/base/result.h"

namespace handrail::drivers {

inline constexpr int kLookMs = 10;
inline constexpr int kStillLooks = 10;

// Counts the looks at which a process's beats had not moved.
class StillCount {
public:
    explicit StillCount(std::uint32_t beats) : beats_(beats) {}
    // One look. Looks while `may_rest` is true do not count. Returns how many looks in a row saw no new beat.
    int look(std::uint32_t newest, bool may_rest) noexcept {
        still_ = !may_rest && newest == beats_ ? still_ + 1 : 0;
        beats_ = newest;
        return still_;
    }

private:
    std::uint32_t beats_;
    int still_ = 0;
};

inline constexpr double kZeroTriesS = 2.0;  // after this long without success it reports that the device may push
// Then it continues this long, more slowly, because the device may be plugged in again.
inline constexpr double kZeroKeepsTryingS = 30.0;

// Opens the device, sends zero, closes it. Succeeds if the device accepted the zero.
using ZeroDevice = std::function<Result<void>()>;

// Runs the second guard for its whole life, on the calling thread. guard_fd: process descriptor, readable after the
// first guard has ended. life_fd: socket to the program. end_guard: kills the first guard. Returns the exit status: 0
// unless the device may still push.
int relieve_guard(HandMailbox& mailbox, int guard_fd, int life_fd, const ZeroDevice& zero_device,
                  const std::function<void()>& end_guard);

}  // namespace handrail::drivers
