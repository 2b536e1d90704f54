// Tests the validators. They must find inconsistencies, and must find none in what the program generates. If a caller
// violates a contract, the program must end and name the place in the code.
#include <functional>

#include "app/core/desk/desk.h"
#include "app/core/world/mover_play.h"
#include "app/core/world/walker.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/render/validate_scene.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/geometry/bezier_patch.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/validate_ways.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace validate_test {

std::filesystem::path file_of(const char* name) { return test::project_root() / name; }

Scene world(const char* name) {
    auto scene = read_world(file_of(name));
    EXPECT_TRUE(scene) << name;
    return scene ? std::move(*scene) : Scene{};
}

TEST(Validate, finds_no_fault_in_scenes_made_from_worlds) {
    for (const char* name :
         {"worlds/maps/house.map", "worlds/maps/first_room.map", "tests/scenarios/worlds/every_property.map",
          "tests/scenarios/worlds/two_pools.map", "tests/scenarios/worlds/unit_box.obj"}) {
        SCOPED_TRACE(name);
        const Scene scene = world(name);
        const auto valid = validate(scene);
        EXPECT_TRUE(valid) << valid.error().message;
        for (const double rounding_m : {0.0, 0.002}) {
            const auto touch = validate(*compile_haptic(scene, exploring(rounding_m)));
            EXPECT_TRUE(touch) << touch.error().message;
        }
        const WalkerSize size = walker_size(scene, 0.25);
        const auto made = Navigation::make(scene, walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
        if (!made) continue;  // this world has no walkable area
        const auto space = validate((*made)->space());
        EXPECT_TRUE(space) << space.error().message;
        const auto rooms = validate(make_rooms(scene, (*made)->space()), (*made)->space());
        EXPECT_TRUE(rooms) << rooms.error().message;
    }
}

TEST(Validate, finds_every_kind_of_damage_in_a_haptic_scene) {
    const HapticScene whole = *compile_haptic(world("tests/scenarios/worlds/every_property.map"), exploring(0.002));
    ASSERT_TRUE(validate(whole));
    const auto of_kind = [](HapticScene& scene, ObstacleKind kind) -> Obstacle& {
        return *std::find_if(scene.obstacles.begin(), scene.obstacles.end(),
                             [&](const Obstacle& o) { return o.kind == kind; });
    };
    const std::vector<std::function<void(HapticScene&)>> damages{
        [](HapticScene& s) { s.origin_m.x = std::nan(""); },
        [](HapticScene& s) { s.materials.clear(); },
        [](HapticScene& s) { s.roundings_m.front() = 0.1; },
        [](HapticScene& s) { s.roundings_m.push_back(-1.0); },
        [](HapticScene& s) { s.materials.front().relief = 1000; },
        [](HapticScene& s) { s.labels.pop_back(); },
        [](HapticScene& s) { s.obstacles.front().first_label = 0xffffffffU; },
        [](HapticScene& s) { s.obstacles.front().rounding = 999; },
        [&](HapticScene& s) { of_kind(s, ObstacleKind::Box).shape = 100000; },
        [&](HapticScene& s) { s.boxes[of_kind(s, ObstacleKind::Box).shape].max_m.x = -1e9; },
        [](HapticScene& s) { s.hanging_effects.push_back(100000); },
        [](HapticScene& s) { s.bodies.push_back({}); },
    };
    for (std::size_t i = 0; i < damages.size(); ++i) {
        HapticScene damaged = whole;
        damages[i](damaged);
        EXPECT_FALSE(validate(damaged)) << "damage " << i;
    }
}

TEST(Validate, finds_every_kind_of_damage_in_routes_and_rooms) {
    const Scene scene = world("tests/scenarios/worlds/two_rooms_door.map");
    const WalkerSize size = walker_size(scene, 0.25);
    const auto made = Navigation::make(scene, walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
    ASSERT_TRUE(made);
    const WalkSpace space = (*made)->space();
    const RoomGraph graph = make_rooms(scene, space);
    ASSERT_TRUE(validate(space));
    ASSERT_TRUE(validate(graph, space));
    ASSERT_FALSE(graph.portals.empty());
    const std::vector<std::function<void(WalkSpace&)>> damages{
        [](WalkSpace& s) { s.cell_m = 0.0; },
        [](WalkSpace& s) { s.first.pop_back(); },
        [](WalkSpace& s) { s.first.back() += 1; },
        [](WalkSpace& s) { s.spans.front().cell += 1; },
        [](WalkSpace& s) { s.spans.front().floor_m = 1e9F; },
        [](WalkSpace& s) { s.spans.back().clearance_m = std::nanf(""); },
        [](WalkSpace& s) { s.spans.front().next[0] = 0xfffffffeU; },
        [](WalkSpace& s) { s.spans.front().next[1] = 0; },
        [](WalkSpace& s) { s.spans.front().ground = 0xfffffffeU; },
        [](WalkSpace& s) {
            s.links.push_back({PassageKind::Drop, 0, 0xfffffffeU, false, kNoFeature});
        },
    };
    for (std::size_t i = 0; i < damages.size(); ++i) {
        WalkSpace damaged = space;
        damages[i](damaged);
        EXPECT_FALSE(validate(damaged)) << "damage " << i;
    }
    const std::vector<std::function<void(RoomGraph&)>> wrong{
        [](RoomGraph& g) { g.room_of_span.pop_back(); },
        [](RoomGraph& g) { g.room_of_span.front() = 100000; },
        [](RoomGraph& g) { g.rooms.front().area_m2 = 0.0; },
        [](RoomGraph& g) { g.rooms.front().name.clear(); },
        [](RoomGraph& g) { g.portals.front().rooms[1] = 100000; },
        [](RoomGraph& g) { g.portals.front().width_m = -1.0; },
    };
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        RoomGraph damaged = graph;
        wrong[i](damaged);
        EXPECT_FALSE(validate(damaged, space)) << "damage " << i;
    }
}

using ContractDeathTest = testing::Test;

TEST(ContractDeathTest, a_broken_precondition_ends_the_program_and_names_the_place) {
    const Desk desk;
    EXPECT_DEATH((void)desk.words(0), "at desk.cpp line [0-9]+: control < controls_.size\\(\\) does not hold");
    EXPECT_DEATH(WalkerWorld(nullptr), "at walker_world.cpp line [0-9]+: scene != nullptr does not hold");
    MoverPlay movers;
    EXPECT_DEATH(movers.set_going(0), "at mover_play.cpp line");
    const auto empty = std::make_shared<const Scene>();
    const WalkerWorld nothing(empty);
    Walker walker(nothing, {});
    EXPECT_DEATH((void)walker.tick(Vec3(std::nan(""), 0.0, 0.0), 0.01), "at walker.cpp line");
    EXPECT_DEATH((void)tessellate(PatchGrid{3, 3, {}}, 0.01), "at bezier_patch.cpp line");
}

}  // namespace validate_test
}  // namespace handrail
