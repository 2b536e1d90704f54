// Haply's Inverse3 through the service that its maker installs: a WebSocket on this computer, JSON, exactly one state
// for each message sent, so that a force is also the question for the next place. Lives in the guard process: a force
// at 1 kHz is a message at 1 kHz, and what comes may be damaged or late. When the guard ends the connection closes, and
// what stops the force then is the service. Owner: one thread. Source: the public documentation of the service, 3.5.
// Axes x right, y away from the person, z up are taken from it and await a device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"

namespace handrail {

inline constexpr std::uint16_t kHaplyPort = 10001;

// Connects to the service on this computer and takes its first Inverse3. The clock outlives the device.
Result<std::unique_ptr<HapticDevice>> open_haply_device(Clock& clock, std::uint16_t port = kHaplyPort);

// What the service says of its first Inverse3; no force is asked for. Firmware is empty where it does not say.
struct HaplyFacts {
    std::string device_id, firmware;
    bool calibrated = false;
};
Result<HaplyFacts> look_at_haply(Clock& clock, std::uint16_t port = kHaplyPort);

// What one message of the service says; false when it holds no sound state of this device. `device_id` is taken when it
// is empty.
bool parse_haply_state(std::string_view json, std::string& device_id, DeviceSample& sample);

}  // namespace handrail
