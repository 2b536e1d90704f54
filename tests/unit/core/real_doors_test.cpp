// Tests that the walker of a session walks through every door of our own buildings and of real ones, on the floors that
// the file has on either side.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/core/world/walker.h"
#include "tests/support/direction_through.h"
#include "tests/support/known_buildings.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/ifc/ifc_hut.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace real_doors_test {

constexpr double kBefore_m = 0.45;  // distance of the walker's centre from the middle of the leaf

bool walks(const WalkerWorld& world, const WalkerSize& size, const Vec3& middle_m, const Vec3& way) {
    Walker walker(world, size);
    walker.place(middle_m - way * kBefore_m + Vec3(0.0, 0.0, 0.02));
    for (int i = 0; i < 120; ++i) walker.tick(way, 1.0 / 60.0);
    return glm::dot(walker.state().feet_m - middle_m, way) > kBefore_m;
}

TEST(RealDoors, can_be_walked_through_in_both_directions_in_a_session) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const test::TemporaryFolder folder;
    for (const auto& [path, known_doors, large] : test::known_buildings(folder)) {
        if (known_doors == 0 || (test::kSanitizerScale < 1.0 && large)) continue;
        const std::string file = path.filename().string();
        const Result<Scene> scene = read_world(path);
        ASSERT_TRUE(scene) << scene.error().sentence();
        auto open = std::make_shared<Scene>(*scene);  // The leaves are removed, so that none blocks the walker.
        std::erase_if(open->solids, [](const Solid& solid) { return solid.role == SolidRole::Mover; });
        open->movers.clear();
        const WalkerWorld world(open);
        const WalkerSize size = walker_size(*open, 0.25);
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

// The result for the doors of a scene with open leaves: how many doors there are, how many the report names, and which
// ones the walker could not pass onto a floor.
struct DoorsWalked {
    int doors = 0, reported = 0;
    std::string held;  // names of doors that stopped the walker and that the report does not name
};
DoorsWalked walk_all(const Scene& scene) {
    auto open = std::make_shared<Scene>(scene);
    std::erase_if(open->solids, [](const Solid& solid) { return solid.role == SolidRole::Mover; });
    open->movers.clear();
    const WalkerWorld world(open);
    const WalkerSize size = walker_size(*open, 0.25);
    DoorsWalked walked;
    for (const StatedPortal& portal : scene.stated->portals) {
        if (portal.kind != StatedPortalKind::Door) continue;
        ++walked.doors;
        walked.reported += portal.passable ? 0 : 1;
        if (!portal.passable) continue;
        const std::optional<Vec3> way = test::direction_through(scene, portal.feature);
        if (!way || !walks(world, size, portal.place_m, *way) || !walks(world, size, portal.place_m, -*way))
            walked.held += " " + portal.name + "/" + std::to_string(portal.source.line);
    }
    return walked;
}

TEST(RealDoors, of_each_model_are_passable_or_reported_with_a_reason) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "real buildings";
    const std::vector<std::pair<std::string, int>> models{
        {"duplex-apartment.ifc", 0}, {"fzk-haus.ifc", 0},     {"institute.ifczip", 0},
        {"large-building.ifc", 0},   {"smiley-west.ifc", 20}, {"wall-door-column-ifc4x3.ifc", 0}};
    for (const auto& [name, impassable] : models)
        for (const std::filesystem::path& file : test::with_real_worlds({}, {name})) {
            SCOPED_TRACE(name);
            const Result<Scene> scene = read_world(file);
            ASSERT_TRUE(scene) << scene.error().sentence();
            const DoorsWalked walked = walk_all(*scene);
            const HonestReport report = honest_report(*scene);
            std::cout << name << ": " << walked.doors << " doors, " << walked.reported << " reported\n";
            EXPECT_EQ(walked.held, "");
            EXPECT_EQ(walked.reported, impassable);
            EXPECT_EQ(report.doors_impassable, walked.reported);
            EXPECT_GE(walked.doors, scene->report.doors);
        }
}

// Makes a hut like that in a model whose doors have no openings.
test::Hut hut_without_openings() {
    test::Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 5.0, 0.0}), ",$");
    hut.part("IFCWALL", "South", hut.block({0.0, 0.0, 0.0}, {6.0, 0.3, 2.8}), ",$");
    hut.part("IFCWALL", "North", hut.block({0.0, 4.7, 0.0}, {6.0, 5.0, 2.8}), ",$");
    hut.part("IFCWALL", "West", hut.block({0.0, 0.3, 0.0}, {0.3, 4.7, 2.8}), ",$");
    hut.part("IFCWALL", "East", hut.block({5.7, 0.3, 0.0}, {6.0, 4.7, 2.8}), ",$");
    hut.part("IFCDOOR", "Entrance", hut.block({2.5, 0.1, 0.0}, {3.5, 0.2, 2.1}), ",2.1,1.,.DOOR.,$,$");
    return hut;
}

TEST(RealDoors, without_an_opening_can_be_walked_through) {
    const Scene scene = hut_without_openings().scene();
    const DoorsWalked walked = walk_all(scene);
    EXPECT_EQ(walked.doors, 1);
    EXPECT_EQ(walked.reported, 0);
    EXPECT_EQ(walked.held, "");
}

}  // namespace real_doors_test
}  // namespace handrail
