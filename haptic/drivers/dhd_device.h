// Force Dimension's omega, sigma, lambda and delta through their maker's library libdhd, loaded if it is installed. The
// library paces itself and may block, so this class runs in the guard process. If the guard dies, the end of the
// library and the device's own watchdog stop the force. Owned by one thread. Source: the public description of the DHD
// interface, SDK 3.17. Library axes: x towards the person, y right, z up; metres, newtons.
#pragma once

#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"

namespace handrail::drivers {

// `library`: a path that replaces the installed one, for tests. The spec is the row of the model that is found.
Result<std::unique_ptr<device::HapticDevice>> open_dhd_device(const std::string& library = {});

}  // namespace handrail::drivers
