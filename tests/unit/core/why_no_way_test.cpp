// Who asks for the way to a room that nobody comes to hears why that is, and what would help.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/box_scene.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace why_no_way_test {

// Two rooms of 5 by 4 m with a gap between them, and a table in the farther one.
std::shared_ptr<const Scene> two_rooms(double gap_m) {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {10.2, 4, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    for (const auto& [from, to] :
         {std::pair(Vec3(-0.2, -0.2, -0.2), Vec3(10.4, 0, 3)), std::pair(Vec3(-0.2, 4, -0.2), Vec3(10.4, 4.2, 3)),
          std::pair(Vec3(-0.2, 0, -0.2), Vec3(0, 4, 3)), std::pair(Vec3(10.2, 0, -0.2), Vec3(10.4, 4, 3)),
          std::pair(Vec3(5, 0, 0), Vec3(5.2, 2 - 0.5 * gap_m, 3)),
          std::pair(Vec3(5, 2 + 0.5 * gap_m, 0), Vec3(5.2, 4, 3))})
        b.box(from, to, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({8, 1.5, 0}, {9, 2.5, 0.7}, "Table");
    b.scene().room_names = {{{2.5, 2, 0}, "Hall"}, {{7, 2, 0}, "Study"}};
    b.start({1, 2, 0}, 0.5 * kPi);
    b.scene().starts.back().base = true;
    return b.share();
}

struct Asked : test::AppSession {
    Asked(double gap_m, bool beside) : test::AppSession({}, {}, {.rooms_beside = beside}) {
        app.apply(WorldEntered{make_ready(two_rooms(gap_m))}, 0.0);
        wait_for([&] {
            ask(Command::Routes);
            return app.dialogue().is_open();
        });
        const auto items = app.dialogue().view().items;
        const auto study =
            std::find_if(items.begin(), items.end(), [](const ListItem& i) { return i.name == "Study"; });
        EXPECT_NE(study, items.end());
        app.apply(LineTyped{std::to_string(study - items.begin() + 1)}, now);
        run(0.1);
    }
    template <class Condition>
    void wait_for(const Condition& is) {
        for (int i = 0; i < 3000 && !is(); ++i) {
            run(1.0 / 60.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
};

TEST(WhyNoWay, is_told_with_what_would_help_at_once_or_from_a_thread_beside) {
    for (const bool beside : {false, true}) {
        Asked asked(0.3, beside);
        EXPECT_TRUE(asked.heard("No walking way found to Study"));
        asked.wait_for([&] { return asked.heard("Study cannot be reached on foot from the base"); });
        EXPECT_TRUE(asked.heard("the best way to it is only 0.25 metres wide"))
            << "to the five centimetres of a column";
        EXPECT_TRUE(asked.heard("Make the way at least 0.5 metres wide there"));
    }
}

TEST(WhyNoWay, is_not_told_where_there_is_one) {
    Asked asked(1.2, false);
    asked.run(1.0);
    EXPECT_FALSE(asked.heard("No walking way"));
    EXPECT_FALSE(asked.heard("cannot be reached"));
}

}  // namespace why_no_way_test
}  // namespace handrail
