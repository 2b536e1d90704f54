// The guard process: small, apart from the program, and the only one that holds a real device. It exchanges the newest
// force against the newest sample, and when the program dies, freezes or ends, it is still there to send zero.
// Libraries that allocate, lock, block or crash do so here, where the servo thread never waits for them.
//
// What zeroes the force: no new command for kZeroAfterS (a frozen program, a servo that hangs); the program's end of
// the socket closed (it ended, however: kill -9 closes it too). Whoever watches the guard itself is the second guard
// (relief_guard.h): when this one dies or stands still with a device open, that one sends zero. When the driver itself
// hangs for kStuckS and nobody ended it, the guard ends by itself. When the device is unplugged the guard looks for it
// again twice a second.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/hand_mailbox.h"
#include "worlds/base/clock.h"

namespace handrail {

inline constexpr double kZeroAfterS = 0.020;
inline constexpr double kLookAgainS = 0.5;
inline constexpr double kStuckS = 0.25;

// Finds and opens the device, also again after it was unplugged. What goes on is told in sentences.
using OpenDevice =
    std::function<Result<std::unique_ptr<HapticDevice>>(const std::function<void(const std::string&)>& tell)>;

// The first byte of each message from the guard to the program; the rest is a sentence.
enum class GuardMessage : char { News = 'n', Ready = 'r', Failed = 'f' };

// A message that does not wait: a program that does not listen must not hold up its guard.
void send_message(int life_fd, GuardMessage kind, const std::string& sentence);

// The guard's whole life, on the calling thread. wake_fd: eventfd that counts new commands. life_fd: socket to the
// program. stuck: called from another thread when one exchange lasts longer than kStuckS; ends the process, or is told
// in tests. Returns the exit status.
int guard_hand(HandMailbox& mailbox, int wake_fd, int life_fd, const OpenDevice& open_device,
               const std::function<void()>& stuck);

}  // namespace handrail
