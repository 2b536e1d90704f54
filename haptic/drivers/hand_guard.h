// The guard process: small, separate from the program, and the only one that holds a real device. It exchanges the
// newest force against the newest sample. When the program dies, freezes or ends, the guard is still there to send
// zero. Libraries that allocate, lock, block or crash do so here, where the servo thread never waits for them.
//
// The force becomes zero if no new command comes for kZeroAfterS (a frozen program, a servo that hangs), or if the
// program's end of the socket closes (it ended in some way; kill -9 closes it too). The second guard watches this one
// (relief_guard.h): if this one dies or freezes with a device open, the second guard sends zero. If the driver itself
// hangs for kStuckS and nothing ended the guard, it ends itself. After the device is unplugged, the guard looks for it
// twice a second.
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

// Finds and opens the device, also after it was unplugged. Reports progress in sentences.
using OpenDevice =
    std::function<Result<std::unique_ptr<device::HapticDevice>>(const std::function<void(const std::string&)>& tell)>;

// The first byte of each message from the guard to the program; the rest is a sentence.
enum class GuardMessage : char { News = 'n', Ready = 'r', Failed = 'f' };

// Sends a message without waiting, because a program that does not listen must not block its guard.
void send_message(int life_fd, GuardMessage kind, const std::string& sentence);

// Runs the guard for its whole life, on the calling thread. wake_fd: eventfd that counts new commands. life_fd: socket
// to the program. stuck: called from another thread if one exchange lasts longer than kStuckS; it ends the process, or
// notifies a test. Returns the exit status.
int guard_hand(HandMailbox& mailbox, int wake_fd, int life_fd, const OpenDevice& open_device,
               const std::function<void()>& stuck);

}  // namespace handrail::drivers
