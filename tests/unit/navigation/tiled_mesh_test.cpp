// Tests routes over a mesh of several 64 m tiles. They must cross between tiles as if the mesh were one piece.
#include <gmock/gmock.h>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace tiled_mesh_test {

using test::SceneBuilder;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kRadius_m = 0.25;

std::shared_ptr<Navigation> navigate(const Scene& scene) {
    WalkerMeasures body;
    body.radius_m = kRadius_m;
    body.cell_m = 0.1;
    const auto made = Navigation::make(scene, body);
    EXPECT_TRUE(made) << made.error().message;
    return made ? *made : nullptr;
}

double length_of(const std::vector<Vec3>& points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::length(points[i] - points[i - 1]);
    return sum;
}

// A floor of 400 by 8 m with a wall every 20 m. Each wall has a gap of 1.5 m, alternately at one end and at the other.
TEST(TiledMesh, finds_the_shortest_route_in_a_slalom_of_400_m) {
    for (const bool along_x : {true, false}) {
        const auto turned = [&](double along, double across, double z) {
            return along_x ? Vec3(along, across, z) : Vec3(across, along, z);
        };
        SceneBuilder slalom;
        slalom.box(turned(0, 0, -1), turned(400, 8, 0), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        std::vector<Vec3> corners{turned(2, 4, 0)};
        for (int k = 1; k < 20; ++k) {
            const double at = 20.0 * k;
            const bool low = k % 2 == 0;
            slalom.box(turned(at, low ? 1.5 : 0, 0), turned(at + 0.2, low ? 8 : 6.5, 3), "wall", SolidRole::Solid, {},
                       FeatureKind::Wall);
            corners.push_back(turned(at + 0.1, low ? 1.5 - kRadius_m : 6.5 + kRadius_m, 0));
        }
        corners.push_back(turned(398, 4, 0));
        slalom.start(corners.front(), 0.0);
        const auto ways = navigate(slalom.scene());
        ASSERT_TRUE(ways);
        ASSERT_NE(ways->mesh(), nullptr);
        const Route route = ways->plan(corners.front(), corners.back(), RoutePreference::Shortest);
        EXPECT_TRUE(route.reaches);
        EXPECT_GE(route.length_m, length_of(corners) - 1.0) << along_x;
        EXPECT_LE(route.length_m, 1.02 * length_of(corners)) << along_x;
    }
}

// The floor begins at 0, so two tiles meet at 64 m.
TEST(TiledMesh, allows_a_drop_across_the_border_of_two_tiles) {
    for (double edge_m = 62.0; edge_m <= 66.0; edge_m += 0.25) {
        SceneBuilder ledge;
        ledge.box({0, 0, -1}, {edge_m, 6, 0.8}, "ledge", SolidRole::Solid, {}, FeatureKind::Floor);
        ledge.box({edge_m, 0, -1}, {100, 6, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        ledge.start({5, 3, 0.8}, 0.0);
        const auto ways = navigate(ledge.scene());
        ASSERT_TRUE(ways);
        const Route down = ways->plan({5, 3, 0.8}, {95, 3, 0});
        EXPECT_TRUE(down.reaches) << edge_m;
        EXPECT_TRUE(down.drops) << edge_m;
        EXPECT_FALSE(ways->plan({95, 3, 0}, {5, 3, 0.8}).reaches) << edge_m;
    }
}

// Returns a floor of `length_m` with a teleporter at its west end. The teleporter leads to an island beyond the east
// end.
Scene with_teleporter(double length_m) {
    SceneBuilder builder;
    builder.box({0, 0, -1}, {length_m, 4, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    builder.box({length_m + 10, 0, -1}, {length_m + 20, 4, 0}, "island", SolidRole::Solid, {}, FeatureKind::Floor);
    Switch teleporter;
    teleporter.volume = builder.box({1, 1, 0}, {2, 2, 2}, "pad", SolidRole::Trigger, {}, FeatureKind::Teleport);
    teleporter.leads_elsewhere = true;
    teleporter.feet_m = {length_m + 15, 2, 0};
    builder.start({5, 2, 0}, 0.0);
    builder.scene().switches.push_back(teleporter);
    return builder.scene();
}

TEST(TiledMesh, accepts_a_teleporter_to_the_same_or_the_next_tile_and_reports_a_farther_one) {
    for (const double length_m : {20.0, 60.0, 100.0}) {
        const auto ways = navigate(with_teleporter(length_m));
        ASSERT_TRUE(ways);
        const Route away = ways->plan({5, 2, 0}, {length_m + 15, 2, 0});
        EXPECT_TRUE(away.reaches) << length_m;
        ASSERT_FALSE(away.passages.empty()) << length_m;
        EXPECT_EQ(away.passages.back().kind, PassageKind::Teleporter) << length_m;
        EXPECT_TRUE(ways->said().empty()) << length_m;
    }
    const auto far = navigate(with_teleporter(300.0));
    ASSERT_TRUE(far);
    EXPECT_THAT(far->said(), Contains(HasSubstr("One teleporter leads too far away")));
}

}  // namespace tiled_mesh_test
}  // namespace handrail
