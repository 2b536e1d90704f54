// Implements the second guard, a process that is started together with the first guard. It acts only if the first guard
// dies or freezes while it holds a device. Then it opens the device, sends zero and closes the device. It watches
// independently of the program, so it also acts when the program is frozen, busy or gone. If the first guard dies, its
// process descriptor reports that at once. The first guard has frozen if its count of rounds in the mailbox does not
// change for kStillLooks checks of kLookMs each, 100 ms in all. Checks are counted instead of time, so that a machine
// that starves all processes, or wakes from sleep, raises no false alarm. A frozen first guard is killed before the
// second guard opens the device, because two processes must never hold it.
//
// The program watches the second guard in the same way, by relief_beats, and replaces it (guarded_device.h). The second
// guard's beats continue even while a driver takes long to zero the force, so only a frozen process is replaced.
#pragma once

#include <functional>

#include "haptic/drivers/hand_guard.h"
#include "haptic/drivers/hand_mailbox.h"
#include "worlds/base/result.h"

namespace handrail::drivers {

inline constexpr int kLookMs = 10;
inline constexpr int kStillLooks = 10;

// Counts the checks in a row in which a process's count of beats did not change.
class StillCount {
public:
    explicit StillCount(std::uint32_t beats) : beats_(beats) {}
    // Compares the newest count of beats with the last one. While `may_rest` is true, the process may pause, and the
    // check is not counted. Returns how many checks in a row saw no new beat.
    int look(std::uint32_t newest, bool may_rest) noexcept {
        still_ = !may_rest && newest == beats_ ? still_ + 1 : 0;
        beats_ = newest;
        return still_;
    }

private:
    std::uint32_t beats_;
    int still_ = 0;
};

// After this long without success, the second guard reports that the device may push.
inline constexpr double kZeroTriesS = 2.0;
// After that report, the second guard continues to try, less often, until this time has passed in all, because the
// device may be plugged in again.
inline constexpr double kZeroKeepsTryingS = 30.0;

// Opens the device, sends zero and closes it. Succeeds if the device accepted the zero.
using ZeroDevice = std::function<Result<void>()>;

// Runs the second guard for its whole life, on the calling thread. Returns the exit status: 0 unless the device may
// still push.
// - guard_fd: process descriptor of the first guard; becomes readable when that guard has ended.
// - life_fd: the socket to the program.
// - end_guard: kills the first guard.
int relieve_guard(HandMailbox& mailbox, int guard_fd, int life_fd, const ZeroDevice& zero_device,
                  const std::function<void()>& end_guard);

}  // namespace handrail::drivers
