// Checks that the generated office buildings are as described, so that other tests can rely on them.
#include <set>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "tests/support/scale.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace office_world_test {

TEST(OfficeWorld, gives_the_same_text_only_for_the_same_size_and_seed) {
    const std::string once = test::office_world(test::office_size(1'000, 7)).map;
    EXPECT_EQ(once, test::office_world(test::office_size(1'000, 7)).map);
    EXPECT_NE(once, test::office_world(test::office_size(1'000, 8)).map);
}

TEST(OfficeWorld, has_the_requested_number_of_brushes_and_a_square_metre_for_each) {
    for (const int brushes : {1'000, 3'000, 10'000, 50'000}) {
        if (brushes > 3'000 && test::kSanitizerScale < 1.0) continue;
        const test::OfficeWorld office = test::office_world(test::office_size(brushes));
        EXPECT_EQ(office.brushes, brushes);
        EXPECT_NEAR(office.floor_m2, brushes, 0.15 * brushes);
        EXPECT_EQ(office.doors, office.rooms);
    }
    if (test::kSanitizerScale < 1.0) return;
    const test::OfficeWorld full = test::office_world(test::office_size(50'000));
    EXPECT_GE(full.doors, 1'000);
    EXPECT_EQ(test::office_size(50'000).storeys, 5);
}

TEST(OfficeWorld, is_read_without_a_warning_and_each_room_can_be_entered_through_its_own_door) {
    test::OfficeSize size;
    size.storeys = 2;
    size.corridors = 1;
    size.rooms_along_corridor = 2;
    size.brushes = 300;
    const test::OfficeWorld office = test::office_world(size);
    EXPECT_EQ(office.rooms, 8);
    const Result<Scene> scene = read_quake_map(office.map, "office.map");
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->report.warnings_in_all, 0) << scene->report.warnings.front().message;
    EXPECT_EQ(scene->report.brushes, 300);
    EXPECT_EQ(scene->report.doors, 8);
    auto navigation = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(navigation) << navigation.error().message;
    const RoomGraph graph = make_rooms(*scene, (*navigation)->space());
    int doors = 0;
    std::set<std::uint32_t> behind_doors;
    for (const Portal& portal : graph.portals) {
        if (portal.kind != PassageKind::Door) continue;
        ++doors;
        for (const std::uint32_t room : portal.rooms) behind_doors.insert(room);
    }
    EXPECT_EQ(doors, office.doors);
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
        const Room& room = graph.rooms[r];
        EXPECT_TRUE((*navigation)->reachable(scene->starts.front().feet_m, room.middle_m)) << room.name;
        if (room.map_name.empty()) continue;
        EXPECT_TRUE(behind_doors.contains(r)) << room.name;
        EXPECT_NEAR(room.bounds_m.size_m().x, 4.9, 0.2) << room.name;
    }
    EXPECT_GE(graph.rooms.size(), 11U);  // 8 rooms, one area outside them on each storey, and the stairs
}

TEST(Rooms, are_not_searched_further_after_cancellation) {
    const Result<Scene> scene = read_quake_map(test::office_world(test::office_size(300)).map, "office.map");
    ASSERT_TRUE(scene);
    const auto space = make_walk_space(*scene, WalkerMeasures{});
    ASSERT_TRUE(space);
    EXPECT_FALSE(make_rooms(*scene, *space).rooms.empty());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(make_rooms(*scene, *space, stop.get_token()).rooms.empty());
}

TEST(Rooms, are_found_even_if_the_floors_need_several_mesh_tiles) {
    test::SceneBuilder islands;
    Scene scene;
    constexpr int kAlong = 176;
    for (int x = 0; x < kAlong; ++x)
        for (int y = 0; y < kAlong; ++y)
            islands.box({3.0 * x, 3.0 * y, -4.0}, {3.0 * x + 0.8, 3.0 * y + 0.8, 0.0}, "island", SolidRole::Solid, {},
                        FeatureKind::Floor);
    islands.start({0.4, 0.4, 0.0}, 0.0);
    scene = islands.scene();
    for (int x = 0; x < kAlong; ++x)
        for (int y = 0; y < kAlong; ++y) scene.sounds.push_back({{3.0 * x + 0.4, 3.0 * y + 0.4, 0.5}, "bird", "bird"});
    WalkerMeasures body;
    body.cell_m = 0.4;
    const auto made = Navigation::make(scene, body);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_NE((*made)->mesh(), nullptr);
    EXPECT_GE((*made)->mesh()->polygons(), kAlong * kAlong);
    EXPECT_EQ(make_rooms(scene, (*made)->space()).rooms.size(), static_cast<std::size_t>(kAlong) * kAlong);
    EXPECT_TRUE((*made)->plan({0.2, 0.2, 0.0}, {0.6, 0.6, 0.0}).reaches);
    EXPECT_FALSE((*made)->plan({0.2, 0.2, 0.0}, {3.4, 0.4, 0.0}).reaches);
}

}  // namespace office_world_test
}  // namespace handrail
