// What the Falcon's driver must do over every connection to the device: usbfs emulated by umockdev, and the kernel's
// own USB core.
#pragma once

#include <memory>
#include <mutex>

#include "haptic/drivers/byte_link.h"
#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"

namespace handrail::test {

// Loads firmware from a file, homes without a force, then runs 1,000 exchanges of a wall on which a hand presses. The
// hand must rest at the exact static solution. `lock` guards the emulator.
void wake_home_and_rest_against_a_wall(std::unique_ptr<ByteLink> link, FalconEmulator& falcon, std::mutex& lock);

}  // namespace handrail::test
