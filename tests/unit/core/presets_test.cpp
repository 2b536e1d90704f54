// Tests the presets of step length, walking speed and verbosity.
#include <gmock/gmock.h>

#include "settings/presets.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace presets_test {

using test::AppSession;
using ::testing::HasSubstr;

const settings::Preset& preset(std::string_view id) {
    for (const settings::Preset& each : settings::presets())
        if (each.id == id) return each;
    throw std::out_of_range("no such preset");
}

struct Walker : AppSession {
    Walker() {
        app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
        run(0.1);
        said.clear();
    }
};

TEST(Presets, contain_the_usual_values_and_only_values_that_the_settings_accept) {
    EXPECT_TRUE(preset("usual").is_set(Settings{}));
    for (const settings::Preset& each : settings::presets()) {
        Settings settings;
        for (const auto& [key, value] : each.values())
            EXPECT_TRUE(settings::change_setting(settings, key, value).has_value()) << key << " " << value;
        EXPECT_TRUE(each.is_set(settings)) << each.id;
    }
}

TEST(Presets, are_chosen_by_a_word_and_kept) {
    Walker w;
    EXPECT_EQ(w.line("preset brisk"), "Brisk: steps of 0.8 metres, 1.5 metres a second, verbosity 1.");
    EXPECT_TRUE(preset("brisk").is_set(w.app.settings()));
    EXPECT_EQ(w.app.take_setting_changes().size(), 3U);
    EXPECT_EQ(w.line("preset usual"), "Usual: steps of 0.7 metres, 1 metre a second, verbosity 2.");
    EXPECT_TRUE(preset("usual").is_set(w.app.settings()));
}

TEST(Presets, are_chosen_in_the_menu_where_the_present_one_is_selected) {
    Walker w;
    w.request(Command::Menu);
    w.line("presets for walking");
    ASSERT_TRUE(w.app.dialogue().is_open());
    EXPECT_EQ(w.app.dialogue().view().items[w.app.dialogue().view().at].name, "Usual");
    EXPECT_THAT(w.line("calm"), HasSubstr("Calm: steps of 0.5 metres"));
    EXPECT_TRUE(preset("calm").is_set(w.app.settings()));
}

}  // namespace presets_test
}  // namespace handrail
