// Gives the program unexpected input from a person, a script or a system: pipes in place of files, closed descriptors,
// floods of input, and an immediate end of the input.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/program/endless_world.h"
#include "tests/support/child_process.h"
#include "tests/support/deadly_toml.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

extern "C" char** environ;

namespace handrail::test {
namespace hostile_files_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using SteadyTime = std::chrono::steady_clock;

ProgramRun run(std::vector<std::string> arguments, ProgramCall call = {}) {
    call.program = test::built_program("handrail");
    call.arguments = std::move(arguments);
    return run_program(call);
}

TEST(HostileFiles, pipes_without_a_writer_and_endless_devices_give_one_sentence_each) {
    const TemporaryFolder folder;
    const auto fifo = [&](const std::string& name) {
        const fs::path path = folder.path() / name;
        EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
        return path.string();
    };
    const auto expect_refused = [](const ProgramRun& run, const std::string& name) {
        EXPECT_FALSE(run.timed_out) << name;
        EXPECT_THAT(run.err + run.out, HasSubstr("not an ordinary file")) << name;
        EXPECT_THAT(run.err + run.out, HasSubstr(name));
    };
    expect_refused(run({"info", fifo("world.map")}), "world.map");
    expect_refused(run({"--no-window", "--device", "none", fifo("other.map")}), "other.map");
    expect_refused(run({"info", "/dev/zero"}), "zero");
    // The program refuses a pipe before opening it, so it does not wait for a writer.
    EXPECT_FALSE(run({"scenario", fifo("scenario.toml")}).timed_out);
    fs::create_directories(folder.path() / "handrail");
    fifo("handrail/settings.toml");
    ProgramCall call;
    call.environment["XDG_CONFIG_HOME"] = folder.path();
    expect_refused(run({"settings", "--explain"}, call), "settings.toml");
    // Put pipes in place of a picture next to a world, and of the cache next to the world.
    std::ifstream in(test::bundled_world("first_room.map"));
    std::string map{std::istreambuf_iterator<char>(in), {}};
    const std::size_t at = map.find("\"classname\" \"worldspawn\"");
    ASSERT_NE(at, std::string::npos);
    map.insert(at, "\"texture_picture\" \"picture.png\"\n\"texture_size\" \"64\"\n");
    folder.write("room.map", map);
    fifo("picture.png");
    expect_refused(run({"info", (folder.path() / "room.map").string()}), "picture.png");
}

// If a standard descriptor is closed, the first file that the program opens would get the number of that descriptor.
// The program would then print into that file.
TEST(HostileFiles, closed_descriptors_are_reopened_before_anything_else) {
    const TemporaryFolder home;
    std::array<int, 2> input{-1, -1};
    ASSERT_EQ(::pipe2(input.data(), O_CLOEXEC), 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input[0], 0);
    posix_spawn_file_actions_addclose(&actions, 1);
    posix_spawn_file_actions_addclose(&actions, 2);
    std::string program = test::built_program("handrail"), no_window = "--no-window", device = "--device",
                none = "none";
    std::array<char*, 5> argv{program.data(), no_window.data(), device.data(), none.data(), nullptr};
    std::vector<std::string> variables;
    for (const auto& [name, value] : bare_environment(home.path()))
        if (!value.empty()) variables.push_back(name + "=" + value);
    // Without these options, the sanitizers would report faults of foreign libraries.
    for (const std::string sanitizer : {"LSAN_OPTIONS", "TSAN_OPTIONS"})
        if (const char* options = std::getenv(sanitizer.c_str())) variables.push_back(sanitizer + "=" + options);
    std::vector<char*> envp;
    for (std::string& variable : variables) envp.push_back(variable.data());
    envp.push_back(nullptr);
    pid_t child = -1;
    ASSERT_EQ(::posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), envp.data()), 0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(input[0]);
    const auto target = [&](int number) {
        std::error_code ec;
        return fs::read_symlink("/proc/" + std::to_string(child) + "/fd/" + std::to_string(number), ec).string();
    };
    EXPECT_TRUE(eventually([&] { return target(1) == "/dev/null" && target(2) == "/dev/null"; }));
    ::close(input[1]);
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

// An attacker who prepared the folder of a world may have put these files there. Each of them crashes its parser.
TEST(HostileFiles, hostile_toml_next_to_a_world_ends_only_its_reader_process) {
    const TemporaryFolder folder;
    const fs::path world = folder.path() / "room.map";
    fs::copy_file(test::bundled_world("first_room.map"), world);
    const std::vector<std::string> names{"room.map.handrail.toml", "room.settings.toml", "a.lesson.toml"};
    for (const std::string& name : names) folder.write(name, test::deadly_toml());
    ProgramCall call;
    call.input = "where-am-i\n";
    const ProgramRun left = run({"--no-window", "--device", "none", world.string()}, call);
    EXPECT_EQ(left.exit_status, 0) << left.err;
    EXPECT_THAT(left.out, HasSubstr("It remains in room.map.handrail.toml"));
    EXPECT_THAT(left.out + left.err, HasSubstr("room.settings.toml: error: The process for reading this file failed."));
    const ProgramRun lesson = run({"lesson", "--check", (folder.path() / "a.lesson.toml").string()});
    EXPECT_EQ(lesson.exit_status, 2) << lesson.out;
    EXPECT_THAT(lesson.err, HasSubstr("a.lesson.toml: The process for reading this file failed."));
    for (const std::string& name : names) EXPECT_EQ(content_of(folder.path() / name), deadly_toml()) << name;
}

// The reader process of this test reads nothing. So a scenario can only run if the program reads the world without that
// process, which it must not.
TEST(HostileFiles, worlds_of_scenarios_are_read_in_the_reader_process) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "bin");
    fs::copy_file(test::built_program("handrail"), folder.path() / "bin" / "handrail");
    fs::permissions(folder.write("bin/handrail-reader", "#!/bin/sh\nexit 1\n"), fs::perms::owner_all);
    ProgramCall call;
    call.program = (folder.path() / "bin" / "handrail").string();
    call.arguments = {"scenario", (test::project_root() / "tests/scenarios/first_contact.toml").string()};
    call.environment["HANDRAIL_WORLDS"] = (test::project_root() / "worlds/maps").string();
    const ProgramRun played = run_program(call);
    EXPECT_EQ(played.exit_status, 1) << played.out;
    EXPECT_THAT(played.out + played.err, HasSubstr("Reading this file failed"));
}

TEST(HostileFiles, loading_stops_as_soon_as_a_signal_requests_it) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("endless.obj", endless_obj());
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        ProgramCall call;
        call.close_input = false;
        call.signal_when_said = number;
        call.signal_after = "Handrail.";
        const ProgramRun left = run({"--no-window", "--device", "none", world.string()}, call);
        EXPECT_FALSE(left.timed_out) << number;
        EXPECT_EQ(left.exit_status, 0) << number << ": " << left.err;
    }
}

}  // namespace hostile_files_test
}  // namespace handrail::test
