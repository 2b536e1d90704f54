// Tests the exits of a hall that has many. The session announces the nearest eight exits, and then how many more there
// are of each kind.
#include <gmock/gmock.h>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace exits_test {

using test::AppSession;
using ::testing::HasSubstr;
using ::testing::Not;

// Makes a hall with this many rooms of 4 by 4 m along its south side, each behind a gap of 0.9 m.
std::shared_ptr<const Scene> hall_with(int rooms) {
    test::SceneBuilder builder;
    const double east_m = 4.0 * rooms;
    builder.box({0, -4, -1}, {east_m, 8, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        builder.box({x0, y0, 0}, {x1, y1, 3}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    };
    wall(-0.2, -4.2, east_m + 0.2, -4);
    wall(-0.2, 8, east_m + 0.2, 8.2);
    wall(-0.2, -4, 0, 8);
    wall(east_m, -4, east_m + 0.2, 8);
    for (int r = 0; r < rooms; ++r) {
        const double west_m = 4.0 * r;
        wall(west_m, -0.2, west_m + 1.55, 0);
        wall(west_m + 2.45, -0.2, west_m + 4, 0);
        if (r > 0) wall(west_m - 0.1, -4, west_m + 0.1, -0.2);
    }
    builder.start({2, 4, 0}, 0.0);
    return builder.share();
}

TEST(Exits, beyond_eight_are_the_nearest_eight_and_a_summary_of_the_rest) {
    for (const int rooms : {7, 8, 9, 14}) {
        AppSession s;
        s.app.apply(WorldEntered{make_ready(hall_with(rooms))}, 0.0);
        s.run(0.1);
        const std::string said = s.request(Command::Exits);
        EXPECT_THAT(said, HasSubstr(std::to_string(rooms) + " exits.")) << said;
        std::size_t openings = 0;
        for (std::size_t at = said.find("Opening to"); at != std::string::npos; at = said.find("Opening to", at + 1))
            ++openings;
        EXPECT_EQ(openings, static_cast<std::size_t>(std::min(rooms, 8))) << said;
        const std::string more = rooms == 9 ? "And 1 more: 1 opening." : "And 6 more: 6 openings.";
        if (rooms > 8) {
            EXPECT_THAT(said, HasSubstr(more)) << said;
        } else {
            EXPECT_THAT(said, Not(HasSubstr("more:"))) << said;
        }
    }
}

}  // namespace exits_test
}  // namespace handrail
