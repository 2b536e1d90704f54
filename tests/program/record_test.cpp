// Tests recordings that the program makes of its own sessions.
#include <random>
#include <regex>

#include "app/core/dialogue/command.h"
#include "app/record/compute_again.h"
#include "app/record/recording.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace record_test {

using testing::HasSubstr;

std::vector<std::filesystem::path> folders_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    std::error_code ec;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ec)) found.push_back(entry.path());
    return found;
}

// Returns the call of a recorded session in the bundled house with a simulated device. The program writes the recording
// below `folder`.
ProgramCall recorded_in(const std::filesystem::path& folder) {
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {
        test::bundled_world("house.map"), "--no-window", "--device", "sim-t", "--record-in", folder.string()};
    return call;
}

TEST(RecordedSession, contains_every_spoken_line_in_order) {
    const TemporaryFolder folder;
    ProgramCall call = recorded_in(folder.path());
    call.input = "forward 3\nwhere\nexits\nescape\nverbosity\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("This session is being recorded."));
    const auto folders = folders_in(folder.path());
    ASSERT_EQ(folders.size(), 1U);
    const auto read = read_recording(folders[0]);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(read->problems.empty());
    EXPECT_TRUE(read->ended);
    EXPECT_GT(read->hands[0].size(), 300U);
    EXPECT_GT(read->frames.size(), 20U);
    std::string said;
    for (const SaidLine& line : said_lines(*read))
        said += (line.speech_class == "alarm" ? "alert: " : "say: ") + line.text + "\n";
    EXPECT_EQ(said, run.out);
}

// Input of a person in a hurry: commands, lists, typed text, a change of world, and settings.
constexpr const char* kBusy[] = {
    "forward 3\nwhere\nexits\nescape\nverbosity\nfind\nkitchen\nexits\n1\nscale-up\nscale-down\nwhat\nahead\n",
    "menu\nWorlds\nhouse\nforward 9\nright 4\nforward 5\naround\nmark\nmy \"first\" mark\nmarks\nescape\nmenu\n2\n"
    "escape\nforward 4\nbackward 2\nwhere\nrepeat\n",
    "hand-left\nfind\nstairs\ntake-me\nleft 3\nforward 12\nname-room\nMy "
    "hall\nwhere\nlost\n"
    "desk\nescape\nhelp\nescape\n",
    // The person has a device in each hand.
    "forward 3\nwhat\nhand-forward 8\nhand-left 12\nscale-down\nroom\nframe\nhand-right 20\nwhere\nfind\nkitchen\n"
    "take-me\nforward 4\nright 3\nforces\nforces\nhand-back 6\ndetail\nhand-left 9\nexits\nescape\n",
    // The device is disconnected during a walk, connected again, and disconnected again.
    "forward 3\nwhere\nexits\nescape\nforward 6\nleft 2\nfind\nkitchen\nforward 4\nforces\nwhat\nbackward 9\n"
    "around\nforward 9\nwhere\nforces\nforward 5\nahead\nbackward 5\nmark\nmine\n",
    // The person has a device in each hand, among movable bodies. The person pushes bodies, grabs them by hand and by
    // keys, releases them and puts them back. Then the person enters a labyrinth, in which a ball rolls.
    "hand-forward 3\nuse\nhand-back 2\nhand-up\nuse\nforward 3\nuse\nforward\nleft\nuse\nput-back\nmenu\nWorlds\n"
    "labyrinth\nhand-forward 2\nuse\nright\nforward\nuse\nput-back\nwhere\n",
};
constexpr int kTwoHands = 3, kPulledOut = 4, kFreeBodies = 5;

// Returns a hall with a crate, a ball and an object that is too heavy to push.
std::string hall_of_things() {
    const auto thing = [](const char* kind, const char* name, const char* kg, const std::string& brush) {
        return entity("thing", key("cs_name", kind) + key("name", name) + key("mass", kg), brush);
    };
    return entity("worldspawn", key("message", "Hall") + key("building", "1"), room_brushes(0, 0, 0, 256, 256, 128)) +
           entity("info_player_start", key("origin", "128 32 24") + key("angle", "90")) +
           thing("dynamic_box", "Crate", "2", box_brush(96, 80, 0, 160, 96, 48)) +
           thing("dynamic_sphere", "Ball", "1", box_brush(90, 60, 0, 102, 72, 12)) +
           thing("dynamic_box", "Anvil", "60", box_brush(160, 40, 0, 176, 56, 16));
}

class RecordedUnderLoad : public testing::TestWithParam<int> {};

TEST_P(RecordedUnderLoad, replays_to_the_same_lines_in_the_same_order) {
    const TemporaryFolder folder;
    ProgramCall call = recorded_in(folder.path());
    if (GetParam() == 1) call.arguments[0] = test::bundled_world("school.map");
    const TemporaryFolder worlds;
    const bool free = GetParam() == kFreeBodies;
    if (free) call.arguments[0] = worlds.write("hall.map", hall_of_things()).string();
    const bool two_hands = GetParam() == kTwoHands || free;
    if (two_hands) call.arguments.insert(call.arguments.end(), {"--device", "sim-f"});
    const TemporaryFolder library;
    if (GetParam() == kPulledOut) {
        std::filesystem::create_symlink(test::built_standin("standin_hd"), library.path() / "libHD.so");
        call.arguments[3] = "omni";
        call.environment["LD_LIBRARY_PATH"] = library.path().string();
        call.environment["HANDRAIL_STANDIN_GOES_AFTER"] = "4000";
    }
    call.input = kBusy[GetParam()];
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const auto folders = folders_in(folder.path());
    ASSERT_EQ(folders.size(), 1U);
    const auto read = read_recording(folders[0]);
    ASSERT_TRUE(read) << read.error().sentence();
    const auto again = compute_again(*read, {read_requested});
    ASSERT_TRUE(again) << again.error().sentence();
    for (const std::string& remark : again->remarks) ADD_FAILURE() << remark;
    const auto difference = first_difference(*read, *again);
    EXPECT_FALSE(difference) << difference->line << "\n" << difference->recorded << "\n" << difference->computed;
    EXPECT_GT(again->said.size(), 12U) << run.out;
    EXPECT_EQ(again->other_forces, 0U) << "of " << again->ticks;
    EXPECT_EQ(read->hands[1].size() > 300U, two_hands);
    std::size_t pushes = 0;
    for (const EngineRow& row : read->bodies) pushes += row.pushes[0] + row.pushes[1];
    EXPECT_EQ(pushes > 0, free) << pushes;
    EXPECT_EQ(!read->bodies.empty() && read->bodies.back().engine == 2, free) << "the labyrinth has an engine too";
    EXPECT_EQ(run.out.find("unplugged") != std::string::npos, GetParam() == kPulledOut) << run.out;
}

INSTANTIATE_TEST_SUITE_P(Sessions, RecordedUnderLoad, testing::Range(0, 6));

TEST(RecordedSession, becomes_a_scenario_that_passes) {
    const TemporaryFolder folder;
    ProgramCall call = recorded_in(folder.path());
    call.input = "where\nforward 2\nright\nheading\nexits\nescape\n";
    EXPECT_EQ(run_program(call).exit_status, 0);
    const std::string recording = folders_in(folder.path()).at(0).string();
    const std::string scenario = (folder.path() / "made.toml").string();
    call.input.clear();
    call.arguments = {"replay", recording, "--scenario", scenario, "--csv", (folder.path() / "tables").string()};
    EXPECT_EQ(run_program(call).exit_status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "tables/hand.csv"));
    call.arguments = {"scenario", scenario};
    const ProgramRun played = run_program(call);
    EXPECT_EQ(played.exit_status, 0) << played.out << content_of(scenario);
    EXPECT_THAT(content_of(scenario), HasSubstr("press = \"exits\""));
}

// Returns random input, as from a person who does not know what can be typed: commands, numbers, names, and keys by
// their names.
std::string typed_by_chance(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    constexpr std::array kWords{"1",    "2",       "17",     "enter", "escape",   "down", "up",
                                "list", "kitchen", "stairs", "hall",  "my first", "nan",  "yes"};
    std::string lines;
    for (int i = 0; i < scaled(60); ++i) {
        const CommandInfo& command = command_table()[below(command_table().size())];
        // Leave these two commands out: Leave ends the session, and Calibrate waits for minutes.
        const bool ends = command.command == Command::Leave || command.command == Command::Calibrate;
        if (below(3) > 0 && !ends) lines += std::string(command.word) + (below(4) == 0 ? " 3" : "");
        else lines += kWords[below(kWords.size())];
        lines += "\n";
    }
    return lines;
}

class RecordedByChance : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RecordedByChance, becomes_a_scenario_that_passes_unchanged) {
    const TemporaryFolder folder;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {test::bundled_world(GetParam() % 2 == 0 ? "house.map" : "school.map"), "--no-window",
                      "--record-in", folder.path().string()};
    call.input = typed_by_chance(GetParam());
    SCOPED_TRACE(call.input);
    EXPECT_EQ(run_program(call).exit_status, 0);
    const std::string recording = folders_in(folder.path()).at(0).string();
    const std::string scenario = (folder.path() / "made.toml").string();
    ProgramCall replay;
    replay.program = call.program;
    replay.arguments = {"replay", recording, "--scenario", scenario};
    const ProgramRun made = run_program(replay);
    ASSERT_EQ(made.exit_status, 0) << made.err;
    // The scenario made from the recording must expect most of the recorded answers.
    std::smatch reported;
    if (std::regex_search(made.out, reported, std::regex("not expected: ([0-9]+) of ([0-9]+)\\."))) {
        EXPECT_LE(3 * std::stoi(reported[1]), std::stoi(reported[2])) << made.out;
    }
    replay.arguments = {"scenario", scenario};
    const ProgramRun played = run_program(replay);
    EXPECT_EQ(played.exit_status, 0) << played.out << content_of(scenario);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RecordedByChance, testing::Range(1U, 7U));

TEST(ReplayCommand, checks_a_recording_plays_it_and_reports_differences) {
    const TemporaryFolder folder;
    ProgramCall call = recorded_in(folder.path());
    call.input = "where\nforward 2\n";
    EXPECT_EQ(run_program(call).exit_status, 0);
    const std::filesystem::path recording = folders_in(folder.path()).at(0);
    call.input.clear();
    call.arguments = {"replay", recording.string(), "--check"};
    const ProgramRun same = run_program(call);
    EXPECT_EQ(same.exit_status, 0) << same.err;
    EXPECT_THAT(same.out, HasSubstr("said again as recorded, in the same order."));
    call.arguments = {"replay", recording.string(), "--speed", "4"};
    const ProgramRun heard = run_program(call);
    EXPECT_EQ(heard.exit_status, 0);
    // If another announcement replaces a line before the line is spoken, the program only writes the line, so the
    // replay omits it. On a busy machine, this happens to the first answer.
    const auto read = read_recording(recording);
    ASSERT_TRUE(read) << read.error().sentence();
    std::size_t at = 0;
    int voiced = 0;
    for (const SaidLine& line : said_lines(*read)) {
        if (!line.voiced) continue;
        ++voiced;
        at = heard.out.find("say: " + line.text + "\n", at);
        ASSERT_NE(at, std::string::npos) << line.text << "\n" << heard.out;
    }
    EXPECT_GE(voiced, 2);
    // Replace the recorded command "where" by another command.
    std::string events = content_of(recording / "events.jsonl");
    const std::size_t where = events.find("\"command\":\"where\"");
    ASSERT_NE(where, std::string::npos);
    events.replace(where, 17, "\"command\":\"ahead\"");
    std::filesystem::copy(folder.write("events.jsonl", events), recording / "events.jsonl",
                          std::filesystem::copy_options::overwrite_existing);
    call.arguments = {"replay", recording.string(), "--check"};
    const ProgramRun other = run_program(call);
    EXPECT_EQ(other.exit_status, 1);
    EXPECT_THAT(other.err, HasSubstr("differs. Recorded by version"));
    folder.write("events.jsonl", "x\n");
    call.arguments = {"replay", folder.path().string()};
    EXPECT_THAT(run_program(call).err, HasSubstr("A recording begins with a line that says what it is."));
    call.arguments = {"replay", "--speed", "9"};
    EXPECT_EQ(run_program(call).exit_status, 2);
}

TEST(ReportCommand, makes_a_page_and_tables_of_a_recording_and_replaces_nothing_without_a_request) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "RecordedUnderLoad.* runs the same threads";
    const TemporaryFolder folder;
    ProgramCall call = recorded_in(folder.path());
    // The answer to "routes" waits until the program knows the rooms.
    call.input = "routes\nkitchen\nwhere\nleft 4\nforward 6\nexits\n";
    EXPECT_EQ(run_program(call).exit_status, 0);
    const std::string recording = folders_in(folder.path()).at(0).string();
    call.input.clear();
    const std::string page = (folder.path() / "page.html").string(), table = (folder.path() / "table.csv").string(),
                      json = (folder.path() / "values.json").string();
    call.arguments = {"report", recording, "--html", page, "--csv", table, "--json", json, "--learner", "Kim"};
    const ProgramRun made = run_program(call);
    EXPECT_EQ(made.exit_status, 0) << made.err;
    const std::string html = content_of(page);
    EXPECT_THAT(html, testing::StartsWith("<!DOCTYPE html>\n<html lang=\"en\">"));
    EXPECT_THAT(html, HasSubstr("Kim"));
    EXPECT_THAT(html, HasSubstr("<svg"));
    // The report's course of the session contains the announcements. The first announcements are missing if early input
    // interrupts them.
    EXPECT_THAT(html, HasSubstr("Hall, at the base, by the door, facing north."));
    EXPECT_THAT(content_of(table),
                testing::AllOf(HasSubstr(",time,"), HasSubstr(",contacts_hand,"), testing::Not(HasSubstr("Kim"))));
    EXPECT_TRUE(std::filesystem::exists(table + "-metadata.json"));
    EXPECT_THAT(content_of(json), HasSubstr("pauses"));
    const ProgramRun again = run_program(call);
    EXPECT_EQ(again.exit_status, 1);
    EXPECT_THAT(again.err, HasSubstr("page.html"));
    call.arguments.push_back("--force");
    EXPECT_EQ(run_program(call).exit_status, 0);
    call.arguments = {"report", recording};
    EXPECT_EQ(run_program(call).exit_status, 2);
    call.arguments = {"report", (folder.path() / "nowhere").string(), "--html", page, "--force"};
    EXPECT_EQ(run_program(call).exit_status, 1);
    EXPECT_EQ(content_of(page), html) << "a report that fails touches nothing";
}

TEST(RecordedSession, exists_only_on_request) {
    const TemporaryFolder home;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {test::bundled_world("house.map"), "--no-window", "--device", "none"};
    call.input = "where\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, testing::Not(HasSubstr("recorded")));
}

TEST(RecordedSession, that_fails_to_record_is_reported_and_continues) {
    const TemporaryFolder folder;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {test::bundled_world("house.map"),  "--no-window", "--device", "none", "--record-in",
                      folder.write("file", "x").string()};
    call.input = "where\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Nothing is recorded."));
    EXPECT_THAT(run.out, HasSubstr("At the base, by the door"));
}

}  // namespace record_test
}  // namespace handrail::test
