// Tests the desk without a session. The test itself provides the plain state that the desk uses.
#include "app/core/desk/desk_visit.h"

#include <gmock/gmock.h>

#include "haptic/device/device_spec.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace desk_visit_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::shared_ptr<const Scene> ground() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

class DeskAlone : public ::testing::Test {
protected:
    DeskAlone() {
        plain.hands.right = {true, true, *find_device_spec("sim-t")};
        visit.where_am_i = [] { return "At the oak."; };
        visit.progress = [](double) { return "Half of it. The rest is told elsewhere."; };
        visit.beacon = [this] { return beacon; };
        visit.on_beacon = [this](const Mark* mark) { beacon = mark ? std::optional(mark->name) : std::nullopt; };
        visit.on_come = [this] { ++came; };
        visit.on_back = [this](const std::optional<std::string>& scale, double) { back_with.push_back(scale); };
        visit.furnish();
    }
    std::size_t control(std::string_view name) const {
        const auto found = visit.desk().find(name);
        EXPECT_TRUE(found) << name;
        return found.value_or(0);
    }
    void hand_at_desk(bool there) {
        plain.hands.tool.desk.open = there;
        visit.tick(now_s += 0.02);
    }

    test::PlainSession plain{ground()};
    DeskVisit visit{plain.context};
    std::optional<std::string> beacon;
    std::vector<std::optional<std::string>> back_with;
    int came = 0;
    double now_s = 1.0;
};

TEST_F(DeskAlone, appears_in_front_of_a_hand_and_not_at_all_without_one) {
    EXPECT_TRUE(visit.scene());
    const std::string first = visit.desk().controls().front().name;
    EXPECT_TRUE(visit.place_m(first));
    plain.hands.right = {};
    visit.lay_out();
    EXPECT_FALSE(visit.scene());
    EXPECT_FALSE(visit.place_m(first));
}

TEST_F(DeskAlone, pauses_the_world_while_the_hand_is_on_it) {
    EXPECT_FALSE(visit.refuses(Command::Forward, now_s));
    hand_at_desk(true);
    EXPECT_EQ(came, 1);
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("esk")));
    EXPECT_TRUE(visit.refuses(Command::Forward, now_s));
    EXPECT_EQ(plain.said().size(), 1U);
    EXPECT_FALSE(visit.refuses(Command::WhereAmI, now_s)) << "a question needs no time to pass";
    EXPECT_THAT(plain.said(), IsEmpty());
    hand_at_desk(true);
    EXPECT_EQ(came, 1) << "it is still there";
    EXPECT_THAT(back_with, IsEmpty());
    hand_at_desk(false);
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("At the oak.")));
    EXPECT_THAT(back_with, ElementsAre(std::nullopt));
}

TEST_F(DeskAlone, passes_a_new_scale_on_when_the_hand_returns_to_the_world) {
    const std::size_t scale = control("Scale");
    hand_at_desk(true);
    visit.keep_scale("120.0");
    EXPECT_THAT(visit.desk().value(scale), HasSubstr("120")) << "it counts at the desk already";
    hand_at_desk(false);
    hand_at_desk(true);
    hand_at_desk(false);
    EXPECT_THAT(back_with, ElementsAre("120.0", std::nullopt)) << "once";
}

TEST_F(DeskAlone, changes_settings_in_its_list_with_keys) {
    const std::size_t units = control("Steps or metres");
    const bool before = plain.person.settings.speech.distances_in_steps;
    visit.open_list(now_s);
    ASSERT_TRUE(plain.lists.dialogue.is_open());
    const std::string shown = plain.lists.dialogue.view().items[units].value;
    visit.press(units);
    EXPECT_NE(plain.person.settings.speech.distances_in_steps, before);
    EXPECT_NE(plain.lists.dialogue.view().items[units].value, shown) << "the open list shows it";
    EXPECT_EQ(visit.desk().value(control("Explored")), "Half of it");
    plain.lists.dialogue.close_all();
    plain.said();
    plain.person.settings.desk.use = false;
    visit.open_list(now_s);
    EXPECT_FALSE(plain.lists.dialogue.is_open());
    EXPECT_EQ(plain.said().size(), 1U) << "says why";
}

TEST_F(DeskAlone, sets_the_beacon_on_a_mark_and_enters_a_world) {
    const std::size_t mark = control("Mark"), button = control("Beacon on that mark");
    EXPECT_THAT(visit.press(button), HasSubstr("no marks"));
    plain.world.marks.resize(2);
    plain.world.marks[0].name = "Bench";
    plain.world.marks[1].name = "Well";
    visit.step(mark, 1);
    EXPECT_THAT(visit.press(button), HasSubstr("Well"));
    EXPECT_EQ(beacon, "Well");
    EXPECT_EQ(visit.desk().value(button), "Well");
    visit.press(button);
    EXPECT_EQ(beacon, std::nullopt) << "on that one already";

    const std::size_t world = control("World"), go = control("Go to that world");
    visit.press(go);
    EXPECT_FALSE(plain.requests.world) << "none is offered";
    visit.offer_worlds({{}, {"/far/castle.map", "/far/mill.map"}});
    visit.step(world, 1);
    EXPECT_THAT(visit.press(go), HasSubstr("Mill"));
    EXPECT_EQ(plain.requests.world, WorldRequest{"/far/mill.map"});
}

}  // namespace desk_visit_test
}  // namespace handrail
