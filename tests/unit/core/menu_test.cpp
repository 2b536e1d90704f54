// Tests the menu and all that it contains: changes of keys, sets of keys for one hand, input help, settings, worlds and
// sounds.
#include <fstream>
#include <set>

#include "settings/adjust.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace menu_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::shared_ptr<const Scene> room() {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-0.2, 4, 0}, {6.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.scene().name = "room";
    b.start({3, 0.5, 0}, 0.0);
    return b.share();
}

struct Person : test::AppSession {
    explicit Person(const Settings& settings = {}) : AppSession(settings) {
        app.apply(WorldEntered{make_ready(room())}, now);
        run(0.1);
    }
    // Presses a key as in a window, and returns the answer.
    std::string key(const std::string& name) {
        run(0.5);
        said.clear();
        if (!app.apply(KeyTapped{name}, now))
            if (const auto command = app.keys().find(name)) {
                app.apply(CommandDown{*command}, now);
                app.apply(CommandUp{*command}, now);
            }
        return news();
    }
    std::string line(const std::string& text) {
        run(0.5);
        said.clear();
        return app.apply(LineTyped{text}, now) ? news() : "not taken";
    }
    std::map<std::string, std::string> saved() {
        std::map<std::string, std::string> all;
        for (const auto& [key, value] : app.take_setting_changes()) all[key] = value;
        return all;
    }
};

TEST(Menu, leads_by_topic_to_every_command_with_its_key) {
    Person p;
    EXPECT_THAT(p.key("Tab"), HasSubstr("What you can do"));
    p.line("what you can do");
    const std::string topics = p.line("list");
    EXPECT_THAT(topics, HasSubstr("Questions and speech"));
    std::set<std::string> reported;
    for (int topic = 2; topic <= 7; ++topic) {
        p.line(std::to_string(topic));
        const std::string all = p.line("list");
        for (const CommandInfo& row : command_table())
            if (all.find(row.help().substr(0, row.help().size() - 1)) != std::string::npos)
                reported.insert(std::string(row.word));
        p.line("escape");
    }
    for (const CommandInfo& row : command_table()) EXPECT_TRUE(reported.contains(std::string(row.word))) << row.word;
    p.line("4");
    EXPECT_THAT(p.line("list"), HasSubstr("Say which way you face, C."));
    EXPECT_THAT(p.line("which way"), HasSubstr("Facing north"));
    EXPECT_FALSE(p.app.dialogue().is_open()) << "what is done closes the lists";
}

TEST(Rebinding, accepts_the_pressed_key_and_saves_it) {
    Person p;
    p.key("Tab");
    p.line("keys");
    p.line("all topics");
    EXPECT_THAT(p.line("say which way you face"), HasSubstr("Replace with another key"));
    EXPECT_THAT(p.line("another key"), HasSubstr("Press the new key"));
    EXPECT_THAT(p.key("Control+Shift+J"), HasSubstr("Say which way you face: now on Control+Shift+J."));
    EXPECT_EQ(p.saved()["keys.heading"], "Control+Shift+J");
    p.key("Escape");
    p.key("Escape");
    p.key("Escape");
    EXPECT_FALSE(p.app.dialogue().is_open());
    EXPECT_THAT(p.key("Control+Shift+J"), HasSubstr("Facing north"));
    EXPECT_THAT(p.key("C"), Not(HasSubstr("Facing north")));
}

TEST(Rebinding, reports_conflicts_for_the_person_to_decide_and_can_restore_the_built_in_key) {
    Person p;
    const auto request_of = [&](const std::string& what) {
        p.key("Tab");
        p.line("keys");
        p.line("all topics");
        p.line("say which way you face");
        p.line(what);
    };
    const auto leave = [&] {
        while (p.app.dialogue().is_open()) p.key("Escape");
    };
    request_of("add another");
    EXPECT_THAT(p.key("E"), HasSubstr("E is already used for: Say what the hand is touching"));
    EXPECT_THAT(p.line("leave"), HasSubstr("Left as it is."));
    EXPECT_EQ(p.app.keys().find("E"), Command::WhatIsThis);
    leave();
    request_of("add another");
    p.key("E");
    EXPECT_THAT(p.line("take the key"), HasSubstr("now on C or E."));
    EXPECT_EQ(p.app.keys().find("E"), Command::Heading);
    EXPECT_EQ(p.app.keys().find("C"), Command::Heading);
    EXPECT_EQ(p.app.keys().keys_of(Command::WhatIsThis), "");
    const auto saved = p.saved();
    EXPECT_EQ(saved.at("keys.what"), "none");
    EXPECT_EQ(saved.at("keys.heading"), "C E");
    leave();
    // The saved settings have the same meaning at the next start, and cause no error.
    Settings again;
    again.keys = {{"what", "none"}, {"heading", "C E"}};
    EXPECT_TRUE(KeyMap(again.keys).problems().empty());
    EXPECT_EQ(KeyMap(again.keys).find("none"), std::nullopt);
    request_of("restore the default key");
    EXPECT_EQ(p.app.keys().keys_of(Command::Heading), "C");
    leave();
    request_of("replace");
    EXPECT_THAT(p.line("Escape"), HasSubstr("Left as it is."));
    leave();
    request_of("replace");
    EXPECT_THAT(p.line("what key?"), HasSubstr("is not the name of a key"));
    leave();
    request_of("replace");
    EXPECT_FALSE(p.app.apply(KeyTapped{"F12"}, p.now)) << "the stop key stops, whatever is asked";
}

TEST(InputHelp, explains_keys_without_performing_them_until_it_is_switched_off) {
    Person p;
    EXPECT_THAT(p.key("Shift+F1"), StartsWith("Input help on."));
    EXPECT_THAT(p.key("Up"), StartsWith("Up: Walk one step forward"));
    EXPECT_THAT(p.key("F4"), StartsWith("F4: Switch between Map"));
    EXPECT_THAT(p.key("Pause"), StartsWith("Pause: does nothing."));
    EXPECT_THAT(p.line("scale-bar"), StartsWith("scale-bar: Say how long five steps are"));
    EXPECT_TRUE(p.app.idle());
    EXPECT_EQ(p.app.settings().workspace.frame, FrameChoice::Map);
    EXPECT_FALSE(p.app.apply(KeyTapped{"F12"}, p.now));
    EXPECT_THAT(p.key("Shift+F1"), StartsWith("Input help off."));
    EXPECT_THAT(p.key("Pause"), "") << "an unknown key says nothing";
    p.key("F4");
    EXPECT_EQ(p.app.settings().workspace.frame, FrameChoice::Walk);
}

TEST(OneHandedKeys, cover_the_most_used_commands_for_one_hand_without_conflicts) {
    for (const KeyboardHand hand : {KeyboardHand::Left, KeyboardHand::Right}) {
        const KeyMap keys({}, hand);
        EXPECT_TRUE(keys.problems().empty());
        for (const Command command : {Command::Forward,
                                      Command::Back,
                                      Command::TurnLeft,
                                      Command::TurnRight,
                                      Command::WhereAmI,
                                      Command::AroundMe,
                                      Command::AheadOfMe,
                                      Command::LookNext,
                                      Command::WhatIsThis,
                                      Command::Heading,
                                      Command::Repeat,
                                      Command::StopSpeech,
                                      Command::StopEverything,
                                      Command::ToggleForces,
                                      Command::Home,
                                      Command::Use,
                                      Command::Menu,
                                      Command::Help,
                                      Command::SwitchFrame,
                                      Command::VerbosityCycle,
                                      Command::ScaleBuilding,
                                      Command::ScaleFloor,
                                      Command::WorkspaceForward,
                                      Command::WorkspaceBack}) {
            const std::string names = keys.words_of_keys(command);
            bool within = false;
            for (std::size_t at = 0; at < names.size();) {
                const std::size_t end = std::min(names.find(' ', at), names.size());
                within |= reaches(hand, names.substr(at, end - at));
                at = end + 1;
            }
            EXPECT_TRUE(within) << info(command).word << ": " << names;
        }
        std::map<std::string, std::string> owner;
        for (const SetKeys& row : keys_for(hand)) {
            ASSERT_NE(find_command(row.word), nullptr) << row.word;
            const std::string names(row.keys);
            for (std::size_t at = 0; at < names.size();) {
                const std::size_t end = std::min(names.find(' ', at), names.size());
                const auto [held, fresh] = owner.emplace(names.substr(at, end - at), row.word);
                EXPECT_TRUE(fresh) << held->first << " of " << held->second << " and " << row.word;
                at = end + 1;
            }
        }
    }
    EXPECT_TRUE(keys_for(KeyboardHand::Both).empty());
    EXPECT_FALSE(reaches(KeyboardHand::Left, "F1x"));
    EXPECT_FALSE(reaches(KeyboardHand::Left, "F12"));
    EXPECT_TRUE(reaches(KeyboardHand::Right, "Control+F12"));
}

TEST(OneHandedKeys, are_chosen_in_the_menu_and_take_effect_at_once) {
    Person p;
    p.key("Tab");
    p.line("keys");
    p.key("End");
    EXPECT_THAT(p.key("Right"), HasSubstr("left"));
    EXPECT_EQ(p.app.keys().find("W"), Command::Forward);
    EXPECT_EQ(p.app.keys().find("Up"), Command::Forward);
    EXPECT_EQ(p.saved()["keyboard.hand"], "left");
    // A person's own key is preferred to the set of keys for one hand.
    Settings own;
    own.keyboard.hand = KeyboardHand::Left;
    own.keys["heading"] = "W";
    EXPECT_EQ(KeyMap(own.keys, own.keyboard.hand).find("W"), Command::Heading);
}

TEST(SettingsMenu, changes_every_setting_by_steps_or_by_typing_and_refuses_with_the_range) {
    Person p;
    p.key("Tab");
    p.line("settings");
    p.line("speech");
    p.line("escape");
    p.line("speech");
    const std::string all = p.line("list");
    EXPECT_THAT(all, HasSubstr("Amount of speech, 2"));
    EXPECT_THAT(all, HasSubstr("Distances in steps, on"));
    while (p.key("Down").find("Distances in steps") == std::string::npos) {
    }
    EXPECT_THAT(p.key("Right"), HasSubstr("off"));
    EXPECT_FALSE(p.app.settings().speech.distances_in_steps);
    EXPECT_EQ(p.saved()["speech.distances_in_steps"], "false");
    EXPECT_THAT(p.line("amount of speech"), HasSubstr("How much is said"));
    EXPECT_THAT(p.line("9"), HasSubstr("must be a whole number, 0 to 4"));
    EXPECT_EQ(p.app.settings().speech.verbosity, 2);
    p.line("amount of speech");
    EXPECT_THAT(p.line("3"), HasSubstr("3"));
    EXPECT_EQ(p.app.settings().speech.verbosity, 3);
    EXPECT_THAT(p.line("list"), HasSubstr("Amount of speech, 3"));
}

TEST(AdjustSettings, every_setting_steps_up_and_down_within_its_range_and_comes_back) {
    for (const std::string_view topic : setting_topics())
        for (const SettingLine& line : setting_lines(topic, Settings{})) {
            Settings settings;
            EXPECT_FALSE(line.name.empty() || line.meaning.empty() || line.range.empty()) << line.key;
            if (!line.steps) continue;
            std::set<std::string> seen;
            for (const int by : {1, -1})
                for (int i = 0; i < 60; ++i) {
                    const std::string value = stepped(line.key, settings, by);
                    ASSERT_TRUE(change_setting(settings, line.key, value)) << line.key << " " << value;
                    seen.insert(value);
                }
            EXPECT_GE(seen.size(), 2U) << line.key;
            EXPECT_LE(seen.size(), 80U) << line.key;
        }
    Settings settings;
    EXPECT_EQ(stepped("walk.step_length_m", settings, 1), "0.75");
    EXPECT_EQ(stepped("speech.rate_wpm", settings, -1), "165");
    EXPECT_FALSE(change_setting(settings, "walk.step_length_m", "9"));
    EXPECT_EQ(settings.walk.step_length_m, 0.7);
}

TEST(WorldsMenu, offers_bundled_worlds_recent_worlds_and_any_folder) {
    const test::TemporaryFolder folder;
    folder.write("my_house.map", "");
    folder.write("old-school.map", "");
    folder.write("notes.txt", "");
    const test::TemporaryFolder other;
    other.write("museum.obj", "");
    Person p;
    p.app.apply(WorldsKnown{{folder.path(), {other.path() / "museum.obj"}}}, p.now);
    p.key("Tab");
    EXPECT_THAT(p.line("worlds"), HasSubstr("Museum, visited before, 1 of 4"));
    EXPECT_THAT(p.line("list"), HasSubstr("My house, comes with Handrail. 3: Old school"));
    p.line("old");
    EXPECT_EQ(p.app.requests().take_world(), WorldRequest{folder.path() / "old-school.map"});
    EXPECT_EQ(p.app.requests().take_world(), std::nullopt);
    EXPECT_FALSE(p.app.dialogue().is_open());
    p.key("Tab");
    p.line("worlds");
    p.line("another");
    EXPECT_THAT(p.line("/nowhere/at all"), HasSubstr("There is no world at /nowhere/at all"));
    p.line("another");
    p.line(other.path().string());
    p.line("museum");
    EXPECT_EQ(p.app.requests().take_world(), WorldRequest{other.path() / "museum.obj"});
    p.key("Tab");
    p.line("worlds");
    p.line("another");
    p.line((folder.path() / "my_house.map").string());
    EXPECT_EQ(p.app.requests().take_world(), WorldRequest{folder.path() / "my_house.map"});
}

TEST(RecentWorlds, are_kept_between_sessions_and_a_damaged_file_is_set_aside_and_reported) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "state" / "recent-worlds.txt";
    {
        RecentWorlds recent(file);
        EXPECT_EQ(recent.take_news(), "");
        for (int i = 0; i < 12; ++i) recent.add(fmt::format("/worlds/{}.map", i));
        recent.add("/worlds/5.map");
        recent.add("/worlds/\xC3\xA9t\xC3\xA9.map");
    }
    RecentWorlds again(file);
    ASSERT_EQ(again.worlds().size(), RecentWorlds::kMost);
    EXPECT_EQ(again.worlds()[0], "/worlds/\xC3\xA9t\xC3\xA9.map");
    EXPECT_EQ(again.worlds()[1], "/worlds/5.map");
    for (const std::string& damaged : {std::string("\xff\xfe\x00junk", 7), std::string("no path\n"),
                                       std::string("/a\x01/b.map\n"), std::string(70000, 'x')}) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
        RecentWorlds recent(file);
        EXPECT_TRUE(recent.worlds().empty());
        EXPECT_THAT(recent.take_news(), HasSubstr("damaged"));
        EXPECT_EQ(recent.take_news(), "");
        EXPECT_TRUE(std::filesystem::exists(file.string() + ".damaged"));
        EXPECT_FALSE(std::filesystem::exists(file));
        recent.add("/worlds/new.map");
        EXPECT_EQ(RecentWorlds(file).worlds().size(), 1U);
    }
    EXPECT_EQ(name_of_file("/a/b/first_room.map"), "First room");
    EXPECT_EQ(name_of_file("/a/\xff\xfe.map"), "a world without a name");
}

TEST(SoundsMenu, plays_the_chosen_sound) {
    Person p;
    p.key("Tab");
    p.line("dictionary");
    EXPECT_THAT(p.key("Enter"), Not(testing::IsEmpty()));
    EXPECT_TRUE(p.app.dialogue().is_open());
}

}  // namespace menu_test
}  // namespace handrail
