// What a pad and a puck must do over every way there is to them: both back ends of hidapi, and the kernel's own HID
// core.
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "haptic/drivers/playstation_pad.h"
#include "tests/emulators/hid_emulators.h"

namespace handrail::test {

// A thousand outputs, each seen by the pad as it was meant, and a thousand inputs, none lost; loose and still at the
// end. `ring` is called after the emulator has queued reports, `lock` guards it.
void exchange_a_thousand_reports(std::unique_ptr<HidLink> link, PadBus bus, PadEmulator& emulator, std::mutex& lock,
                                 const std::function<void()>& ring);

// Ahead and a turn to the left are told, in its own frame and ours; the light obeys.
void steer_with_a_space_mouse(std::unique_ptr<HidLink> link, PuckEmulator& emulator, std::mutex& lock,
                              const std::function<void()>& ring);

}  // namespace handrail::test
