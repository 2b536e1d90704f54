// Determines the permissions that a guard keeps when it confines itself: only those that its device's driver needs.
// guard_permissions() is pure except that it reads environment variables. It is called once, on the guard's main
// thread.
#pragma once

#include <array>
#include <string_view>

#include "worlds/confine/confine.h"

namespace handrail::drivers {

// The environment variables that a guard inherits. They name the folders of the makers' libraries and settings and of
// the Falcon's firmware; umockdev uses some of them to emulate devices.
inline constexpr std::array<std::string_view, 8> kGuardVariables{
    "LD_LIBRARY_PATH", "GTDD_HOME", "OH_SDK_BASE", "HOME", "XDG_DATA_HOME", "HANDRAIL_*", "LD_PRELOAD", "UMOCKDEV_DIR"};

// Returns the permissions for a device. `device` is a name that open_device() accepts.
confine::Permissions guard_permissions(std::string_view device);

}  // namespace handrail::drivers
