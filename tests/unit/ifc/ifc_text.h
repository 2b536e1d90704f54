// Provides small IFC files as text: variants of the house in tests/unit/ifc/worlds.
#pragma once

#include <string>

#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

// A house of 8 by 4 m with two rooms: Küche in the west, Living room in the east. The wall between the rooms has a
// door. Another door is in the south, and a window in the north.
inline std::string small_house(const std::string& name = "small_house.ifc") {
    return content_of(test::project_root() / "tests/unit/ifc/worlds" / name);
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// Returns the text with more instances before the end of the data.
inline std::string with_instances(const std::string& text, const std::string& more) {
    const std::size_t at = text.rfind("ENDSEC;");
    return text.substr(0, at) + more + text.substr(at);
}

inline bool in_a_solid(const Scene& scene, const Vec3& at_m) {
    return std::any_of(scene.solids.begin(), scene.solids.end(),
                       [&](const Solid& s) { return s.role == SolidRole::Solid && contains(s.shape, at_m); });
}

}  // namespace handrail::test
