// Worlds that no test writes, read once in a process, and their rooms found once for all sessions of its main thread
// (RoomsKept), which saves a test of the session most of its time. Each session has its own copy of the rooms.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/core/session/session_options.h"
#include "tests/support/names.h"
#include "worlds/base/language.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

inline RoomsKept rooms_of_this_process{3};

// The options of a session in such a world.
inline SessionOptions with_known_rooms(SessionOptions options = {}) {
    if (!options.rooms_kept) options.rooms_kept = &rooms_of_this_process;
    return options;
}

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
