// Checks that a gamepad and a SpaceMouse must pass on every connection: both back ends of hidapi, and the kernel's own
// HID core.
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "haptic/drivers/playstation_pad.h"
#include "tests/emulators/hid_emulators.h"
#include "tests/support/names.h"

namespace handrail::test {

// Sends a thousand outputs, each of which the pad must receive unchanged, and a thousand inputs, none of which may be
// lost. At the end the triggers must give no resistance and the motors must be still. The function calls `ring` after
// the emulator has queued reports. `lock` guards the emulator.
void exchange_a_thousand_reports(std::unique_ptr<HidLink> link, PadBus bus, PadEmulator& emulator, std::mutex& lock,
                                 const std::function<void()>& ring);

// Makes the emulated SpaceMouse report a push ahead and a turn to the left. Checks both in the device's frame and in
// Handrail's frame, and that the light can be switched.
void steer_with_a_space_mouse(std::unique_ptr<HidLink> link, PuckEmulator& emulator, std::mutex& lock,
                              const std::function<void()>& ring);

}  // namespace handrail::test
