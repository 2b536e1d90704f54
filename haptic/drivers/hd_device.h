// Drives 3D Systems' Touch and Phantoms. The driver uses their maker's library libHD (OpenHaptics HD interface), which
// is loaded if it is installed. The library calls back on its own thread about 1000 times a second; the callback only
// exchanges numbers. The driver runs in the guard process; the library switches the motors off when that process ends.
// One thread owns the driver. Source: the public description of the HD interface, OpenHaptics 3. Library axes: x right,
// y up, z towards the person; millimetres, newtons.
#pragma once

#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"

namespace handrail::drivers {

// Opens the default device. `library` is a path that replaces the installed library, for tests. The device gets the
// DeviceSpec of the model that the library names, limited to the force and stiffness that the library states.
Result<std::unique_ptr<device::HapticDevice>> open_hd_device(const std::string& library = {});

}  // namespace handrail::drivers
