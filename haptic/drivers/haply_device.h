// Drives Haply's Inverse3. The driver uses the service that the maker installs: a WebSocket on this computer that
// answers each JSON message with exactly one state. A force message thus also requests the next position. The driver
// runs in the guard process, because forces at 1 kHz are messages at 1 kHz, and answers may be damaged or late. When
// the guard ends, the connection closes and the service must stop the force. One thread owns the driver. Source: the
// public documentation of the service, 3.5. The axes come from it, too: x right, y away from the person, z up. They
// have not been checked on a device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"

namespace handrail::drivers {

inline constexpr std::uint16_t kHaplyPort = 10001;

// Connects to the service on this computer and opens the first Inverse3 that it reports. The clock must outlive the
// device.
Result<std::unique_ptr<device::HapticDevice>> open_haply_device(Clock& clock, std::uint16_t port = kHaplyPort);

// Facts that the service states about its first Inverse3. Reading them requests no force. `firmware` is empty if the
// service states no version.
struct HaplyFacts {
    std::string device_id, firmware;
    bool calibrated = false;
};
Result<HaplyFacts> look_at_haply(Clock& clock, std::uint16_t port = kHaplyPort);

// Parses one message of the service. Returns false if the message contains no valid state of this device. If
// `device_id` is empty, it is set from the message.
bool parse_haply_state(std::string_view json, std::string& device_id, device::DeviceSample& sample);

}  // namespace handrail::drivers
