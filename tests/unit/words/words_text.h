// Provides buildings as room descriptions for tests, and what the reader makes of them.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/support/names.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

inline Scene read_rooms(const std::string& text) {
    Result<Scene> scene = read_words(text, "house.rooms");
    EXPECT_TRUE(scene.has_value()) << scene.error().sentence() << "\n" << text;
    if (!scene) return {};
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
    return std::move(*scene);
}

inline const StatedRoom* room_of(const Scene& scene, const std::string& name) {
    for (const StatedRoom& room : scene.stated->rooms)
        if (room.name == name) return &room;
    ADD_FAILURE() << "no room " << name;
    return &scene.stated->rooms.front();
}

// Returns the south-west and the north-east corner of a room.
inline std::pair<Vec2, Vec2> box_of(const StatedRoom& room) {
    Vec2 least(1e300), most(-1e300);
    for (const Vec2& p : room.rings[0]) least = glm::min(least, p), most = glm::max(most, p);
    return {least, most};
}

// Returns entries such as "door Corridor | Library", with the names in alphabetical order.
inline std::multiset<std::string> joins_of(const Scene& scene) {
    std::multiset<std::string> joins;
    for (const StatedPortal& portal : scene.stated->portals) {
        constexpr std::array<const char*, 5> kKinds{"door", "opening", "stairs", "ramp", "lift"};
        std::multiset<std::string> names;
        for (const std::uint32_t r : portal.rooms) names.insert(scene.stated->rooms[r].name);
        std::string text = kKinds[static_cast<std::size_t>(portal.kind)];
        for (const std::string& name : names) text += (name == *names.begin() ? " " : " | ") + name;
        joins.insert(text);
    }
    return joins;
}

inline const Feature* thing_of(const Scene& scene, const std::string& name) {
    for (const Feature& feature : scene.features)
        if (feature.name == name) return &feature;
    ADD_FAILURE() << "nothing called " << name;
    return &scene.features.front();
}

}  // namespace handrail::test
