// The building that walks are made through.
#pragma once

#include <iostream>
#include <optional>

#include "tests/support/real_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

// quake-e1m1.map with at least one start. Nothing where it cannot be had: said aloud, with the status to exit with (77:
// skipped).
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
