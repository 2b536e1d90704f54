// Tests that the map key edge_rounding sets how wide the rounded zone of one thing is.
#include <gmock/gmock.h>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/haptic_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace own_rounding_test {

using compile::OwnRounding;
using compile::RoundedSolid;
using compile::RoundingReport;

// Returns a map with three cubes of 1.6 m, apart from each other: a plain one, one with rounder edges, and a sharp one.
Scene cubes(const std::string& rounder = "3") {
    using test::box_brush;
    using test::entity;
    using test::key;
    const test::TemporaryFolder folder;
    auto scene = read_world(folder.write(
        "cubes.map",
        entity("worldspawn", key("building", "1"), box_brush(0, 0, 0, 64, 64, 64)) +
            entity("thing", key("name", "Round") + key("edge_rounding", rounder), box_brush(200, 0, 0, 264, 64, 64)) +
            entity("thing", key("name", "Sharp") + key("edge_rounding", "0"), box_brush(400, 0, 0, 464, 64, 64))));
    EXPECT_TRUE(scene);
    return scene ? std::move(*scene) : Scene{};
}

std::vector<double> radii(const Scene& scene, double radius_m, const OwnRounding& own) {
    RoundingReport report;
    std::vector<double> all;
    for (const RoundedSolid& solid : round_edges(scene, radius_m, report, {}, own)) all.push_back(solid.rounding_m);
    return all;
}

TEST(OwnRounding, has_its_width_in_hand_travel_at_every_scale) {
    const Scene scene = cubes();
    ASSERT_TRUE(compile::has_own_rounding(scene));
    EXPECT_THAT(radii(scene, 0.09, {60.0, 1.0}), testing::Pointwise(testing::DoubleNear(1e-9), {0.09, 0.18, 0.0}));
    EXPECT_THAT(radii(scene, 0.0, {20.0, 1.0}), testing::Pointwise(testing::DoubleNear(1e-9), {0.0, 0.06, 0.0}))
        << "at scales for details only the own width applies";
    EXPECT_THAT(radii(scene, 0.09, {60.0, 0.1}), testing::Pointwise(testing::DoubleNear(1e-9), {0.09, 0.1, 0.0}))
        << "never more than the proxy's radius";
    EXPECT_THAT(radii(scene, 0.09, {}), testing::Pointwise(testing::DoubleNear(1e-9), {0.09, 0.09, 0.09}));
}

TEST(OwnRounding, is_felt_in_the_compiled_scene) {
    const Scene scene = cubes();
    compile::CompileOptions options = compile::exploring(0.0);
    EXPECT_THAT(compile::compile_haptic(scene, options)->roundings_m, testing::Each(0.0));
    options.own_rounding = {60.0, 1.0};
    EXPECT_THAT(compile::compile_haptic(scene, options)->roundings_m,
                testing::Contains(testing::DoubleNear(0.18, 1e-9)));
}

TEST(OwnRounding, that_is_out_of_range_is_reported) {
    const Scene scene = cubes("9");
    EXPECT_THAT(radii(scene, 0.0, {20.0, 1.0}), testing::Contains(testing::DoubleNear(0.1, 1e-9)));
    ASSERT_EQ(scene.report.warnings.size(), 1U);
    EXPECT_THAT(scene.report.warnings[0].message, testing::HasSubstr("edge_rounding"));
}

}  // namespace own_rounding_test
}  // namespace handrail
