// What a guard keeps of the person's rights when it is confined: what its device's driver needs, and no more. Pure but
// for the environment's variables. Main thread of the guard, once.
#pragma once

#include <string_view>

#include "worlds/confine/confine.h"

namespace handrail {

// `device` as in open_device.
Permissions guard_permissions(std::string_view device);

}  // namespace handrail
