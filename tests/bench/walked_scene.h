// Loads the building that the benchmarks walk through.
#pragma once

#include <iostream>
#include <optional>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

// Reads quake-e1m1.map and requires that it has at least one start. If the file is not available, prints why, sets the
// exit status (77: skipped) and returns nothing.
inline std::optional<Scene> walked_scene(int& status) {
    const auto path = real_world("quake-e1m1.map");
    if (!path) {
        std::cout << "Skipped: " << needs_real_world("quake-e1m1.map") << "\n";
        status = 77;
        return std::nullopt;
    }
    ReadOptions options;
    options.guess_materials = false;
    Result<Scene> scene = read_world(*path, options);
    if (scene && !scene->starts.empty()) return std::move(*scene);
    std::cerr << (scene ? std::string("The map has no start.") : scene.error().sentence()) << '\n';
    status = 1;
    return std::nullopt;
}

}  // namespace handrail::test
