// 3D Systems' Touch and Phantoms through their maker's library libHD (OpenHaptics HD interface), loaded if it is
// installed. The library calls back on its own thread about 1000 times a second; the callback only exchanges numbers.
// Runs in the guard process; the library switches the motors off when the process that uses it ends. Owned by one
// thread. Source: the public description of the HD interface, OpenHaptics 3. Library axes: x right, y up, z towards the
// person; millimetres, newtons.
#pragma once

#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"

namespace handrail::drivers {

// `library`: a path that replaces the installed one, for tests. The spec is the row of the model that the library
// names, limited to the force and stiffness that the library states.
Result<std::unique_ptr<device::HapticDevice>> open_hd_device(const std::string& library = {});

}  // namespace handrail::drivers
