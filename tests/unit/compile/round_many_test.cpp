// Tests the limits of rounding a scene. compile_haptic() must stop rounding above a stated number of solids, and after
// a cancellation.
#include <gmock/gmock.h>

#include "haptic/compile/compile_haptic.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"

namespace handrail {
namespace round_many_test {

bool any_rounded(const HapticScene& scene) {
    return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [](const Obstacle& o) { return o.rounding != 0; });
}

std::shared_ptr<const Scene> cubes(std::size_t count) {
    test::SceneBuilder one;
    one.box({0, 0, 0}, {1, 1, 1});
    Scene scene = *one.share();
    scene.solids.resize(count, scene.solids.front());
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 by(3.0 * static_cast<double>(i), 0.0, 0.0);
        Solid& solid = scene.solids[i];
        for (Plane& plane : solid.shape.planes) plane.offset_m += glm::dot(plane.normal, by);
        for (Polygon& face : solid.shape.faces)
            for (Vec3& p : face.points_m) p += by;
        solid.shape.bounds_m = {solid.shape.bounds_m.min_m + by, solid.shape.bounds_m.max_m + by};
    }
    return std::make_shared<const Scene>(std::move(scene));
}

TEST(RoundMany, leaves_all_edges_sharp_above_a_number_of_solids_and_reports_it) {
    CompileReport few, many;
    EXPECT_TRUE(any_rounded(*compile_haptic(*cubes(300), exploring(0.05), &few)));
    EXPECT_EQ(few.rounding.too_many, 0U);
    EXPECT_EQ(few.rounding.rounded, 300U);
    const auto haptic = compile_haptic(*cubes(RoundingReport::kMostRounded + 1), exploring(0.05), &many);
    EXPECT_FALSE(any_rounded(*haptic));
    EXPECT_EQ(haptic->obstacles.size(), RoundingReport::kMostRounded + 1);
    EXPECT_THAT(many.rounding.sentences(),
                testing::ElementsAre(
                    "All edges stay sharp: there are 100001 solids, and edges are rounded for at most 100000."));
}

TEST(RoundMany, returns_nothing_after_cancellation) {
    const auto scene = cubes(50);
    std::stop_source stop;
    CompileOptions options = exploring(0.05);
    options.stop = stop.get_token();
    EXPECT_TRUE(any_rounded(*compile_haptic(*scene, options)));
    stop.request_stop();
    EXPECT_EQ(compile_haptic(*scene, options), nullptr);
}

}  // namespace round_many_test
}  // namespace handrail
