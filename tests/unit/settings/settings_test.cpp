#include "settings/settings.h"

#include <rapidcheck/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace settings_test {
namespace fs = std::filesystem;
using test::content_of;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

SettingRow row_of(const SettingsStore& store, const std::string& key) {
    for (const SettingRow& row : store.explain())
        if (row.key == key) return row;
    ADD_FAILURE() << "no row " << key;
    return {};
}

std::vector<std::string> sentences(const std::vector<Diagnostic>& problems) {
    std::vector<std::string> all;
    for (const Diagnostic& problem : problems) all.push_back(problem.sentence());
    return all;
}

// Returns everything that explain() shows, to compare two stores.
std::string shown(const SettingsStore& store) {
    std::string text;
    for (const SettingRow& row : store.explain()) text += row.key + "=" + row.value + "\n";
    return text;
}

TEST(Settings, start_with_the_defaults_of_the_struct_each_within_its_range) {
    const SettingsStore store;
    const Settings plain;
    EXPECT_EQ(store.values().workspace.scale, plain.workspace.scale);
    SettingsStore again;
    for (const SettingRow& row : store.explain()) {
        EXPECT_EQ(row.source, SettingSource::Default) << row.key;
        EXPECT_FALSE(row.range.empty() || row.meaning.empty()) << row.key;
        EXPECT_TRUE(again.set(row.key, row.value, SettingSource::Live)) << row.key << " = " << row.value;
    }
    EXPECT_EQ(shown(store), shown(again));
}

TEST(Settings, report_the_source_of_each_value_with_file_and_line) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("settings.toml", "# mine\n[workspace]\nscale = 30\nhand_height_m = 1.2\n");
    SettingsStore store;
    EXPECT_THAT(store.load_file(file, SettingSource::UserFile), IsEmpty());
    ASSERT_TRUE(store.set_assignment("workspace.hand_height_m=0.9", SettingSource::CommandLine));
    EXPECT_EQ(store.values().workspace.scale, 30.0);
    EXPECT_EQ(row_of(store, "workspace.scale").source, SettingSource::UserFile);
    EXPECT_EQ(row_of(store, "workspace.scale").origin, file.string() + ":3");
    EXPECT_EQ(row_of(store, "workspace.hand_height_m").value, "0.9");
    EXPECT_EQ(row_of(store, "workspace.hand_height_m").origin, "--set");
    EXPECT_EQ(row_of(store, "walk.speed_m_per_s").source, SettingSource::Default);
}

TEST(Settings, let_the_stronger_source_win_in_any_loading_order) {
    SettingsStore store;
    ASSERT_TRUE(store.set("workspace.scale", "10", SettingSource::CommandLine));
    ASSERT_TRUE(store.set("workspace.scale", "20", SettingSource::World));
    EXPECT_EQ(store.values().workspace.scale, 10.0);
    ASSERT_TRUE(store.set("workspace.scale", "30", SettingSource::Live));
    EXPECT_EQ(store.values().workspace.scale, 30.0);
    store.clear(SettingSource::Live);
    store.clear(SettingSource::CommandLine);
    EXPECT_EQ(store.values().workspace.scale, 20.0);
    store.clear(SettingSource::World);
    EXPECT_EQ(store.values().workspace.scale, 60.0);
}

TEST(Settings, suggest_the_nearest_key_for_an_unknown_one_and_apply_the_rest) {
    const TemporaryFolder folder;
    SettingsStore store;
    const auto problems = store.load_file(
        folder.write("settings.toml", "[workspace]\nscael = 30\nhand_height_m = 1.5\n"), SettingSource::UserFile);
    EXPECT_THAT(sentences(problems), ElementsAre("settings.toml, line 2, column 9: error: There is no setting "
                                                 "workspace.scael; the nearest is workspace.scale. "
                                                 "It is ignored; the rest is used."));
    EXPECT_EQ(store.values().workspace.hand_height_m, 1.5);
}

TEST(Settings, suggest_the_nearest_key_of_the_same_table_before_nearer_ones_elsewhere) {
    const TemporaryFolder folder;
    SettingsStore store;
    // The wrong key in [workspace] is most similar to a key of another table. The wrong key in [speech] is spelled
    // exactly like a key of another table.
    const auto problems = store.load_file(
        folder.write("settings.toml",
                     "[speech]\nspeed_m_per_s = 30\n[workspace]\nbody_radius_m = 2\n[spaech]\nverbosity = 1\n"),
        SettingSource::UserFile);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_THAT(problems[0].message, HasSubstr("nearest is speech."));
    EXPECT_THAT(problems[1].message, HasSubstr("nearest is workspace."));
    EXPECT_THAT(problems[2].message, HasSubstr("nearest is speech.verbosity"))
        << "of a table that there is not, among all";
    EXPECT_THAT(store.set("walk.sound", "1", SettingSource::Live).error().message, HasSubstr("walk."));
}

TEST(Settings, report_the_legal_range_and_ignore_values_outside_it_or_of_the_wrong_type) {
    const TemporaryFolder folder;
    SettingsStore store;
    const auto problems = store.load_file(
        folder.write("settings.toml",
                     "[workspace]\nscale = 900\n[speech]\nrate_wpm = 99.5\nverbosity = \"all\"\ndistances_in_steps = "
                     "1\nvoice = \"\"\n"
                     "[haptic]\nceiling = 'strong'\ndevice = [1]\nfriction_mu = nan\ndamping_ns_per_m = 1979-05-27\n"),
        SettingSource::UserFile);
    ASSERT_THAT(sentences(problems), SizeIs(9));
    EXPECT_THAT(problems[6].message,
                "The setting haptic.device is a list or a date, but must be auto, none or the name of a device.");
    EXPECT_THAT(problems[0].message,
                "The setting workspace.scale is 900, but must be 1 to 500 world metres per hand metre.");
    EXPECT_THAT(problems[1].message, HasSubstr("a whole number, 80 to 450"));
    EXPECT_THAT(problems[3].message, HasSubstr("true or false"));
    EXPECT_THAT(problems[5].message, HasSubstr("light, normal or full"));
    EXPECT_EQ(shown(store), shown(SettingsStore{}));
    for (const char* bad :
         {"workspace.scale=0.999", "workspace.scale=500.001", "workspace.scale=inf",
          "workspace.scale=", "workspace.scale=1,5", "speech.verbosity=5", "speech.verbosity=1.5",
          "sound.wall_tone=maybe", "haptic.ceiling=", "scale", "=3", "keys.UPPER=F2", "speech.voice=\xff"})
        EXPECT_FALSE(store.set_assignment(bad, SettingSource::CommandLine)) << bad;
    EXPECT_EQ(shown(store), shown(SettingsStore{}));
}

TEST(Settings, report_errors_of_a_file_in_german) {
    const test::InLanguage german("de");
    const TemporaryFolder folder;
    SettingsStore store;
    const auto problems =
        store.load_file(folder.write("settings.toml", "[workspace]\nscael = 40\n"), SettingSource::UserFile);
    EXPECT_THAT(sentences(problems), ElementsAre("settings.toml, Zeile 2, Spalte 9: Fehler: Die Einstellung "
                                                 "workspace.scael gibt es nicht; am ähnlichsten ist "
                                                 "workspace.scale. Sie gilt nicht; der Rest schon."));
    EXPECT_EQ(store.set("speech.rate_wpm", "200", SettingSource::World).error().message,
              "Eine Welt darf speech.rate_wpm nicht setzen: Über Kräfte, Sprache, Klang und Tasten bestimmt nur der "
              "Mensch selbst.");
    EXPECT_EQ(source_name(SettingSource::UserFile), "eigene Einstellungsdatei");
}

TEST(Settings, refuse_every_force_speech_and_sound_setting_and_every_key_from_a_world) {
    for (const SettingRow& row : SettingsStore{}.explain()) {
        const bool personal = row.key.starts_with("speech.") || row.key.starts_with("sound.") ||
                              row.key == "haptic.ceiling" || row.key == "haptic.stiffness_fraction" ||
                              row.key == "haptic.device";
        SettingsStore store;
        const Result<void> set = store.set(row.key, row.value, SettingSource::World);
        EXPECT_EQ(world_may_set(row.key), set.has_value()) << row.key;
        EXPECT_FALSE(personal && set) << row.key;
    }
    SettingsStore store;
    EXPECT_THAT(store.set("haptic.ceiling", "full", SettingSource::World).error().message,
                HasSubstr("A world may not set haptic.ceiling"));
    EXPECT_FALSE(store.set("keys.where", "F2", SettingSource::World));
    EXPECT_FALSE(store.set("workspace.device.falcon.scale", "20", SettingSource::World));
    const TemporaryFolder folder;
    const auto problems = store.load_file(
        folder.write("world.toml", "[haptic]\nceiling = 'full'\n[workspace]\nscale = 20\n"), SettingSource::World);
    EXPECT_THAT(problems, SizeIs(1));
    EXPECT_EQ(store.values().haptic.ceiling, ForceCeiling::Normal);
    EXPECT_EQ(store.values().workspace.scale, 20.0);
}

TEST(Settings, store_overrides_by_device_name_and_keys_by_command) {
    const TemporaryFolder folder;
    SettingsStore store({"where", "repeat"});
    const auto problems = store.load_file(
        folder.write("settings.toml",
                     "[workspace.device.\"Falcon\"]\nscale = 40\nspeed = 1\n[workspace.device.\"v1.5\"]\nscale = "
                     "9\n[keys]\nwhere = \"F9\"\nwhree = \"F8\"\n"),
        SettingSource::UserFile);
    ASSERT_THAT(problems, SizeIs(2));
    EXPECT_THAT(problems[0].message, HasSubstr("nearest is workspace.device.Falcon.scale"));
    EXPECT_THAT(problems[1].message, HasSubstr("nearest is keys.where"));
    EXPECT_EQ(store.values().workspace.devices.at("falcon").scale, 40.0);
    EXPECT_EQ(store.values().workspace.devices.at("v1.5").scale, 9.0);
    EXPECT_FALSE(store.values().workspace.devices.at("falcon").hand_height_m);
    EXPECT_EQ(store.values().keys.at("where"), "F9");
    ASSERT_TRUE(store.set_assignment("workspace.device.\"FALCON\".scale=41", SettingSource::Live));
    EXPECT_EQ(store.values().workspace.devices.at("falcon").scale, 41.0);
    EXPECT_EQ(row_of(store, "workspace.device.falcon.scale").value, "41.0");
    EXPECT_FALSE(store.set("workspace.device.falcon.scale", "5000", SettingSource::Live));
}

// Formerly the command of such a setting got no key at all, and no message reported that.
TEST(Settings, refuse_key_names_that_nobody_can_press_and_report_their_line) {
    const TemporaryFolder folder;
    SettingsStore store({"where", "home", "look", "use", "again", "quit"});
    const auto problems = store.load_file(
        folder.write("settings.toml",
                     "[keys]\nwhere = \"F99\"\nhome = \"Shift+\"\nlook = \"F5 Shift+Control+W\"\nagain = "
                     "\"Control+Shift\"\nuse = \"control+alt+shift+F1 w Control none Keypad5\"\nquit = \"Strg+Q\"\n"),
        SettingSource::UserFile);
    ASSERT_THAT(problems, SizeIs(5));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(problems[i].line, static_cast<int>(i) + 2);
    EXPECT_THAT(problems[0].sentence(), HasSubstr("settings.toml, line 2"));
    EXPECT_THAT(problems[0].message, HasSubstr("F99 is not a valid key for keys.where. Did you mean F9?"));
    EXPECT_THAT(problems[1].message, HasSubstr("Shift+ is not a valid key"));
    EXPECT_THAT(problems[2].message, HasSubstr("Did you mean Control+Shift+W?"));
    EXPECT_EQ(problems[4].line, 7);
    EXPECT_EQ(store.values().keys.size(), 1U) << "those commands keep their own keys";
    EXPECT_TRUE(store.values().keys.contains("use"));
    EXPECT_FALSE(store.set("keys.where", "Shift+", SettingSource::Live));
    ASSERT_TRUE(store.set("keys.where", "\"F9\"", SettingSource::CommandLine)) << "as the list of settings shows it";
    EXPECT_EQ(store.values().keys.at("where"), "F9");
}

TEST(Profiles, are_saved_by_device_and_serial_number_with_their_origin) {
    const TemporaryFolder folder;
    const fs::path file = folder.write(
        "settings.toml", "[profile.\"Falcon A9.1\"]\nceiling_n = 2\nhand = \"Left\"\nscael = 1\nfuture = [1]\n");
    SettingsStore store;
    EXPECT_THAT(sentences(store.load_file(file, SettingSource::UserFile)),
                testing::Each(HasSubstr("There is no setting profile.")));
    const std::string key = profile_key("falcon", "A9.1");
    EXPECT_EQ(key, "falcon a9.1");
    ASSERT_TRUE(store.values().profiles.contains(key));
    EXPECT_EQ(store.values().profiles.at(key).ceiling_n, 2.0);
    EXPECT_EQ(store.values().profiles.at(key).hand, HoldingHand::Left);
    EXPECT_THAT(row_of(store, "profile.falcon a9.1.ceiling_n").origin, HasSubstr("settings.toml:2"));
    ASSERT_TRUE(store.set("profile." + key + ".ceiling_n", "1.5", SettingSource::Live));
    ASSERT_TRUE(store.set("profile.sim-t.gentlest_n", "0.25", SettingSource::Live));
    EXPECT_FALSE(store.set("profile.sim-t.gentlest_n", "25", SettingSource::Live));
    EXPECT_FALSE(store.set("profile.sim-t.hand", "both", SettingSource::Live));
    EXPECT_FALSE(store.set("profile.sim-t.ceiling_n", "3", SettingSource::World)) << "forces are the person's alone";
    ASSERT_TRUE(store.save_user_file());
    SettingsStore again;
    again.load_file(file, SettingSource::UserFile);
    ASSERT_EQ(again.values().profiles.size(), 2U);
    EXPECT_EQ(again.values().profiles.at("sim-t").gentlest_n, 0.25);
    EXPECT_THAT(content_of(file), testing::AllOf(HasSubstr("scael = 1"), HasSubstr("future = [1]")))
        << "what is not understood is kept";
}

// If a labyrinth fixes its scale, the labyrinth's scale must apply to every device, including devices for which the
// settings state another scale.
TEST(SettingsStore, lets_a_world_override_devices_with_individual_values) {
    const test::TemporaryFolder folder;
    SettingsStore store;
    ASSERT_THAT(store.load_file(folder.write("settings.toml",
                                             "[workspace]\nscale = 70\n[workspace.device.falcon]\nscale = 50\n"
                                             "[profile.sim-t]\nscale = 40\noffset_up_m = 0.02\n"),
                                SettingSource::UserFile),
                testing::IsEmpty());
    const auto scales = [&] {
        const Settings& now = store.values();
        return std::vector<double>{now.workspace.devices.at("falcon").scale.value_or(now.workspace.scale),
                                   now.profiles.at("sim-t").scale.value_or(now.workspace.scale),
                                   now.profiles.at("sim-t").offset_up_m.value_or(-1.0)};
    };
    EXPECT_THAT(scales(), testing::ElementsAre(50.0, 40.0, 0.02));
    ASSERT_TRUE(store.set("workspace.scale", "8", SettingSource::World));
    EXPECT_THAT(scales(), testing::ElementsAre(8.0, 8.0, 0.02));
    store.clear(SettingSource::World);
    EXPECT_THAT(scales(), testing::ElementsAre(50.0, 40.0, 0.02)) << "leaving the world gives them back";
}

TEST(Profiles, with_one_damaged_value_are_ignored_with_one_sentence_until_the_next_calibration) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("settings.toml",
                                       "[profile.falcon]\nceiling_n = 2.0\nscale = -7\nhand = "
                                       "3\n[profile.sim-t]\nceiling_n = 1.0\n[walk]\nstep_length_m = 0.6\n");
    SettingsStore store;
    const auto problems = sentences(store.load_file(file, SettingSource::UserFile));
    ASSERT_THAT(problems, SizeIs(1));
    EXPECT_THAT(problems[0], testing::AllOf(HasSubstr("profile.falcon."), HasSubstr("is not used"),
                                            HasSubstr("handrail calibrate")));
    EXPECT_FALSE(store.values().profiles.contains("falcon")) << "nothing of it is used";
    EXPECT_TRUE(store.values().damaged_profiles.contains("falcon"));
    EXPECT_EQ(store.values().profiles.at("sim-t").ceiling_n, 1.0);
    EXPECT_EQ(store.values().walk.step_length_m, 0.6);
    ASSERT_TRUE(store.set("profile.falcon.ceiling_n", "1.1", SettingSource::Live));
    EXPECT_TRUE(store.values().damaged_profiles.empty());
    EXPECT_EQ(store.values().profiles.at("falcon").ceiling_n, 1.1);
}

TEST(SaveSettings, keeps_comments_unknown_keys_and_everything_else_that_the_person_wrote) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("settings.toml",
                                       "# \xC3\xA9 mine\n[workspace]\nscale = 30 # small\nfuture = { a = 1, b = [2, 3] "
                                       "}\n\n[plugin]\nx = \"\\u0001\\n\"\n[speech] # voice\nrate_wpm = 200");
    SettingsStore store;
    store.load_file(file, SettingSource::UserFile);
    ASSERT_TRUE(store.set("workspace.scale", "42", SettingSource::Live));
    ASSERT_TRUE(store.set("speech.verbosity", "3", SettingSource::Live));
    ASSERT_TRUE(store.set("haptic.ceiling", "light", SettingSource::Live));
    ASSERT_TRUE(store.set("workspace.device.falcon.scale", "41", SettingSource::Live));
    ASSERT_TRUE(store.save_user_file());
    EXPECT_EQ(content_of(file),
              "# \xC3\xA9 mine\n[workspace]\nscale = 42.0 # small\nfuture = { a = 1, b = [2, 3] }\n\n[plugin]\nx = "
              "\"\\u0001\\n\"\n[speech] # voice\nverbosity "
              "= 3\nrate_wpm = 200\n\n"
              "[haptic]\nceiling = \"light\"\n\n[workspace.device.\"falcon\"]\nscale = 41.0\n");
}

TEST(SaveSettings, keeps_the_meaning_of_a_file_with_unusual_syntax) {
    const TemporaryFolder folder;
    const fs::path file =
        folder.write("settings.toml", "workspace.scale = 30\nspeech = { rate_wpm = 200, other = 'x' }\nhaptic = 3\n");
    SettingsStore store;
    store.load_file(file, SettingSource::UserFile);
    ASSERT_TRUE(store.set("workspace.hand_height_m", "0.3", SettingSource::Live));
    ASSERT_TRUE(store.set("speech.verbosity", "3", SettingSource::Live));
    ASSERT_TRUE(store.set("haptic.friction_mu", "0.1", SettingSource::Live));
    ASSERT_TRUE(store.save_user_file());
    SettingsStore again;
    // The only problem is the unknown entry speech.other.
    EXPECT_THAT(again.load_file(file, SettingSource::UserFile), SizeIs(1)) << content_of(file);
    EXPECT_EQ(shown(again), shown(store));
    EXPECT_THAT(content_of(file), HasSubstr("other"));
}

TEST(SaveSettings, writes_nothing_if_nothing_was_changed) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "deep" / "settings.toml";
    SettingsStore store;
    EXPECT_THAT(store.load_file(file, SettingSource::UserFile), IsEmpty());
    ASSERT_TRUE(store.set("workspace.scale", "42", SettingSource::CommandLine));
    EXPECT_TRUE(store.save_user_file());
    EXPECT_FALSE(fs::exists(file));
    ASSERT_TRUE(store.set("workspace.scale", "43", SettingSource::Live));
    EXPECT_TRUE(store.save_user_file());
    EXPECT_EQ(content_of(file), "[workspace]\nscale = 43.0\n");
}

TEST(SaveSettings, never_replaces_a_damaged_file_and_reports_it) {
    const TemporaryFolder folder;
    const std::string damaged = "[workspace\nscale = 30\n";
    const fs::path file = folder.write("settings.toml", damaged);
    SettingsStore store;
    const auto problems = store.load_file(file, SettingSource::UserFile);
    ASSERT_THAT(problems, SizeIs(1));
    EXPECT_THAT(problems[0].sentence(), HasSubstr("settings.toml, line 1"));
    EXPECT_THAT(problems[0].sentence(), HasSubstr("the file is left unchanged"));
    EXPECT_EQ(shown(store), shown(SettingsStore{}));
    ASSERT_TRUE(store.set("workspace.scale", "42", SettingSource::Live));
    const Result<void> saved = store.save_user_file();
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().sentence(), HasSubstr("not saved"));
    EXPECT_EQ(content_of(file), damaged);
}

TEST(SaveSettings, never_replaces_an_unreadable_file) {
    const TemporaryFolder folder;
    SettingsStore store;
    const auto problems = store.load_file(folder.path(), SettingSource::UserFile);  // a folder in place of the file
    ASSERT_THAT(problems, SizeIs(1));
    EXPECT_THAT(problems[0].sentence(), HasSubstr("folder"));
    ASSERT_TRUE(store.set("workspace.scale", "42", SettingSource::Live));
    EXPECT_FALSE(store.save_user_file());

    if (::geteuid() == 0) GTEST_SKIP() << "root reads every file; the rest of this test needs an ordinary user";
    const fs::path secret = folder.write("secret.toml", "[workspace]\nscale = 30\n");
    fs::permissions(secret, fs::perms::none);
    EXPECT_THAT(store.load_file(secret, SettingSource::UserFile), SizeIs(1));
    EXPECT_FALSE(store.save_user_file());
}

// The process's limit for the size of files simulates a full disk: writing stops half way with an error.
TEST(SaveSettings, leaves_the_old_file_complete_if_the_disk_is_full) {
    const TemporaryFolder folder;
    const std::string old = "[workspace]\nscale = 30\n# " + std::string(5000, 'x') + "\n";
    const fs::path file = folder.write("settings.toml", old);
    SettingsStore store;
    store.load_file(file, SettingSource::UserFile);
    ASSERT_TRUE(store.set("workspace.scale", "42", SettingSource::Live));
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Result<void> saved = store.save_user_file();
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().sentence(), HasSubstr("could not be saved"));
    EXPECT_EQ(content_of(file), old);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}), 1)
        << "nothing half written is left beside it";
    EXPECT_TRUE(store.save_user_file());
    EXPECT_THAT(content_of(file), HasSubstr("scale = 42.0"));
}

TEST(LoadSettings, survives_files_cut_at_every_byte_or_with_every_byte_replaced) {
    const TemporaryFolder folder;
    const std::string whole =
        "[workspace]\nscale = 30 # \xC3\xA9\n[workspace.device.\"a.b\"]\nscale = 4e1\n[keys]\nwhere = "
        "'F2'\n[speech]\nvoice = \"\"\"de\"\"\"\n";
    SettingsStore judge;
    const auto load = [&](const std::string& text) {
        SettingsStore store;
        const auto problems = store.load_file(folder.write("settings.toml", text), SettingSource::UserFile);
        for (const SettingRow& row : store.explain())
            EXPECT_TRUE(judge.set(row.key, row.value, SettingSource::Live)) << row.key << "=" << row.value;
        for (const std::string& sentence : sentences(problems))
            EXPECT_THAT(sentence, HasSubstr("settings.toml, line ")) << text;
    };
    for (std::size_t cut = 0; cut <= whole.size(); ++cut) load(whole.substr(0, cut));
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const char c : {'\0', '"', '.', '\xff'}) {
            std::string text = whole;
            text[at] = c;
            load(text);
        }
}

// Makes any legal changes during a session and saves the settings over any earlier settings file. The settings must
// read back exactly.
RC_GTEST_PROP(SaveSettings, reads_back_what_it_saved, ()) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "settings.toml";
    const std::vector<std::string> words{"scale", "where", "falcon", "a.b", "x y",   "\xC3\xA9",
                                         "on",    "3",     "\\",     "'",   "\"q\"", "#"};
    SettingsStore store;
    store.load_file(file, SettingSource::UserFile);
    const std::vector<SettingRow> rows = store.explain();
    for (int round = 0; round < 2; ++round) {
        const int changes = *rc::gen::inRange(1, 12);
        for (int i = 0; i < changes; ++i) {
            const std::string word = *rc::gen::elementOf(words);
            switch (*rc::gen::inRange(0, 4)) {
                case 0:
                    (void)store.set(
                        "workspace.device." + word + "." + *rc::gen::element<std::string>("scale", "hand_height_m"),
                        fmt::format("{}", *rc::gen::inRange(1, 3) / 1.7), SettingSource::Live);
                    break;
                case 1:
                    (void)store.set("keys." + word, *rc::gen::elementOf(words), SettingSource::Live);
                    break;
                case 2:
                    (void)store.set(*rc::gen::element<std::string>("speech.voice", "haptic.device"), word,
                                    SettingSource::Live);
                    break;
                default: {
                    const SettingRow& row =
                        rows[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(rows.size())))];
                    const std::string value = *rc::gen::element<std::string>(
                        "0.1", "1", "2", "100", "0.3333333333333333", "full", "walk", "true", "false", "4");
                    (void)store.set(row.key, value, SettingSource::Live);
                }
            }
        }
        const Result<void> saved = store.save_user_file();
        RC_ASSERT(saved.has_value());
        SettingsStore again;
        RC_ASSERT(again.load_file(file, SettingSource::UserFile).empty());
        RC_ASSERT(shown(again) == shown(store));
    }
}

TEST(UserSettingsPath, follows_the_base_directory_specification) {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const std::string old_config = config ? config : "", old_home = home ? home : "";
    ::setenv("XDG_CONFIG_HOME", "/c", 1);
    EXPECT_EQ(user_settings_path(), "/c/handrail/settings.toml");
    ::setenv("XDG_CONFIG_HOME", "relative", 1);
    ::setenv("HOME", "/h", 1);
    EXPECT_EQ(user_settings_path(), "/h/.config/handrail/settings.toml");
    ::unsetenv("HOME");
    EXPECT_EQ(user_settings_path(), "");
    config ? ::setenv("XDG_CONFIG_HOME", old_config.c_str(), 1) : ::unsetenv("XDG_CONFIG_HOME");
    if (home) ::setenv("HOME", old_home.c_str(), 1);
}

}  // namespace settings_test
}  // namespace handrail
