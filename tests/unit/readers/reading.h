// A Scene as the tests of readers look at it, with the warnings as they are
// heard.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/precompiled.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

struct Reading {
    Scene scene;
    std::vector<std::string> said;
};

// Expects a Scene that holds together; an empty one where reading failed.
inline Reading reading_of(Result<Scene> scene) {
    EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().sentence());
    if (!scene) return {};
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << (valid ? "" : valid.error().sentence());
    Reading reading{std::move(*scene), {}};
    for (const Diagnostic& warning : reading.scene.report.warnings) reading.said.push_back(warning.sentence());
    return reading;
}

}  // namespace handrail::test
