// 3D Systems' Touch and Phantoms through their maker's library libHD (OpenHaptics HD interface), loaded when it is
// installed. The library calls back from a thread of its own about 1000 times a second; only numbers are swapped there.
// This lives in the guard process; the library switches the motors off when the process that uses it ends. Owner: one
// thread. Source: the public description of the HD interface, OpenHaptics 3. Library axes: x right, y up, z towards the
// person; millimetres, newtons.
#pragma once

#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"

namespace handrail {

// `library`: a path in place of the installed one, for tests. The spec is the row of the model that the library names,
// held to the force and stiffness that it states.
Result<std::unique_ptr<HapticDevice>> open_hd_device(const std::string& library = {});

}  // namespace handrail
