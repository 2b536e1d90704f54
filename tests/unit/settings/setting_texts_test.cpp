// Tests that every setting has texts in every language. No texts may remain for settings that no longer exist.
#include <gmock/gmock.h>

#include <set>

#include "settings/adjust.h"
#include "settings/table.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace setting_texts_test {
using testing::HasSubstr;

// Returns the keys of all texts that the program composes from names in tables.
std::set<std::string> made_keys() {
    std::set<std::string> keys{"setting.keys"};
    const auto add_unit = [&](std::string_view unit) {
        if (!unit.empty()) keys.insert("unit." + std::string(unit));
    };
    for (const SettingInfo& info : settings_table()) {
        const std::string key(info.key);
        keys.insert("setting." + key);
        keys.insert("setting_name." + key);
        keys.insert("setting_topic." + key.substr(0, key.find('.')));
        add_unit(info.unit);
        if (std::holds_alternative<TextField>(info.field)) keys.insert("setting_range." + key);
        if (const auto* choice = std::get_if<ChoiceField>(&info.field))
            for (const std::string_view word : choice->words)
                keys.insert(fmt::format("setting_choice.{}.{}", key, word));
    }
    for (const ProfileInfo& info : profile_table()) {
        keys.insert("setting.profile." + std::string(info.field));
        add_unit(info.unit);
    }
    for (const char* name : {"number", "whole", "switch", "words", "key"})
        keys.insert(std::string("setting_range.") + name);
    return keys;
}

TEST(SettingTexts, exist_for_every_row_of_the_tables_and_for_nothing_else) {
    const std::set<std::string> wanted = made_keys();
    for (const LanguageName& language : bundled_languages()) {
        std::set<std::string> found;
        for (const auto& [key, pattern] : bundled_texts(language.code))
            for (const char* section :
                 {"setting.", "setting_name.", "setting_topic.", "setting_choice.", "setting_range.", "unit."})
                if (key.starts_with(section)) found.insert(key);
        EXPECT_EQ(found, wanted) << language.code;
    }
}

TEST(SettingTexts, are_spoken_in_german_while_typed_words_stay_unchanged) {
    const test::InLanguage german("de");
    Settings settings;
    const SettingLine ceiling = setting_line("haptic.ceiling", settings);
    EXPECT_EQ(ceiling.name, "größte Kraft");
    EXPECT_EQ(ceiling.range, "light, normal oder full");
    EXPECT_THAT(ceiling.meaning, HasSubstr("1,2 Newton"));
    ASSERT_TRUE(change_setting(settings, "haptic.ceiling", "light"));
    EXPECT_EQ(setting_line("haptic.ceiling", settings).value, "leicht");
    ASSERT_TRUE(change_setting(settings, "walk.step_length_m", "0.8"));
    EXPECT_EQ(setting_line("walk.step_length_m", settings).value, "0,8 Meter");
    EXPECT_EQ(stepped("walk.step_length_m", settings, 1), "0.85")
        << "a value to be stored has a point in every language";
    EXPECT_EQ(change_setting(settings, "walk.step_length_m", "9").error().message,
              "Die Einstellung walk.step_length_m ist 9, muss aber sein: 0.2 bis 1.5 Meter.");
}

}  // namespace setting_texts_test
}  // namespace handrail
