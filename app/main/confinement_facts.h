// What confines the reader of files and the guards of devices, as data: the same in every command.
#pragma once

#include <nlohmann/json.hpp>

#include "worlds/confine/confine.h"

namespace handrail {

inline nlohmann::ordered_json json_of(const Confinement& offered) {
    return {{"seccomp", offered.seccomp}, {"landlock", offered.landlock}};
}

}  // namespace handrail
