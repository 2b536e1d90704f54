// Haply's Inverse3 through the service that its maker installs: a WebSocket on this computer, JSON, exactly one state
// for each message sent. A force message thus also requests the next position. Runs in the guard process: forces at 1
// kHz are messages at 1 kHz, and answers may be damaged or late. When the guard ends, the connection closes and the
// service must stop the force. Owned by one thread. Source: the public documentation of the service, 3.5. The axes x
// right, y away from the person, z up come from it and have not been checked on a device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"

namespace handrail::drivers {

inline constexpr std::uint16_t kHaplyPort = 10001;

// Connects to the service on this computer and takes its first Inverse3. The clock must outlive the device.
Result<std::unique_ptr<device::HapticDevice>> open_haply_device(Clock& clock, std::uint16_t port = kHaplyPort);

// Facts that the service states about its first Inverse3; requests no force. firmware is empty if it states none.
struct HaplyFacts {
    std::string device_id, firmware;
    bool calibrated = false;
};
Result<HaplyFacts> look_at_haply(Clock& clock, std::uint16_t port = kHaplyPort);

// Parses one message of the service. Returns false if it contains no valid state of this device. An empty `device_id`
// is set from the message.
bool parse_haply_state(std::string_view json, std::string& device_id, device::DeviceSample& sample);

}  // namespace handrail::drivers
