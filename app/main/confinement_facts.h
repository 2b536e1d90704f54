// Returns as JSON how the file reader and the device guards are confined, so that every command reports this in the
// same form.
#pragma once

#include <nlohmann/json.hpp>

#include "worlds/confine/confine.h"

namespace handrail::program {

inline nlohmann::ordered_json json_of(const confine::Confinement& offered) {
    return {{"seccomp", offered.seccomp}, {"landlock", offered.landlock}};
}

}  // namespace handrail::program
