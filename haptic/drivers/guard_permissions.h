// The permissions that a guard keeps when it is confined: what its device's driver needs, and no more. Pure except for
// environment variables. Called once, on the guard's main thread.
#pragma once

#include <array>
#include <string_view>

#include "worlds/confine/confine.h"

namespace handrail::drivers {

// The environment variables that a guard inherits: the places of makers' libraries and their settings, of the Falcon's
// firmware, and those with which umockdev emulates devices.
inline constexpr std::array<std::string_view, 8> kGuardVariables{
    "LD_LIBRARY_PATH", "GTDD_HOME", "OH_SDK_BASE", "HOME", "XDG_DATA_HOME", "HANDRAIL_*", "LD_PRELOAD", "UMOCKDEV_DIR"};

// `device`: a name as for open_device.
confine::Permissions guard_permissions(std::string_view device);

}  // namespace handrail::drivers
