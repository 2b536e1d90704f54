#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace explore_test {

using testing::HasSubstr;

ProgramRun explore(std::vector<std::string> arguments, const std::string& input, ProgramCall call = {}) {
    call.program = test::built_program("handrail");
    call.arguments = std::move(arguments);
    call.input = input;
    return run_program(call);
}

TEST(Explore, without_any_device_gives_the_position_mentions_no_missing_hardware_and_exits_cleanly) {
    ProgramCall call;
    call.voice = true;  // the settings file does not turn the voice off
    const ProgramRun run = explore({}, "", call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("say: "));
    for (const char* missing : {"There is no display", "No touch device", "No sound device", "simulated"})
        EXPECT_THAT(run.out, testing::Not(HasSubstr(missing))) << "it does not matter before it is asked for";
    EXPECT_THAT(run.out, HasSubstr("First room, 6 by 4 metres."));
    EXPECT_THAT(run.out, HasSubstr("facing north"));
}

// Until 2026-11-28, PipeWire printed a line on the terminal in both cases when OpenAL used PipeWire (Debian 13).
TEST(Explore, sound_libraries_print_no_complaints_if_they_find_no_device) {
    for (const char* missing : {"PIPEWIRE_CONFIG_DIR", "SPA_PLUGIN_DIR"}) {
        ProgramCall call;
        call.environment["ALSOFT_DRIVERS"] = "";  // lets OpenAL use its default drivers
        call.environment[missing] = "/nonexistent";
        const ProgramRun run = explore({"--no-window", "--device", "none"}, "quit\n", call);
        EXPECT_EQ(run.exit_status, 0);
        EXPECT_THAT(run.out, HasSubstr("facing north"));
        EXPECT_EQ(run.err, "") << missing;
    }
}

TEST(Explore, also_enters_a_complete_map) {
    for (const auto& world : with_real_worlds({project_root() / "worlds/maps/house.map"}, {"quake-e1m1.map"})) {
        const ProgramRun run = explore({world.string()}, "");
        EXPECT_EQ(run.exit_status, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("facing ")) << world;
    }
}

// Every thread of the program must have a name that `top -H` shows. The first thread has the program's own name, and so
// has a thread that OpenAL starts.
TEST(Explore, all_its_threads_have_names) {
    const TemporaryFolder home;
    const std::filesystem::path out = home.path() / "out";
    const auto child = ChildProcess::start(
        {built_program("handrail"), bundled_world("house.map"), "--no-window", "--device", "sim-t"},
        {{"HOME", home.path().string()}, {"XDG_CACHE_HOME", (home.path() / "cache").string()}}, out);
    ASSERT_TRUE(child);
    std::set<std::string> names;
    int unnamed = 0;
    ASSERT_TRUE(eventually([&] {
        names.clear();
        unnamed = 0;
        std::error_code ec;
        for (std::filesystem::directory_iterator it("/proc/" + std::to_string(child->pid()) + "/task", ec), end;
             !ec && it != end; it.increment(ec)) {
            std::string name;
            std::ifstream(it->path() / "comm") >> name;
            unnamed += name == "handrail" ? 1 : 0;
            names.insert(name);
        }
        return names.contains("servo") && names.contains("ears") && names.contains("lines") && unnamed <= 2;
    })) << unnamed
        << " without a name; " << testing::PrintToString(names);
}

TEST(Explore, commands_from_standard_input_run_in_order) {
    const ProgramRun run =
        explore({"--no-window", "--device", "none"}, "forward 5\nwhere\nright 2\nheading\nwheer\nquit\nforward\n");
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const std::size_t wall = run.out.find("5 steps, then north wall, plaster");
    const std::size_t where = run.out.find("Ahead: north wall, plaster, close by");
    const std::size_t heading = run.out.find("Facing north-east, 45 degrees");
    EXPECT_NE(wall, std::string::npos) << run.out;
    EXPECT_NE(where, std::string::npos) << run.out;
    EXPECT_NE(heading, std::string::npos) << run.out;
    EXPECT_LT(wall, where);
    EXPECT_LT(where, heading);
    EXPECT_THAT(run.out, HasSubstr("Did you mean \"where\"?"));
}

TEST(Explore, a_simulated_hand_moved_by_typed_commands_touches_the_wall) {
    const ProgramRun run = explore({"--no-window"}, "hand-forward 13\nwhat\nquit\n");
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("North wall, plaster"));
}

TEST(Explore, signals_end_the_program_as_cleanly_as_the_quit_command) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        ProgramCall call;
        call.close_input = false;
        call.signal_when_said = number;
        call.signal_after = "facing north";
        const ProgramRun run = explore({"--no-window"}, "", call);
        EXPECT_FALSE(run.timed_out);
        EXPECT_EQ(run.exit_status, 0) << "signal " << number << ": " << run.err;
    }
}

TEST(Explore, an_unreadable_world_gives_one_sentence_and_exit_status_1) {
    const ProgramRun gone = explore({"--no-window", "/nowhere/gone.map"}, "");
    EXPECT_EQ(gone.exit_status, 1);
    EXPECT_THAT(gone.err, HasSubstr("gone.map"));
    EXPECT_EQ(std::count(gone.err.begin(), gone.err.end(), '\n'), 1) << gone.err;
}

TEST(Explore, an_unknown_device_name_gets_the_nearest_suggestion) {
    const ProgramRun run = explore({"--no-window", "--device", "sim-x"}, "");
    EXPECT_NE(run.exit_status, 0);
    EXPECT_THAT(run.err, HasSubstr("sim-"));
}

TEST(Explore, after_a_crash_the_next_start_gives_the_path_of_an_anonymous_report_and_reads_it_out) {
    const TemporaryFolder folder;
    ProgramCall call;
    call.environment["XDG_CONFIG_HOME"] = call.environment["XDG_STATE_HOME"] = folder.path();
    ProgramCall crashing = call;
    crashing.close_input = false;
    crashing.signal_when_said = SIGSEGV;
    crashing.signal_after = "Facing east";
    // Without these options, a sanitizer would report the signal as a fault and end the program with another status.
    // Keep options that are already set, such as suppressions.
    for (const char* options : {"ASAN_OPTIONS", "TSAN_OPTIONS"}) {
        const char* given = std::getenv(options);
        crashing.environment[options] = (given ? std::string(given) + ":" : std::string()) + "handle_segv=0";
    }
    const ProgramRun first = explore({"--no-window", "--set", "workspace.scale=33", "--set", "haptic.device=none"},
                                     "mark\nAnna's corner\nforward 3\nback 3\nforward 3\nright 4\nheading\n", crashing);
    EXPECT_EQ(first.exit_status, 128 + SIGSEGV) << first.out << first.err;
    const ProgramRun second = explore({"--no-window"}, "menu\nReport on the session that crashed\nlist\nquit\n", call);
    EXPECT_THAT(second.out, HasSubstr("Details about the crash are in the menu and in the file "));
    EXPECT_THAT(second.out, HasSubstr("The program ended with an invalid memory access, signal 11."));
    std::vector<std::filesystem::path> reports;
    for (const auto& file : std::filesystem::directory_iterator(folder.path() / "handrail" / "crash-reports"))
        reports.push_back(file.path());
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_THAT(second.out, HasSubstr(reports[0].string()));
    const std::string report = content_of(reports[0]);
    EXPECT_THAT(report, HasSubstr("workspace.scale is 33"));
    EXPECT_THAT(report, HasSubstr("forward"));
    EXPECT_THAT(report, HasSubstr("handrail+0x"));
    for (const char* secret : {"Anna", "corner", "/home", "/tmp", "first_room", "First room"})
        EXPECT_THAT(report, testing::Not(HasSubstr(secret)));
    EXPECT_THAT(explore({"--no-window"}, "quit\n", call).out, testing::Not(HasSubstr("ended unexpectedly")));
}

TEST(Explore, after_a_kill_the_next_start_says_so_and_restores_place_and_settings) {
    char folder[] = "/tmp/handrail-test-killed-XXXXXX";
    ASSERT_TRUE(::mkdtemp(folder));
    ProgramCall call;
    call.environment["XDG_CONFIG_HOME"] = call.environment["XDG_STATE_HOME"] = folder;
    ProgramCall killed = call;
    killed.close_input = false;
    killed.signal_when_said = SIGKILL;
    killed.signal_after = "Facing east";
    // The walk between the changes and the kill takes more than 5 s. The program saves settings after 2 s and the
    // walker's place every 3 s.
    const ProgramRun first =
        explore({"--no-window"}, "frame\nforward 3\nback 3\nforward 3\nback 3\nright 4\nheading\n", killed);
    EXPECT_EQ(first.exit_status, 128 + SIGKILL) << first.out;
    const ProgramRun settings = explore({"settings", "--explain"}, "", call);
    EXPECT_THAT(settings.out, HasSubstr("walk"));
    const ProgramRun second = explore({"--no-window"}, "last-place\nquit\n", call);
    EXPECT_EQ(second.exit_status, 0) << second.err;
    EXPECT_THAT(
        second.out,
        HasSubstr("The last session ended unexpectedly. To go on where you were in First room, type last-place."));
    EXPECT_THAT(second.out, HasSubstr("You are back where you were. "));
    const ProgramRun third = explore({"--no-window"}, "last-place\nquit\n", call);
    EXPECT_THAT(third.out, testing::Not(HasSubstr("The last session ended unexpectedly")));
    EXPECT_THAT(third.out, HasSubstr("No session ended unexpectedly"));
    std::filesystem::remove_all(folder);
}

TEST(Explore, settings_changed_by_a_command_are_saved_at_the_end) {
    char folder[] = "/tmp/handrail-test-settings-XXXXXX";
    ASSERT_TRUE(::mkdtemp(folder));
    ProgramCall call;
    call.environment["XDG_CONFIG_HOME"] = folder;
    const ProgramRun first = explore({"--no-window"}, "frame\nquit\n", call);
    EXPECT_EQ(first.exit_status, 0) << first.err;
    const ProgramRun second = explore({"settings", "--explain"}, "", call);
    EXPECT_THAT(second.out, HasSubstr("walk"));
    std::filesystem::remove_all(folder);
}

}  // namespace explore_test
}  // namespace handrail::test
