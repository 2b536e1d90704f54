// Drives Force Dimension's omega, sigma, lambda and delta. The driver uses their maker's library libdhd, which is
// loaded if it is installed. The library limits the rate itself and may block, so the driver runs in the guard process.
// If the guard dies, the library's exit code and the device's own watchdog stop the force. One thread owns the driver.
// Source: the public description of the DHD interface, SDK 3.17. Library axes: x towards the person, y right, z up;
// metres, newtons.
#pragma once

#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"

namespace handrail::drivers {

// Opens the first device that the library finds. `library` is a path that replaces the installed library, for tests.
// The device gets the DeviceSpec of the model that the library reports.
Result<std::unique_ptr<device::HapticDevice>> open_dhd_device(const std::string& library = {});

}  // namespace handrail::drivers
