// Tests the choice of the language, in a session or by the settings.
#include <fstream>

#include "app/core/kept/spoken_language.h"
#include "tests/support/box_scene.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace language_session_test {

using testing::HasSubstr;

struct Person : test::AppSession {
    explicit Person(const SessionOptions& options = {}) : AppSession({}, {}, options) {
        test::SceneBuilder b;
        b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
        b.start({3, 0.5, 0}, 0.0);
        app.apply(WorldEntered{make_ready(b.share())}, now);
        run(0.1);
    }
    ~Person() { (void)speak_language("en"); }
    std::string line(const std::string& text) {
        run(0.5);
        said.clear();
        if (!app.apply(LineTyped{text}, now))
            if (const CommandInfo* row = find_command(text)) {
                app.apply(CommandDown{row->command}, now);
                app.apply(CommandUp{row->command}, now);
            }
        return news();
    }
};

TEST(Language, is_chosen_from_a_list_of_native_names_and_saved) {
    Person p;
    EXPECT_THAT(p.line("language"), HasSubstr("English"));
    EXPECT_THAT(p.line("deutsch"), HasSubstr("Deutsch."));
    EXPECT_EQ(spoken_language(), "de");
    const auto changes = p.app.take_setting_changes();
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0], (std::pair<std::string, std::string>{"speech.language", "de"}));
    p.line("language");
    p.line("english");
    EXPECT_EQ(spoken_language(), "en");
}

TEST(Language, from_a_custom_file_appears_in_the_list) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "nl.toml") << "language.name = \"Nederlands\"\n";
    std::ofstream(folder.path() / "broken.toml") << "language.name = ";
    Person p({.languages_in = folder.path()});
    p.line("language");
    const std::string all = p.line("list");
    EXPECT_THAT(all, HasSubstr("Nederlands"));
    EXPECT_THAT(all, testing::Not(HasSubstr("broken")));
    p.line("nederlands");
    EXPECT_EQ(spoken_language(), "nl");
}

TEST(Language, that_does_not_exist_is_reported_and_changes_nothing) {
    Person p;
    Settings wanted = p.app.settings();
    wanted.speech.language = "xx";
    p.said.clear();
    p.app.apply(SettingsChanged{wanted}, p.now);
    EXPECT_THAT(p.news(), HasSubstr("Handrail has no language \"xx\". Available languages: "));
    EXPECT_EQ(spoken_language(), "en");
}

TEST(Language, comes_from_the_environment_if_the_settings_name_none) {
    test::WithEnvironment environment("LC_ALL", nullptr);
    for (const auto& [locale, code] :
         {std::pair{"de_AT.UTF-8", "de"}, std::pair{"en_GB", "en"}, std::pair{"xx_XX", "en"}, std::pair{"C", "en"}}) {
        environment.put(locale);
        EXPECT_TRUE(speak_as_set({}, {}).empty());
        EXPECT_EQ(spoken_language(), code) << locale;
    }
    ASSERT_TRUE(speak_language("en"));
}

}  // namespace language_session_test
}  // namespace handrail
