// Provides the OpenStreetMap text of a small building, which tests change.
#pragma once

#include <string>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

// A corridor of 12 by 2 m on levels 0 and 1, with the main entrance at its west end and a lift L1 at its east end:
// - south of it are Library (both levels), 102 and women's toilets T1 (both);
// - north of it are stairs S1 (both) and, open to it, the Foyer;
// - a Vault has no door;
// - another building, with old-style tags, has a Shed.
inline std::string test_house() { return content_of(test::project_root() / "tests/unit/osm/worlds/test_house.osm"); }

inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

inline const StatedRoom* room_named(const Scene& scene, const std::string& name) {
    for (const StatedRoom& room : scene.stated->rooms)
        if (room.name == name) return &room;
    return nullptr;
}

// Returns an entry such as "Corridor F1, Level 0 | Library, Level 0" for each door or opening, in file order.
inline std::vector<std::string> joins_of(const Scene& scene, StatedPortalKind kind) {
    std::vector<std::string> joins;
    for (const StatedPortal& portal : scene.stated->portals) {
        if (portal.kind != kind) continue;
        joins.emplace_back();
        for (const std::uint32_t r : portal.rooms)
            joins.back() += (joins.back().empty() ? "" : " | ") + scene.stated->rooms[r].name;
    }
    return joins;
}

}  // namespace handrail::test
