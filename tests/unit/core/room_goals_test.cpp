// Tests routes to two kinds of rooms: rooms whose middle cannot be reached from where the person stands, and rooms on
// whose ceiling a walker could stand.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/route_walker.h"
#include "tests/unit/ifc/ifc_hut.h"

namespace handrail {
namespace room_goals_test {

using test::AppSession;
using test::Hut;

std::shared_ptr<const Scene> entered_at(const Hut& hut, const std::vector<Vec3>& starts_m) {
    auto scene = std::make_shared<Scene>(hut.scene());
    scene->starts.clear();
    for (const Vec3& feet_m : starts_m) scene->starts.push_back({feet_m, 0.0, false, "", {}});
    return scene;
}

TEST(RoomGoals, are_any_reachable_place_of_the_room) {
    AppSession person;
    person.app.apply(
        WorldEntered{make_ready(entered_at(test::hall_with_gallery(), {{-2.0, 0.6, 0.0}, {6.0, 4.0, 2.6}}))},
        person.now);
    person.run(0.5);
    EXPECT_TRUE(test::go_to_room(person, "Hall", 60.0)) << person.news();
    EXPECT_GT(person.app.feet_m().x, 0.0);
    EXPECT_LT(person.app.feet_m().z, 0.5) << "not on the gallery";
}

// The space of the room reaches up to the floor of the next storey. That floor is a roof on which a walker could stand.
TEST(RoomGoals, are_not_on_the_roof_of_a_room_as_high_as_its_storey) {
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({-6.0, -2.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
    hut.part("IFCSLAB", "Roof", hut.block({0.0, 0.0, 2.8}, {6.0, 6.0, 3.0}), ",$");
    for (const Aabb& wall : {Aabb{{0.0, -0.2, 0.0}, {6.0, 0.0, 2.8}}, Aabb{{0.0, 6.0, 0.0}, {6.0, 6.2, 2.8}},
                             Aabb{{6.0, -0.2, 0.0}, {6.2, 6.2, 2.8}}, Aabb{{-0.2, 1.2, 0.0}, {0.0, 6.2, 2.8}},
                             Aabb{{2.0, 1.2, 0.0}, {5.0, 5.0, 2.8}}})
        hut.part("IFCWALL", "Wall", hut.block(wall.min_m, wall.max_m), ",$");
    hut.space("Lobby", hut.block({0.0, 0.0, 0.0}, {6.0, 6.0, 3.0}));
    AppSession person;
    person.app.apply(WorldEntered{make_ready(entered_at(hut, {{-2.0, 0.6, 0.0}, {3.0, 3.0, 3.0}}))}, person.now);
    person.run(0.5);
    EXPECT_TRUE(test::go_to_room(person, "Lobby", 60.0)) << person.news();
    EXPECT_GT(person.app.feet_m().x, 0.0);
    EXPECT_LT(person.app.feet_m().z, 0.5);
}

}  // namespace room_goals_test
}  // namespace handrail
