// The name under which a test keeps the packed world of a request, for the core of a page.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "app/core/kept/world_request.h"

namespace handrail::test {

inline std::string packed_name(const core::WorldRequest& request) {
    std::string name = fmt::format("{}-{}-{}-{}", request.file.string(), request.map_scale_m_per_unit.value_or(0.0),
                                   request.unit_m.value_or(0.0), request.building);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

}  // namespace handrail::test
