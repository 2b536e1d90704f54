// Worlds that no test writes, read once in a process, and their rooms found once for all sessions of it (RoomsKept):
// most of what a test of the session would else wait for. What a session knows of rooms beyond that is its own copy.
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
    // Some of a world's names are made in the language spoken.
    static std::map<std::pair<std::filesystem::path, std::string>, std::shared_ptr<const Scene>> known;
    std::shared_ptr<const Scene>& world = known[{file, spoken_language()}];
    if (world) return world;
    auto scene = read_world(file);
    EXPECT_TRUE(scene) << file;
    if (!scene) return std::make_shared<const Scene>();
    return world = std::make_shared<const Scene>(std::move(*scene));
}

}  // namespace handrail::test
