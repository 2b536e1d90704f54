// Checks that the Falcon's driver must pass on every connection to the device. The connections are usbfs emulated by
// umockdev, and the kernel's own USB core.
#pragma once

#include <memory>
#include <mutex>

#include "haptic/drivers/byte_link.h"
#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"

namespace handrail::test {

// Loads the firmware from a file and homes without a force. Then a simulated hand presses against a virtual wall for
// 1,000 exchanges. At the end the hand must be at the exact static solution. `lock` guards the emulator.
void wake_home_and_rest_against_a_wall(std::unique_ptr<ByteLink> link, FalconEmulator& falcon, std::mutex& lock);

}  // namespace handrail::test
