// What the Falcon's driver must do over every way there is to the device: usbfs played by umockdev, and the kernel's
// own USB core.
#pragma once

#include <memory>
#include <mutex>

#include "haptic/drivers/byte_link.h"
#include "tests/emulators/falcon_emulator.h"

namespace handrail::test {

// Woken with firmware from a file, homed without a force, then 1,000 exchanges of a wall that a hand presses on: it
// rests at the exact static answer. `lock` guards the emulator.
void wake_home_and_rest_against_a_wall(std::unique_ptr<ByteLink> link, FalconEmulator& falcon, std::mutex& lock);

}  // namespace handrail::test
