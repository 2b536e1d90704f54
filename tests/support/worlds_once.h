// Provides worlds that no test modifies. A process reads each of them once, and finds its rooms once for all sessions
// of its main thread (RoomsKept). A session test thus needs only a small part of its usual time. Each session has its
// own copy of the rooms.
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

// Returns the options of a session that uses the rooms in RoomsKept.
inline SessionOptions with_known_rooms(SessionOptions options = {}) {
    if (!options.rooms_kept) options.rooms_kept = &rooms_of_this_process;
    return options;
}

inline std::shared_ptr<const Scene> world_once(const std::filesystem::path& file) {
    // The key includes the spoken language, because some names of a world depend on it.
    static std::map<std::pair<std::filesystem::path, std::string>, std::shared_ptr<const Scene>> known;
    std::shared_ptr<const Scene>& world = known[{file, spoken_language()}];
    if (world) return world;
    auto scene = read_world(file);
    EXPECT_TRUE(scene) << file;
    if (!scene) return std::make_shared<const Scene>();
    return world = std::make_shared<const Scene>(std::move(*scene));
}

}  // namespace handrail::test
