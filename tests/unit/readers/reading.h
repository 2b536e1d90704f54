// Provides a Scene as the readers' tests check it, with its warnings as the session announces them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

struct Reading {
    Scene scene;
    std::vector<std::string> said;
};

// Expects a valid Scene. Returns an empty one if the reader failed.
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
