// Tests what happens if a world's file is changed or deleted while a person is in the world. The program must announce
// it once, and read the file again when the person requests it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/support/child_process.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times_in.h"

namespace handrail::test {
namespace changed_world_test {

using testing::HasSubstr;

void write_house(const std::filesystem::path& file, const std::string& name) {
    std::ofstream(file) << "Building: " << name << ".\nHall, 6 by 5 metres. Door outside in the south wall.\n";
}

TEST(ChangedWorld, is_announced_once_and_can_be_reloaded_from_the_menu) {
    const TemporaryFolder home;
    const std::filesystem::path world = home.path() / "barn.rooms", output = home.path() / "told";
    write_house(world, "Old barn");
    Environment environment = bare_environment(home.path().string());
    environment["XDG_CONFIG_HOME"] = (home.path() / "config").string();
    const auto program = ChildProcess::start(
        {built_program("handrail"), world.string(), "--device", "none", "--no-window", "--set", "speech.through=text"},
        environment, output);
    ASSERT_TRUE(program);
    const auto says = [&](const std::string& words) {
        return eventually([&] { return content_of(output).find(words) != std::string::npos; });
    };
    ASSERT_TRUE(says("Old barn,")) << content_of(output);
    write_house(world, "New and larger barn");
    EXPECT_TRUE(says("barn.rooms has changed since you entered it.")) << content_of(output);
    program->type("where\n");
    program->type("menu\nread this world again\n");
    EXPECT_TRUE(says("New and larger barn,")) << content_of(output);
    std::filesystem::remove(world);
    EXPECT_TRUE(says("barn.rooms no longer exists.")) << content_of(output);
    program->type("quit\n");
    EXPECT_EQ(program->exit_status(), 0);
    EXPECT_EQ(times_in(content_of(output), "has changed since you entered it"), 1U) << content_of(output);
    EXPECT_EQ(times_in(content_of(output), "no longer exists"), 1U);
}

// Earlier, the program accepted a setting with a key that cannot be pressed, and reported nothing. Nobody could then
// reach the command of that key. When the program announced all faults of a file in one sentence, it spoke for a minute
// and a half.
TEST(FaultySettings, report_the_first_with_a_count_and_leave_the_rest_to_the_menu) {
    const TemporaryFolder home;
    std::filesystem::create_directories(home.path() / "handrail");
    std::ofstream(home.path() / "handrail" / "settings.toml")
        << "[keys]\nwhere = \"F99\"\nhome = \"Shift+\"\n[speech]\nrat = 3\n";
    ProgramCall call;
    call.program = built_program("handrail");
    call.arguments = {bundled_world("house.map"), "--no-window", "--device", "none"};
    call.environment["XDG_CONFIG_HOME"] = home.path().string();
    call.input = "menu\nproblems in your settings\n2\nescape\nescape\nquit\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(
        run.out,
        HasSubstr(
            "There are 3 faults in your settings. The menu has the whole list. The first: settings.toml, line 2"));
    EXPECT_THAT(run.out, HasSubstr("F99 is not a valid key for keys.where. Did you mean F9?"));
    EXPECT_THAT(run.out, HasSubstr("line 3")) << "in the list";
}

}  // namespace changed_world_test
}  // namespace handrail::test
