#include "app/main/command_line.h"

#include <sys/inotify.h>

#include <array>
#include <clocale>
#include <sstream>

#include "app/core/kept/side_file.h"
#include "app/core/kept/world_shelf.h"
#include "app/main/plain_output.h"
#include "haptic/drivers/falcon_device.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/descriptor.h"

namespace handrail {
namespace command_line_test {
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Words = std::vector<std::string>;

template <class T>
T parsed_as(const Words& words) {
    ParsedCommandLine parsed = parse_command_line(words);
    if (const auto* usage = std::get_if<UsageError>(&parsed)) ADD_FAILURE() << usage->sentence;
    if (auto* call = std::get_if<T>(&parsed)) return *call;
    ADD_FAILURE() << "another command, number " << parsed.index();
    return {};
}

// Runs a command that the program must refuse with exit status 2, nothing on stdout, and one sentence on stderr.
// Returns the sentence.
std::string refused(const Words& words) {
    std::ostringstream out, err;
    EXPECT_EQ(run_command_line(words, out, err), 2) << testing::PrintToString(words);
    EXPECT_EQ(out.str(), "");
    const std::string text = err.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_TRUE(text.ends_with(".\n") || text.ends_with("?\n") || text.ends_with(" NAME\n")) << text;
    return text;
}

TEST(CommandLine, accepts_every_option_for_exploring_a_world) {
    const auto call =
        parsed_as<ExploreCall>({"my.map", "--no-window", "--device", "none", "--set", "workspace.scale=40",
                                "--set=walk.turn_deg=45", "--settings", "mine.toml", "--map-scale", "0.025"});
    EXPECT_EQ(call.arguments.world, "my.map");
    EXPECT_TRUE(call.arguments.no_window);
    EXPECT_EQ(call.arguments.device, "none");
    EXPECT_FALSE(call.arguments.left_device);
    const auto two = parsed_as<ExploreCall>({"--device", "touch", "--device", "falcon", "my.map"});
    EXPECT_EQ(two.arguments.device, "touch");
    EXPECT_EQ(two.arguments.left_device, "falcon");
    EXPECT_EQ(two.arguments.world, "my.map");
    EXPECT_THAT(refused({"--device", "a", "--device", "b", "--device", "c"}), HasSubstr("two hands"));
    EXPECT_EQ(call.arguments.common.map_scale_m_per_unit, 0.025);
    EXPECT_EQ(call.settings.file, "mine.toml");
    EXPECT_EQ(call.settings.assignments, (Words{"workspace.scale=40", "walk.turn_deg=45"}));
    EXPECT_FALSE(parsed_as<ExploreCall>({}).arguments.world);
    EXPECT_EQ(parsed_as<ExploreCall>({"--set", "workspace.scale=40", "my.map"}).arguments.world, "my.map")
        << "--set takes one word only";
}

TEST(CommandLine, calibrates_all_parts_or_only_the_named_ones) {
    const auto all = parsed_as<ExploreCall>({"calibrate"});
    ASSERT_TRUE(all.arguments.calibrate);
    EXPECT_EQ(all.arguments.calibrate->size(), wizard_parts().size());
    const auto some = parsed_as<ExploreCall>(
        {"calibrate", "--only", "reach,headphones", "--device", "falcon", "--no-window", "--settings", "mine.toml"});
    EXPECT_EQ(*some.arguments.calibrate, (std::vector{WizardPart::Headphones, WizardPart::Reach}));
    EXPECT_EQ(some.arguments.device, "falcon");
    EXPECT_EQ(some.settings.file, "mine.toml");
    EXPECT_FALSE(parsed_as<ExploreCall>({}).arguments.calibrate);
    EXPECT_THAT(refused({"calibrate", "--only", "rech"}), HasSubstr("nearest name is reach"));
}

TEST(CommandLine, opens_a_world_that_is_named_like_a_command_by_its_path) {
    EXPECT_EQ(parsed_as<ExploreCall>({"./info"}).arguments.world, "./info");
    EXPECT_EQ(parsed_as<InfoArguments>({"info", "info"}).world, "info");
}

TEST(CommandLine, passes_arguments_to_info_touch_scenario_and_settings) {
    const auto about = parsed_as<InfoArguments>({"info", "a.map", "--json", "--map-scale", "1"});
    EXPECT_TRUE(about.json);
    EXPECT_EQ(about.common.map_scale_m_per_unit, 1.0);
    const auto touch = parsed_as<TouchArguments>({"touch",
                                                  "a.map",
                                                  "--path",
                                                  "in.csv",
                                                  "--out",
                                                  "out.csv",
                                                  "--radius",
                                                  "0",
                                                  "--stiffness",
                                                  "500",
                                                  "--damping",
                                                  "2",
                                                  "--friction-static",
                                                  "0.5",
                                                  "--friction-kinetic",
                                                  "0.4",
                                                  "--scale",
                                                  "60",
                                                  "--device",
                                                  "falcon",
                                                  "--map-scale",
                                                  "1e-1"});
    EXPECT_EQ(touch.radius_m, 0.0);
    EXPECT_EQ(touch.stiffness_n_per_m, 500.0);
    EXPECT_EQ(touch.damping_ns_per_m, 2.0);
    EXPECT_EQ(touch.friction_static, 0.5);
    EXPECT_EQ(touch.friction_kinetic, 0.4);
    EXPECT_EQ(touch.scale_world_m_per_hand_m, 60.0);
    EXPECT_EQ(touch.device, "falcon");
    EXPECT_EQ(touch.common.map_scale_m_per_unit, 0.1);
    const auto scenario = parsed_as<ScenarioArguments>(
        {"scenario", "a.toml", "folder", "--junit", "out.xml", "--transcripts", "texts", "--map-scale", "0.025"});
    EXPECT_EQ(scenario.paths.size(), 2U);
    EXPECT_EQ(scenario.junit, "out.xml");
    EXPECT_EQ(scenario.transcripts, "texts");
    EXPECT_EQ(scenario.common.map_scale_m_per_unit, 0.025);
    EXPECT_TRUE(parsed_as<SettingsCall>({"settings", "--explain"}).arguments.explain);
}

TEST(CommandLine, lets_one_friction_option_set_both_coefficients) {
    const auto touch =
        parsed_as<TouchArguments>({"touch", "a", "--path", "i", "--out", "o", "--friction-kinetic", "0.4"});
    EXPECT_EQ(touch.friction_static, 0.4);
    EXPECT_FALSE(parsed_as<TouchArguments>({"touch", "a", "--path", "i", "--out", "o"}).friction_static);
    EXPECT_THAT(
        refused({"touch", "a", "--path", "i", "--out", "o", "--friction-static", "0.3", "--friction-kinetic", "0.4"}),
        HasSubstr("--friction-static (0.3)"));
}

TEST(CommandLine, refuses_negative_infinite_and_malformed_numbers) {
    for (const char* option :
         {"--radius", "--stiffness", "--damping", "--friction-static", "--friction-kinetic", "--scale", "--map-scale"})
        for (const char* word : {"-1", "nan", "inf", "1e999", "1,5", "x", ""})
            EXPECT_THAT(refused({"touch", "a", "--path", "i", "--out", "o", option, word}), HasSubstr(option));
    EXPECT_THAT(refused({"touch", "a", "--path", "i", "--out", "o", "--scale", "0"}), HasSubstr("greater than 0"));
    refused({"a.map", "--map-scale", "0"});
}

TEST(CommandLine, names_the_nearest_option_or_command_in_one_sentence_and_exits_with_2) {
    EXPECT_THAT(refused({"info", "x.map", "--jsno"}), HasSubstr("the nearest name is --json"));
    EXPECT_THAT(refused({"x.map", "--no-windoe"}), HasSubstr("the nearest name is --no-window"));
    EXPECT_THAT(refused({"inof"}), HasSubstr("the nearest name is info"));
    EXPECT_THAT(refused({"tuoch", "a.map", "--path", "x"}), HasSubstr("touch"));
    EXPECT_THAT(refused({"x.map", "y.map"}), HasSubstr("\"y.map\""));
    EXPECT_THAT(refused({"info"}), HasSubstr("WORLD"));
    EXPECT_THAT(refused({"--device", "none", "info", "x.map"}), HasSubstr("--device"));
    EXPECT_THAT(refused({"--set", "nonsense"}), HasSubstr("key=value"));
    EXPECT_THAT(refused({"settings", "--set", "workspace.scael=4"}), HasSubstr("the nearest is workspace.scale"));
    EXPECT_THAT(refused({"settings", "--set", "keys.wheer=F5"}), HasSubstr("the nearest is keys.where"));
}

// Each error message must be one sentence that says what to do. The message must not contain the wording of the
// command-line library.
TEST(CommandLine, reports_errors_in_the_commands_for_recordings_worlds_and_learners) {
    EXPECT_THAT(refused({"report"}), HasSubstr("--html OUT.html"));
    EXPECT_THAT(refused({"report", "--html"}), StartsWith("--html needs a value: OUT.html."));
    EXPECT_THAT(refused({"report", "--html", "a", "--html", "b"}), StartsWith("--html may be given only once"));
    EXPECT_THAT(refused({"report", "one", "two"}), HasSubstr("\"two\""));
    EXPECT_THAT(refused({"report", "--htlm", "a"}), HasSubstr("the nearest name is --html"));
    EXPECT_THAT(refused({"export"}), HasSubstr("WORLD is required"));
    EXPECT_THAT(refused({"export", "first_room"}), HasSubstr("--swell"));
    EXPECT_THAT(refused({"export", "first_room", "--swell", "a.txt"}), HasSubstr(".svg or .pdf"));
    EXPECT_THAT(refused({"export", "first_room", "--swell", "a.svg", "--paper", "a5"}), HasSubstr("a4 or a3"));
    EXPECT_THAT(refused({"export", "first_room", "--swell", "a.svg", "--storey", "x"}), HasSubstr("whole number"));
    EXPECT_THAT(refused({"export", "first_room", "--from", "Door"}), HasSubstr("--route-card"));
    for (const char* speed : {"0.4", "9", "fast", "nan"})
        EXPECT_THAT(refused({"replay", "--speed", speed}), StartsWith("--speed takes a number from 0.5 to 4, not"));
    EXPECT_THAT(refused({"replay", "--speed", "2", "--check"}), HasSubstr("--check"));
    EXPECT_THAT(refused({"learner", "shwo"}), HasSubstr("Did you mean show"));
    EXPECT_THAT(refused({"learner", "show"}), HasSubstr("handrail learner show NAME"));
    EXPECT_THAT(refused({"learner", "consent", "Rook"}), HasSubstr("--give"));
    EXPECT_THAT(refused({"learner", "consent", "Rook", "--give", "everything"}), HasSubstr("remember, record"));
    EXPECT_THAT(refused({"learner", "consent", "Rook", "--give", "record", "--until", "soon"}),
                HasSubstr("a date such as"));
    EXPECT_THAT(refused({"check"}), HasSubstr("WORLD is required"));
    EXPECT_THAT(refused({"check", "a.map", "--jsn"}), HasSubstr("the nearest name is --json"));
    EXPECT_THAT(refused({"check", "a.map", "--unit", "mile"}), HasSubstr("--unit"));
    EXPECT_THAT(refused({"info", "a.map", "--language", "de"}), StartsWith("--language also needs --as-words"));
    EXPECT_THAT(refused({"info", "a.map", "--as-words", "--language", "fr"}), HasSubstr("en or de"));
    EXPECT_THAT(refused({"lesson", "a.toml", "--session", "one"}), StartsWith("--session needs a whole number"));
}

TEST(CommandLine, opens_bundled_worlds_by_name_and_suggests_the_nearest_one) {
    const test::WithEnvironment worlds("HANDRAIL_WORLDS", (test::project_root() / "worlds/maps").c_str());
    for (const char* command : {"info", "check"}) {
        std::ostringstream out, err;
        run_command_line({command, "first_room"}, out, err);
        EXPECT_THAT(out.str(), HasSubstr("first_room.map")) << command << err.str();
        std::ostringstream none, reported;
        EXPECT_EQ(run_command_line({command, "first_rom"}, none, reported), 1);
        EXPECT_THAT(reported.str(), HasSubstr("Did you mean first_room?")) << command;
    }
    std::ostringstream out, err;
    EXPECT_EQ(run_command_line({"export", "first_rom", "--swell", "a.svg"}, out, err), 1);
    EXPECT_THAT(err.str(), HasSubstr("Did you mean first_room?"));
}

TEST(CommandLine, names_what_is_missing_on_the_disk_in_one_sentence) {
    const test::TemporaryFolder home;
    const test::WithEnvironment data("XDG_DATA_HOME", home.path().c_str());
    const std::string none = (home.path() / "none").string();
    for (const Words& words : {Words{"replay", none},
                               {"replay", "--check"},
                               {"replay", none, "--check"},
                               {"report", "--html", (home.path() / "a.html").string()},
                               {"report", none, "--html", (home.path() / "a.html").string()},
                               {"report", "--learner", "Rook", "--csv", "a.csv"},
                               {"learner", "show", "Rook"},
                               {"learner", "delete", "Rook"},
                               {"check", none + ".map"},
                               {"info", none + ".map"},
                               {"export", none + ".map", "--stl", "a.stl"}}) {
        std::ostringstream out, err;
        EXPECT_EQ(run_command_line(words, out, err), 1) << testing::PrintToString(words);
        EXPECT_EQ(out.str(), "") << testing::PrintToString(words);
        const std::string text = err.str();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << testing::PrintToString(words) << text;
    }
}

TEST(CommandLine, prints_no_control_character_of_a_quoted_word) {
    const std::string evil = "ho\x1b]0;title\x07use\n\u202ered";
    for (const Words& words : {Words{evil},
                               {"--" + evil},
                               {"info", "a.map", evil},
                               {"learner", evil},
                               {"learner", "show", evil},
                               {"bench", evil},
                               {"touch", "a.map", "--path", "b.csv", "--out", "c.csv", "--device", evil},
                               {"info", evil},
                               {"check", evil},
                               {"lesson", evil},
                               {"replay", evil},
                               {"export", evil, "--stl", "a.stl"}}) {
        std::ostringstream out, err;
        EXPECT_NE(run_command_line(words, out, err), 0) << testing::PrintToString(words);
        const std::string text = err.str() + out.str();
        EXPECT_THAT(text, Not(testing::ContainsRegex("[\x01-\x09\x0b-\x1f\x7f]"))) << testing::PrintToString(words);
        EXPECT_THAT(text, Not(HasSubstr("\u202e"))) << testing::PrintToString(words);
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    }
}

// These names of worlds would control a terminal, or reverse the text after them.
TEST(CommandLine, prints_names_of_worlds_without_terminal_control_sequences) {
    const test::TemporaryFolder folder;
    const test::WithEnvironment cache("XDG_CACHE_HOME", "/dev/null");
    std::string house = test::content_of(test::bundled_world("house.map"));
    for (const char* key : {"\"message\" \"", "\"name\" \""})
        for (std::size_t at = 0; (at = house.find(key, at)) != std::string::npos;) {
            at += std::string_view(key).size();
            house.insert(at, "\u202eturned\u2066\x1b[31m ");
        }
    const std::string world = folder.write("house.map", house).string(), sheet = (folder.path() / "a.svg").string();
    for (const Words& words : {Words{"info", world},
                               {"check", world},
                               {"info", "--as-words", world},
                               {"info", "--json", world},
                               {"check", "--json", world},
                               {"export", world, "--swell", sheet}}) {
        std::ostringstream out, err;
        run_command_line(words, out, err);
        const std::string text = out.str() + err.str();
        EXPECT_THAT(text, HasSubstr("turned")) << testing::PrintToString(words) << text;
        for (const char* steers : {"\u202e", "\u2066", "\x1b"})
            EXPECT_THAT(text, Not(HasSubstr(steers))) << testing::PrintToString(words);
    }
    const std::string page = test::content_of(sheet);
    EXPECT_THAT(page, Not(HasSubstr("\u202e")));
    EXPECT_FALSE(page.empty());
}

TEST(PlainOutput, lets_all_other_text_through_wherever_it_is_cut) {
    const std::string text = "T\xC3\xBCr \xe2\x80\x9cx\xe2\x80\x9d \xd8\xa8\t5 \xE2\x82\xAC\n\xe2\x80";
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        std::ostringstream to;
        {
            PlainOutput plain(to);
            plain << text.substr(0, cut) << text.substr(cut);
        }
        EXPECT_EQ(to.str(), text) << cut;
    }
    std::ostringstream to;
    PlainOutput(to) << "a\u202eb\u061cc\x1b[1m\u2069\x07" << 5 << std::flush;
    EXPECT_EQ(to.str(), "abc[1m5");
}

// Without a home folder, the program must neither search nor write the folder in which it was started.
TEST(CommandLine, never_searches_the_current_folder_if_there_is_no_home_folder) {
    const test::TemporaryFolder here;
    for (const char* folder : {"lessons", "learners/aaaaaaaa", "recordings/2026-01-01T00-00-00Z-aaaaaaaa"})
        std::filesystem::create_directories(here.path() / folder);
    here.write("lessons/trap.lesson.toml", "handrail_lesson = 1\n");
    here.write("learners/aaaaaaaa/learner.toml", "name = \"Trap\"\n");
    here.write("recordings/2026-01-01T00-00-00Z-aaaaaaaa/events.jsonl", "{}\n");
    const test::WithEnvironment home("HOME", nullptr), data("XDG_DATA_HOME", "relative"),
        state("XDG_STATE_HOME", "relative"), config("XDG_CONFIG_HOME", nullptr);
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(here.path());
    for (const Words& words : {Words{"lesson", "trap", "--check"},
                               {"replay"},
                               {"learner", "show", "Trap"},
                               {"learner", "show", "aaaaaaaa"},
                               {"learner", "delete", "aaaaaaaa", "--yes"},
                               {"learner", "new", "Finch"}}) {
        std::ostringstream out, err;
        EXPECT_NE(run_command_line(words, out, err), 0) << testing::PrintToString(words) << out.str();
        EXPECT_THAT(err.str(), Not(HasSubstr(".toml, line"))) << "it was read: " << testing::PrintToString(words);
    }
    EXPECT_EQ(recent_worlds_path(), "");
    EXPECT_EQ(user_data_folder("lessons"), "");
    EXPECT_TRUE(falcon_firmware_folder().is_absolute());
    std::filesystem::current_path(before);
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(here.path()))
        left.push_back(entry.path().filename().string());
    EXPECT_THAT(left, testing::UnorderedElementsAre("lessons", "learners", "recordings"));
}

TEST(CommandLine, prints_help_for_every_command_and_its_version) {
    for (const Words& words : {Words{"--help"},
                               {"info", "--help"},
                               {"touch", "-h"},
                               {"scenario", "--help"},
                               {"settings", "--help"},
                               {"--version"}}) {
        std::ostringstream out, err;
        EXPECT_EQ(run_command_line(words, out, err), 0);
        EXPECT_THAT(out.str(), HasSubstr("handrail"));
        EXPECT_EQ(err.str(), "");
    }
}

// In some locales, one and a half is written 1,5. The command line and the files must use the decimal point even in
// such a locale.
TEST(CommandLine, reads_numbers_the_same_way_in_every_locale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no German language setting on this machine";
    EXPECT_EQ(parsed_as<InfoArguments>({"info", "a.map", "--map-scale", "0.5"}).common.map_scale_m_per_unit, 0.5);
    std::setlocale(LC_ALL, before.c_str());
}

TEST(SettingsCommand, explains_every_setting_and_prints_problems_of_the_file) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("mine.toml", "[workspace]\nscale = 30\nscael = 1\n").string();
    std::ostringstream out, err;
    EXPECT_EQ(run_command_line({"settings", "--explain", "--settings", file, "--set", "speech.voice=de"}, out, err), 0);
    EXPECT_THAT(out.str(),
                HasSubstr("workspace.scale = 30.0 world metres per hand metre (1 to 500), from: your settings file " +
                          file + ":2."));
    EXPECT_THAT(
        out.str(),
        HasSubstr("speech.voice = \"de\" (auto, or an espeak-ng voice or language), from: command line --set."));
    EXPECT_THAT(err.str(), StartsWith("mine.toml, line 3"));
    const std::string text = out.str();
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), SettingsStore{}.explain().size());
}

TEST(CommandLine, prints_help_and_errors_in_german_with_unchanged_option_names) {
    const test::InLanguage german("de");
    const auto help = std::get<PrintedText>(parse_command_line({"touch", "--help"})).text;
    for (const char* line : {"Aufruf: handrail touch [OPTIONEN] WORLD", "Angaben:", "--path IN.csv NÖTIG",
                             "Radius der Kugel in Metern der Welt"})
        EXPECT_THAT(help, HasSubstr(line));
    EXPECT_THAT(std::get<PrintedText>(parse_command_line({"--help"})).text, HasSubstr("Befehle:\n  info "));
    const auto refusal = [](const Words& words) { return std::get<UsageError>(parse_command_line(words)).sentence; };
    EXPECT_EQ(refusal({"info"}), "WORLD fehlt. Mehr zeigt dieser Befehl mit --help.");
    EXPECT_EQ(refusal({"bench", "--seconds"}), "--seconds braucht einen Wert: S. Mehr zeigt dieser Befehl mit --help.");
    EXPECT_EQ(refusal({"info", "a.map", "--lint", "--json"}),
              "--json und --lint schließen einander aus. Mehr zeigt dieser Befehl mit --help.");
    EXPECT_EQ(refusal({"info", "x.map", "--jsno"}), "Die Option --jsno gibt es nicht; am nächsten kommt --json.");
}

TEST(CommandLine, opens_a_custom_language_file_once_and_reports_its_errors_once) {
    const test::TemporaryFolder data;
    std::filesystem::create_directories(data.path() / "handrail/languages");
    data.write("handrail/languages/de.toml", "error.nothing = \"nichts\"\n");
    const std::string settings = data.write("mine.toml", "").string();
    const test::WithEnvironment folder("XDG_DATA_HOME", data.path().c_str()), locale("LC_ALL", "de_DE.UTF-8");
    for (const char* language : {"auto", "de"}) {
        const Descriptor watch(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
        ASSERT_GE(::inotify_add_watch(watch.get(), (data.path() / "handrail/languages/de.toml").c_str(),
                                      IN_OPEN | IN_CLOSE_NOWRITE),
                  0);
        std::ostringstream out, err;
        EXPECT_EQ(
            run_command_line({"settings", "--settings", settings, "--set", std::string("speech.language=") + language},
                             out, err),
            0);
        alignas(inotify_event) std::array<char, 4096> opened{};
        EXPECT_EQ(::read(watch.get(), opened.data(), opened.size()), static_cast<ssize_t>(2 * sizeof(inotify_event)))
            << "once, by speech.language=" << language;
        EXPECT_EQ(err.str(),
                  "de.toml, Zeile 1: Warnung: " + phrase("language.unknown_key", {{"key", "error.nothing"}}) + "\n");
    }
    ASSERT_TRUE(speak_language("en"));
}

}  // namespace command_line_test
}  // namespace handrail
