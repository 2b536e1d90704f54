// Tests that a walker cannot enter a closed mesh that is not convex, not even from a start inside such a mesh.
#include <gtest/gtest.h>

#include "tests/support/block_mesh.h"
#include "tests/support/names.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace closed_mesh_walk_test {

TEST(WalkSpace, contains_no_place_inside_a_closed_mesh_of_any_form) {
    // A court of 12 by 12 m with rocks in the shape of a horseshoe. The rocks are 2 m thick and 3 m high and surround a
    // yard of 3 by 4 m.
    const test::BlockMesh floor =
        test::block_mesh({{0, 0, 0}}, [](const Vec3& p) { return Vec3(0, 0, -0.5) + p * Vec3(12, 12, 0.5); });
    std::set<test::Block> blocks;
    for (int x = 0; x < 7; ++x)
        for (int y = 0; y < 6; ++y)
            for (int z = 0; z < 3; ++z)
                if (x < 2 || x >= 5 || y < 2) blocks.insert({x, y, z});
    const test::BlockMesh rocks = test::block_mesh(blocks, [](const Vec3& p) { return Vec3(2, 2, 0) + p; });
    Result<Scene> scene = read_stl(floor.stl("court") + rocks.stl("rocks"), "court.stl");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    // The starts are outside, in a rock, and in the yard.
    for (const Vec3& feet : {Vec3(1, 1, 0), Vec3(3, 3, 0), Vec3(5.5, 6, 0)}) {
        Start start;
        start.feet_m = feet;
        scene->starts.push_back(start);
    }
    const Result<WalkSpace> space = make_walk_space(*scene, {});
    ASSERT_TRUE(space.has_value()) << space.error().sentence();
    std::size_t in_the_yard = 0, on_the_floor = 0;
    for (std::uint32_t s = 0; s < space->spans.size(); ++s) {
        const Vec3 feet = space->place_m(s);
        if (feet.z > 1.0) continue;  // skips places on top of the rocks
        ++on_the_floor;
        for (const double up : {0.3, 0.9, 1.7}) ASSERT_FALSE(rocks.holds(feet + Vec3(0.001, 0.001, up))) << feet.x;
        in_the_yard += feet.x > 4 && feet.x < 7 && feet.y > 4 && feet.y < 8 ? 1 : 0;
    }
    EXPECT_GT(in_the_yard, 100U);
    EXPECT_GT(on_the_floor, 10'000U);
}

}  // namespace closed_mesh_walk_test
}  // namespace handrail
