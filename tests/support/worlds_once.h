// Worlds that no test changes. They are read once per process, and their rooms are found once for all of its sessions
// (RoomsKept), because these two take most of the time of a session test. Everything else that a session knows of rooms
// is its own copy.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/core/whereabouts/rooms_kept.h"
#include "worlds/base/language.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

inline RoomsKept rooms_of_this_process{3};

inline std::shared_ptr<const Scene> world_once(const std::filesystem::path& file) {
    // Some names of a world depend on the spoken language.
    static std::map<std::pair<std::filesystem::path, std::string>, std::shared_ptr<const Scene>> known;
    std::shared_ptr<const Scene>& world = known[{file, spoken_language()}];
    if (world) return world;
    auto scene = read_world(file);
    EXPECT_TRUE(scene) << file;
    if (!scene) return std::make_shared<const Scene>();
    return world = std::make_shared<const Scene>(std::move(*scene));
}

}  // namespace handrail::test
