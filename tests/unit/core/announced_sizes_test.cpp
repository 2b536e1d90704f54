// Tests that the announced sizes of buildings and rooms are those of their walls. Ground that a reader added around a
// building is not included.
#include <cmath>
#include <numbers>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/worlds_once.h"
#include "tests/unit/core/app_session.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/building_bounds.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace announced_sizes_test {

constexpr const char* kHouse =
    "Building: Small house.\nWalls: 0.2 metres thick.\n\n"
    "Hall, 6 by 4 metres. Door outside in the south wall.\nStart in the middle, facing north.\n\n"
    "Study, 6 by 4.4 metres, north of Hall. Door to Hall.\n";

std::string said_on_entering(const std::shared_ptr<const Scene>& scene) {
    test::AppSession session;
    session.app.apply(WorldEntered{make_ready(scene)}, session.now);
    session.run(1.0);
    return fmt::format("{}", fmt::join(session.said, " "));
}

TEST(AnnouncedSizes, of_a_building_exclude_the_ground_around_it) {
    const auto house = std::make_shared<const Scene>(*read_words(kHouse, "house.rooms"));
    const Vec3 size = building_bounds_m(*house).size_m();
    EXPECT_NEAR(size.x, 6.2, 1e-6);
    EXPECT_NEAR(size.y, 8.6, 1e-6);
    EXPECT_GT(house->bounds_m.size_m().x, 15.0) << "with the ground";
    EXPECT_NE(said_on_entering(house).find("Small house, 6 by 9 metres."), std::string::npos)
        << said_on_entering(house);
    for (const auto& [file, reported] :
         {std::pair("duplex-apartment.ifc", "9 by 18 metres."), std::pair("fzk-haus.ifc", "12 by 10 metres.")})
        if (const auto path = test::real_world(file)) {
            EXPECT_NE(said_on_entering(test::world_once(*path)).find(reported), std::string::npos) << file;
        }
}

TEST(AnnouncedSizes, of_a_room_are_those_of_its_outline_in_any_rotation) {
    for (const double degrees : {0.0, 10.0, 30.0, 90.0, 137.0}) {
        const double turn = degrees * std::numbers::pi / 180.0;
        StatedRoom room;
        room.rings.emplace_back();
        for (const Vec2& p : {Vec2(0, 0), Vec2(5, 0), Vec2(5, 2), Vec2(3, 2), Vec2(3, 3), Vec2(0, 3)})
            room.rings[0].push_back(
                Vec2(p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)));
        const Vec2 size = outline_size_m(room);
        const bool long_way_east = std::abs(std::cos(turn)) >= std::abs(std::sin(turn));
        EXPECT_NEAR(size.x, long_way_east ? 5.0 : 3.0, 1e-9) << degrees;
        EXPECT_NEAR(size.y, long_way_east ? 3.0 : 5.0, 1e-9) << degrees;
    }
}

}  // namespace announced_sizes_test
}  // namespace handrail
