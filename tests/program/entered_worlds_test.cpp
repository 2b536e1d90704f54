// Tests each way in which a person can enter a world: from the command line, from the menu, where a session broke off,
// or in a recording. In each case, the world's settings must apply while the person is in the world. The program must
// also read the world with the requested options.
#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace entered_worlds_test {
namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

ProgramRun run_with(std::vector<std::string> arguments, const std::string& lines = {}, ProgramCall call = {}) {
    call.program = test::built_program("handrail");
    call.arguments = std::move(arguments);
    call.input = lines;
    return run_program(call);
}

// Returns the answers to the scale-bar command, one for each command. Each answer says what length in the world five
// steps are under the hand.
std::vector<std::string> bars_of(const std::string& out) {
    std::vector<std::string> bars;
    for (std::size_t at = 0; (at = out.find("metres are ", at)) != std::string::npos; ++at)
        bars.push_back(out.substr(at + 11, out.find(' ', at + 11) - at - 11));
    return bars;
}

std::string to_world(const std::string& name) { return "menu\nWorlds\n" + name + "\nscale-bar\n"; }

TEST(EnteredWorlds, apply_their_own_settings_on_every_way_in_and_remove_them_on_leaving) {
    const ProgramRun named = run_with({"labyrinth1", "--no-window"},
                                      "scale-bar\n" + to_world("house") + to_world("labyrinth1") + "quit\n"),
                     chosen = run_with({"house", "--no-window"},
                                       "scale-bar\n" + to_world("labyrinth1") + to_world("house") + "quit\n");
    EXPECT_THAT(bars_of(named.out), testing::ElementsAre("43.8", "5.8", "43.8")) << named.out;
    EXPECT_THAT(bars_of(chosen.out), testing::ElementsAre("5.8", "43.8", "5.8")) << chosen.out;
}

TEST(EnteredWorlds, report_errors_in_their_settings_on_entering_and_list_them_in_the_menu) {
    const TemporaryFolder folder;
    const fs::path world = folder.path() / "room.map";
    fs::copy_file(test::bundled_world("first_room.map"), world);
    folder.write("room.settings.toml", "[workspace]\nscale = 20\n[haptic]\nceiling = \"full\"\n");
    const ProgramRun run = run_with({world.string(), "--no-window"},
                                    "scale-bar\nmenu\nproblems in your settings\nlist\nescape\nescape\nquit\n");
    EXPECT_THAT(run.out, HasSubstr("room.settings.toml, line 4, ")) << run.out;
    EXPECT_THAT(bars_of(run.out), testing::ElementsAre("17.5")) << run.out;
}

// The person chooses a named scale, and then types another scale into the list of settings.
TEST(EnteredWorlds, open_at_the_scale_that_was_chosen_last) {
    const ProgramRun run = run_with({"house", "--no-window"},
                                    "detail\nscale-bar\nmenu\nsettings\nworkspace\nscale\n8\nescape\nescape\nescape\n"
                                    "scale-bar\nquit\n");
    EXPECT_THAT(bars_of(run.out), testing::ElementsAre("23.3", "43.8")) << run.out;
}

class BuildingOfSeveral : public testing::Test {
protected:
    ProgramRun explore(std::vector<std::string> more, const std::string& lines, ProgramCall call = {}) const {
        more.insert(more.begin(), {world_.string(), "--no-window", "--device", "none"});
        call.environment["XDG_STATE_HOME"] = folder_.path().string();
        return run_with(std::move(more), lines, std::move(call));
    }

    const TemporaryFolder folder_;
    const fs::path world_ =
        folder_.write("house.osm", content_of(test::project_root() / "tests/unit/osm/worlds/test_house.osm"));
};

TEST_F(BuildingOfSeveral, is_used_again_when_its_recording_is_replayed_or_reported_on) {
    const fs::path recordings = folder_.path() / "recordings";
    const ProgramRun run = explore({"--building", "Annex", "--record-in", recordings.string()},
                                   "forward 2\nheading\nexits\nescape\nwhere\n");
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const std::string recording = fs::directory_iterator(recordings)->path().string();
    const ProgramRun again = run_with({"replay", recording, "--check"});
    EXPECT_EQ(again.exit_status, 0) << again.err;
    const fs::path page = folder_.path() / "page.html";
    const ProgramRun report = run_with({"report", recording, "--html", page.string()});
    EXPECT_EQ(report.exit_status, 0) << report.err;
    EXPECT_THAT(content_of(page), HasSubstr("Annex"));
    EXPECT_THAT(content_of(page), Not(HasSubstr("Test House")));
    const ProgramRun made = run_with({"replay", recording, "--scenario", (folder_.path() / "made.toml").string()});
    EXPECT_EQ(made.exit_status, 0) << made.err << made.out;
    EXPECT_EQ(run_with({"scenario", (folder_.path() / "made.toml").string()}).exit_status, 0);
}

TEST_F(BuildingOfSeveral, is_reopened_after_a_crash) {
    ProgramCall killed;
    killed.close_input = false;
    killed.signal_when_said = SIGKILL;
    killed.signal_after = "acing south";
    // The session saves the walker's place every 3 seconds, so this walk is long enough.
    const ProgramRun first =
        explore({"--building", "Annex"},
                "forward\nback\nforward\nback\nforward\nback\nforward\nback\nright 8\nheading\n", killed);
    EXPECT_EQ(first.exit_status, 128 + SIGKILL) << first.out;
    const ProgramRun second = explore({}, "last-place\nwhere\nquit\n");
    EXPECT_THAT(second.out, HasSubstr("Test House, ")) << second.out;
    EXPECT_THAT(second.out, HasSubstr("Annex, 8 by 6 metres.")) << second.out;
    EXPECT_THAT(second.out, HasSubstr("You are back where you were.")) << second.out;
}

}  // namespace entered_worlds_test
}  // namespace handrail::test
