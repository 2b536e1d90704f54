// What a guard keeps of the person's rights when it is confined: what its device's driver needs, and no more. Pure but
// for the environment's variables. Main thread of the guard, once.
#pragma once

#include <array>
#include <string_view>

#include "worlds/confine/confine.h"

namespace handrail {

// The variables that a guard gets of the person's environment: where makers' libraries and their settings are, where
// the Falcon's firmware is, and how umockdev plays devices.
inline constexpr std::array<std::string_view, 8> kGuardVariables{
    "LD_LIBRARY_PATH", "GTDD_HOME", "OH_SDK_BASE", "HOME", "XDG_DATA_HOME", "HANDRAIL_*", "LD_PRELOAD", "UMOCKDEV_DIR"};

// `device` as in open_device.
Permissions guard_permissions(std::string_view device);

}  // namespace handrail
