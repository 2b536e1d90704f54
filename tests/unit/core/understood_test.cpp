// Tests the report on what the reader understood of a building's file: one sentence when the world is entered, and a
// full list on request.
#include "app/core/context/context_words.h"
#include "app/core/context/workspace_scale.h"
#include "app/core/dialogue/words.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/unit/core/explorer.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/building_bounds.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace understood_test {

using test::Explorer;
using testing::HasSubstr;

// Returns two rooms of an architect's model. The second room looks as if stairs filled it.
std::shared_ptr<const Scene> house_with_odd_room() {
    Result<Scene> scene = read_world(test::project_root() / "tests/unit/ifc/worlds/small_house.ifc");
    EXPECT_TRUE(scene.has_value());
    StatedBuilding stated = *scene->stated;
    stated.rooms.at(1).holds_stairs = true;
    scene->stated = std::make_shared<const StatedBuilding>(std::move(stated));
    return std::make_shared<const Scene>(std::move(*scene));
}

TEST(Understood, is_announced_in_one_sentence_on_entering_which_leads_to_the_points_to_check) {
    Explorer p(house_with_odd_room(), nullptr);
    EXPECT_TRUE(
        p.heard("This world has 2 rooms on one storey, 2 doors, one window and no stairs. It also has one piece of "
                "furniture and no "
                "landmarks. Check this first: Living room"))
        << p.all_heard(0);
    p.key("Shift+8");
    ASSERT_TRUE(p.app().dialogue().is_open());
    const std::vector<ListItem> items = p.app().dialogue().view().items;
    ASSERT_GT(items.size(), 4U);
    EXPECT_THAT(items[0].name, HasSubstr("2 rooms on one storey"));
    EXPECT_THAT(items[1].name, HasSubstr("contains stairs, but its name does not say so"));
    EXPECT_THAT(items[1].value, HasSubstr("step")) << "where it is from here";
    p.line(items[1].name);
    ASSERT_TRUE(p.app().guide().goal());
    EXPECT_EQ(p.app().guide().goal()->name, items[1].name);
    const Vec3 at_m = p.app().scene()->stated->rooms[1].at_m;
    EXPECT_NEAR(p.app().guide().goal()->box_m.min_m.x, at_m.x, 1e-9);
    EXPECT_NEAR(p.app().guide().goal()->box_m.min_m.y, at_m.y, 1e-9);
}

// The reader adds eight metres of ground around this house. The size of the building must not include that ground.
TEST(SizeOfABuilding, excludes_the_ground_that_the_reader_added_around_it) {
    Explorer p(house_with_odd_room(), "sim-t");
    const Scene& scene = *p.app().scene();
    const Vec3 size = building_bounds_m(scene).size_m(), laid = scene.bounds_m.size_m();
    EXPECT_GT(laid.x, size.x + 15.0) << "else this says nothing";
    Aabb walls;
    for (const Feature& feature : scene.features)
        if (feature.kind == FeatureKind::Wall && !feature.bounds_m.empty()) walls.include(feature.bounds_m);
    EXPECT_NEAR(size.x, walls.size_m().x, 0.5);
    EXPECT_NEAR(size.y, walls.size_m().y, 0.5);
    EXPECT_TRUE(p.heard(phrase("session.world_of_size",
                               {{"world", sentence_case(spoken_name(scene))}, {"wide", size.x}, {"deep", size.y}})))
        << p.all_heard(0);
    p.tap(Command::ScaleBuilding, 0.2);
    const double reach_m = Explorer::facts("sim-t").spec.workspace_radius_m;
    EXPECT_TRUE(p.heard(scale_sentence(NamedScale::Building,
                                       world_m_per_hand_m(NamedScale::Building, Aabb{Vec3(0.0), size}, reach_m),
                                       reach_m, distances(Settings{}))))
        << p.all_heard(0);
}

TEST(DescribedRoom, has_the_size_of_the_outline_that_the_file_states) {
    const std::shared_ptr<const Scene> scene = house_with_odd_room();
    Explorer p(scene, nullptr);
    for (const StatedRoom& room : scene->stated->rooms) {
        Aabb outline;
        for (const Vec2& corner : room.rings.front()) outline.include(Vec3(corner, 0.0));
        p.leave_lists();
        p.tap(Command::Describe);
        p.line(room.name);
        const Vec3 size = outline.size_m();
        const std::string reported =
            phrase("describe.room", {{"room", room.name}, {"size", size_words(size.x, size.y, distances(Settings{}))}});
        EXPECT_THAT(p.all_heard(0), HasSubstr(reported));
    }
}

TEST(Understood, reports_on_request_that_a_map_states_no_rooms_but_not_on_entering) {
    Explorer p(test::our_world("house.map"), nullptr);
    EXPECT_FALSE(p.heard("storey")) << p.all_heard(0);
    p.tap(Command::Understood);
    ASSERT_TRUE(p.app().dialogue().is_open());
    EXPECT_THAT(p.app().dialogue().view().items.at(0).name, HasSubstr("names no rooms"));
    EXPECT_THAT(p.app().dialogue().view().items.at(1).name, HasSubstr("Guessed"));
}

}  // namespace understood_test
}  // namespace handrail
