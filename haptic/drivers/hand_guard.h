// Implements the guard process, a small process separate from the program. No other process holds a real device, except
// the second guard in an emergency. In each round the guard sends the newest force and reads a new sample. When the
// program dies, freezes or ends, the guard is still there to send zero. A maker's library may allocate, lock, block or
// crash in the guard, because the servo thread never waits for the guard.
//
// The guard sets the force to zero if no new command comes for kZeroAfterS, because the program has frozen or its servo
// hangs. It also does so if the program's end of the socket closes, which happens however the program ended, even by
// kill -9. The second guard watches the guard (relief_guard.h): if the guard dies or freezes with a device open, the
// second guard sends zero. If a driver hangs for kStuckS and nothing else has ended the guard, the guard ends itself.
// After the device is unplugged, the guard looks for it twice a second.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/hand_mailbox.h"
#include "worlds/base/clock.h"

namespace handrail::drivers {

inline constexpr double kZeroAfterS = 0.020;
inline constexpr double kLookAgainS = 0.5;
inline constexpr double kStuckS = 0.25;

// Finds and opens the device, also after the device was unplugged and plugged in again. Reports progress in sentences.
using OpenDevice =
    std::function<Result<std::unique_ptr<device::HapticDevice>>(const std::function<void(const std::string&)>& report)>;

// The first byte of each message from the guard to the program. A sentence follows it.
enum class GuardMessage : char { News = 'n', Ready = 'r', Failed = 'f' };

// Sends a message without waiting, because a program that does not read its messages must not block its guard.
void send_message(int life_fd, GuardMessage kind, const std::string& sentence);

// Runs the guard for its whole life, on the calling thread. Returns the exit status.
// - wake_fd: an eventfd that counts new commands.
// - life_fd: the socket to the program.
// - stuck: called from another thread if one exchange lasts longer than kStuckS. The function ends the process, or in a
//   test notifies the test.
int guard_hand(HandMailbox& mailbox, int wake_fd, int life_fd, const OpenDevice& open_device,
               const std::function<void()>& stuck);

}  // namespace handrail::drivers
