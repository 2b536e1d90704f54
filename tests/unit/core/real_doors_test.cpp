// The body of a session at every door of buildings, our own and real ones: it walks through, as the file has the floor
// before and behind.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/core/world/walker.h"
#include "tests/support/known_buildings.h"
#include "tests/support/scale.h"
#include "tests/support/way_through.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace real_doors_test {

constexpr double kBefore_m = 0.45;  // of the middle of the body, from the middle of the leaf

bool walks(const BodyWorld& world, const BodySize& size, const Vec3& middle_m, const Vec3& way) {
    Walker walker(world, size);
    walker.place(middle_m - way * kBefore_m + Vec3(0.0, 0.0, 0.02));
    for (int i = 0; i < 120; ++i) walker.tick(way, 1.0 / 60.0);
    return glm::dot(walker.state().feet_m - middle_m, way) > kBefore_m;
}

TEST(RealDoors, are_walked_through_both_ways_by_the_body_of_a_session) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const test::TemporaryFolder folder;
    for (const auto& [path, known_doors, large] : test::known_buildings(folder)) {
        if (known_doors == 0 || (test::kSanitizerScale < 1.0 && large)) continue;
        const std::string file = path.filename().string();
        const Result<Scene> scene = read_world(path);
        ASSERT_TRUE(scene) << scene.error().sentence();
        auto open = std::make_shared<Scene>(*scene);  // no leaf in the way
        std::erase_if(open->solids, [](const Solid& solid) { return solid.role == SolidRole::Mover; });
        open->movers.clear();
        const BodyWorld world(open);
        const BodySize size = body_size(*open, 0.25);
        const std::vector<test::DoorToPass> doors = test::doors_to_pass(*scene);
        int held = 0;
        std::string names;
        for (const auto& [portal, way] : doors) {
            const bool there = walks(world, size, portal->place_m, way),
                       back = walks(world, size, portal->place_m, -way);
            if (there && back) continue;
            ++held;
            names += " " + portal->name + "/" + std::to_string(portal->source.line) +
                     (there  ? " back"
                      : back ? " there"
                             : "");
        }
        std::cout << file << ": " << doors.size() << " doors, " << held << " hold a body\n";
        EXPECT_EQ(doors.size(), known_doors) << file;
        EXPECT_EQ(held, 0) << file << ":" << names;
    }
}

}  // namespace real_doors_test
}  // namespace handrail
