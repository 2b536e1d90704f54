// Tests the menu and its lists without a session. The test itself provides the plain state that the menu uses.
#include "app/core/menu/menu.h"

#include <gmock/gmock.h>

#include <fstream>

#include "app/core/menu/setting_lists.h"
#include "app/core/menu/simplified_list.h"
#include "settings/adjust.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace menu_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::shared_ptr<const Scene> hall() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    builder.box({2.0, 3.0, 0.0}, {2.1, 3.1, 0.1}, "pebble");
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

class MenuAlone : public ::testing::Test {
protected:
    MenuAlone() {
        plain.context.tick_s = 1.0;
        plain.context.session_requests.perform = [this](Command command, double) { performed.push_back(command); };
    }
    // Returns the list's answer to a key, which a session would announce.
    std::string key(std::string_view name) { return plain.lists.dialogue.key(name, 1.0).words; }
    void line(std::string_view text) { plain.lists.dialogue.line(text, 1.0); }

    test::PlainSession plain{hall()};
    Menu menu{plain.context};
    std::vector<Command> performed;
};

TEST_F(MenuAlone, leads_to_commands_and_performs_them) {
    EXPECT_FALSE(menu.act(Command::Use, 1.0)) << "another's command";
    EXPECT_TRUE(menu.act(Command::Menu, 1.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("Menu")));
    line("what you can do");
    line("all topics");
    line("which way");
    EXPECT_THAT(performed, ElementsAre(Command::Heading));
    EXPECT_FALSE(plain.lists.dialogue.is_open());
    plain.said();
    EXPECT_TRUE(menu.act(Command::Help, 1.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("What to do. All topics, "))) << "by topic, not all at once";
    EXPECT_TRUE(plain.lists.dialogue.is_open());
    line("search");
    line("which way");
    EXPECT_THAT(plain.said().back(), HasSubstr("Say which way you face"));
}

TEST_F(MenuAlone, understands_items_typed_as_questions) {
    menu.act(Command::Menu, 1.0);
    plain.said();
    line("what can I do?");
    EXPECT_THAT(plain.said(), Contains(HasSubstr("All topics")));
    line("escape");
    line("who is here");
    EXPECT_THAT(performed, ElementsAre(Command::Learners));
}

TEST_F(MenuAlone, assigns_another_key_to_a_command) {
    EXPECT_FALSE(menu.commands().take_key("J", 1.0)) << "nobody asked for a key";
    menu.commands().open(true, 1.0);
    line("all topics");
    line("which way");
    line("another key");
    plain.said();
    EXPECT_TRUE(menu.commands().take_key("Control+Shift+J", 1.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("now on Control+Shift+J")));
    EXPECT_EQ(plain.person.keys.find("Control+Shift+J"), Command::Heading);
    EXPECT_FALSE(menu.commands().take_key("Control+Shift+J", 1.0)) << "once";
}

TEST_F(MenuAlone, explains_keys_in_input_help_without_performing_them) {
    EXPECT_TRUE(menu.act(Command::InputHelp, 1.0));
    plain.said();
    EXPECT_TRUE(menu.commands().take_key("C", 1.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("Say which way you face")));
    EXPECT_TRUE(menu.commands().take_line("heading", 1.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("Say which way you face")));
    EXPECT_FALSE(menu.commands().take_line("no such thing", 1.0));
    EXPECT_FALSE(menu.commands().take_key("Shift+F1", 1.0)) << "the key that ends it";
    menu.act(Command::InputHelp, 1.0);
    EXPECT_FALSE(menu.commands().take_key("C", 1.0));
    EXPECT_THAT(performed, IsEmpty());
}

TEST_F(MenuAlone, changes_settings_by_steps_or_typed_values) {
    open_setting_topics(plain.context, 1.0);
    line("speech");
    ASSERT_TRUE(plain.lists.dialogue.is_open());
    const int before = plain.person.settings.speech.verbosity;
    line(setting_line("speech.verbosity", plain.person.settings).name);
    line(before == 0 ? "1" : "0");
    EXPECT_NE(plain.person.settings.speech.verbosity, before);
    plain.said();
    line("loud");
    EXPECT_NE(plain.person.settings.speech.verbosity, before) << "what is no number changes nothing";
}

TEST_F(MenuAlone, goes_to_listed_or_typed_worlds) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "old-mill.map") << "{}\n";
    menu.worlds().offer({folder.path(), {"/far/castle.map"}});
    EXPECT_EQ(menu.worlds().bundled("old-mill"), folder.path() / "old-mill.map");
    EXPECT_EQ(menu.worlds().bundled("castle"), std::nullopt) << "visited, but does not come with the program";
    menu.worlds().open(1.0);
    line("castle");
    EXPECT_THAT(plain.said().back(), HasSubstr("Castle"));
    EXPECT_EQ(plain.requests.take_world(), WorldRequest{"/far/castle.map"});
    menu.worlds().open(1.0);
    line("another");
    line(folder.path().string());
    line("old mill");
    EXPECT_EQ(plain.requests.take_world(), WorldRequest{folder.path() / "old-mill.map"});
}

TEST_F(MenuAlone, offers_each_language_under_its_own_name) {
    EXPECT_TRUE(menu.act(Command::Language, 1.0));
    line("deutsch");
    EXPECT_EQ(plain.person.settings.speech.language, "de");
}

TEST_F(MenuAlone, lists_things_that_are_too_small_to_feel) {
    Rooms rooms(plain.context);
    SimplifiedList simplified(plain.context, rooms);
    std::vector<std::string> chosen;
    simplified.on_choose = [&](const Goal& goal, double) { chosen.push_back(goal.name); };
    Simplification plan;
    for (std::uint32_t i = 0; i < plain.world.scene->features.size(); ++i)
        if (plain.world.scene->features[i].name == "pebble") plan.left_out.push_back(FeatureId{i});
    ASSERT_EQ(plan.left_out.size(), 1U);
    simplified.open(plan, {}, {}, 1.0);
    EXPECT_FALSE(plain.lists.dialogue.is_open()) << "no hand, nothing to be too small for it";
    plain.hands.right.present = true;
    simplified.open(plan, {}, {}, 1.0);
    ASSERT_TRUE(plain.lists.dialogue.is_open());
    key("Enter");
    EXPECT_THAT(chosen, ElementsAre("Pebble"));
}

}  // namespace menu_test
}  // namespace handrail
