// Tests in virtual time how commands report long work. Short work must not be reported. During longer work, a waiting
// person must get a sentence every few seconds. Every command must report what it is doing.
#include "app/main/long_work.h"

#include <gmock/gmock.h>

#include <functional>
#include <sstream>

#include "app/main/commands.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/language.h"
#include "worlds/base/patience.h"

namespace handrail {
namespace long_work_test {
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kWorlds = (test::project_root() / "worlds/maps/").string();

struct Announced {
    double at_s;
    std::string words;
    bool operator==(const Announced&) const = default;
};
void PrintTo(const Announced& announced, std::ostream* os) { *os << announced.at_s << " s: " << announced.words; }

// Returns the sentences between `from_s` and `to_s` if the caller checks for news four times a second.
std::vector<Announced> announced_from(const LongWork& progress, double from_s, double to_s) {
    std::vector<Announced> all;
    for (double now_s = from_s; now_s < to_s; now_s += 0.25)
        progress.report(now_s, [&](const std::string& words) { all.push_back({now_s, words}); });
    return all;
}

TEST(Patience, ends_after_two_seconds_and_then_every_five) {
    Patience patience(10.0);
    std::vector<double> due;
    for (double now_s = 10.0; now_s < 30.0; now_s += 0.25)
        if (patience.due(now_s)) due.push_back(now_s - 10.0);
    EXPECT_THAT(due, ElementsAre(2.0, 7.0, 12.0, 17.0));
}

TEST(LongWork, that_ends_within_two_seconds_is_not_reported) {
    const LongWork progress = LongWork::begun();
    EXPECT_THAT(announced_from(progress, 0.0, 10.0), IsEmpty()) << "there is no work";
    progress.at("Finding rooms and routes");
    EXPECT_THAT(announced_from(progress, 10.0, 12.0), IsEmpty());
    progress.done();
    EXPECT_THAT(announced_from(progress, 12.0, 20.0), IsEmpty());
    progress.at("Drawing the storey");
    EXPECT_THAT(announced_from(progress, 20.0, 22.0), IsEmpty()) << "two seconds anew";
}

TEST(LongWork, that_takes_longer_is_reported_with_the_elapsed_time) {
    const LongWork progress = LongWork::begun();
    progress.at("Finding rooms and routes");
    EXPECT_THAT(announced_from(progress, 100.0, 103.0),
                ElementsAre(Announced{102.0, "Finding rooms and routes, 2 seconds so far."}));
    progress.at("Looking for problems to fix");
    EXPECT_THAT(announced_from(progress, 103.0, 113.0),
                ElementsAre(Announced{107.0, "Looking for problems to fix, 7 seconds so far."},
                            Announced{112.0, "Looking for problems to fix, 12 seconds so far."}));
}

TEST(LongWork, reports_the_share_of_the_file_that_was_read_and_the_current_stage) {
    const LongWork progress = LongWork::begun();
    const ReadOptions options = progress.followed({});
    options.progress(0.4);
    EXPECT_THAT(announced_from(progress, 0.0, 3.0), ElementsAre(Announced{2.0, "Loading, 40 percent."}));
    options.stage("import.shapes");
    options.progress(0.555);
    EXPECT_THAT(announced_from(progress, 3.0, 8.0),
                ElementsAre(Announced{7.0, "Loading, 55 percent: building walls, floors and openings."}));
    const test::InLanguage german("de");
    options.stage("import.touch");
    EXPECT_THAT(announced_from(progress, 8.0, 13.0),
                ElementsAre(Announced{12.0, "Laden, 55 Prozent: " + phrase("import.touch") + "."}));
}

TEST(LongWork, costs_nothing_without_an_observer) {
    const LongWork nobody;
    EXPECT_FALSE(nobody.followed({}).progress);
    nobody.at("Anything");
    EXPECT_THAT(announced_from(nobody, 0.0, 10.0), IsEmpty());
}

// Returns the stages that a command reports, in order. The command must report the last stage before it writes its
// output.
std::vector<std::string> stages(const std::function<int(std::ostream&, std::ostream&, const LongWork&)>& command) {
    std::ostringstream out, err;
    std::vector<std::string> all;
    const LongWork progress = LongWork::begun([&](const std::string& what) {
        all.push_back(what);
        EXPECT_EQ(out.str(), "") << what;
    });
    EXPECT_LE(command(out, err, progress), 1) << "1 is for faults of the world";
    EXPECT_EQ(err.str(), "");
    EXPECT_FALSE(all.empty() && out.str().empty());
    EXPECT_THAT(announced_from(progress, 0.0, 10.0), IsEmpty()) << "it is over";
    return all;
}

TEST(CommandWork, of_info_and_check_reports_each_stage_but_none_with_json) {
    const auto info = [](bool json, bool words) {
        return stages([json, words](std::ostream& out, std::ostream& err, const LongWork& progress) {
            InfoArguments arguments;
            arguments.world = kWorlds + "first_room.map";
            arguments.json = json;
            arguments.as_words = words;
            return run_info(arguments, out, err, progress);
        });
    };
    EXPECT_THAT(info(false, false),
                ElementsAre("reading the file", "Preparing the world for touch", "Finding rooms and routes", ""));
    EXPECT_THAT(info(false, true), ElementsAre("reading the file", "Finding rooms and routes", ""));
    EXPECT_THAT(info(true, false), IsEmpty());
    const auto check = [](bool json) {
        return stages([json](std::ostream& out, std::ostream& err, const LongWork& progress) {
            CheckArguments arguments;
            arguments.world = kWorlds + "first_room.map";
            arguments.json = json;
            return run_check(arguments, out, err, progress);
        });
    };
    EXPECT_THAT(check(false),
                ElementsAre("reading the file", "Finding rooms and routes", "Looking for problems to fix", ""));
    EXPECT_THAT(check(true), IsEmpty());
}

TEST(CommandWork, of_export_and_scenario_reports_each_stage) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(stages([&](std::ostream& out, std::ostream& err, const LongWork& progress) {
                    ExportArguments arguments;
                    arguments.world = kWorlds + "first_room.map";
                    arguments.swell = folder.path() / "plan.svg";
                    return run_export(arguments, out, err, progress);
                }),
                ElementsAre("reading the file", "Finding rooms and routes", "Drawing the storey", ""));
    EXPECT_THAT(stages([&](std::ostream& out, std::ostream& err, const LongWork& progress) {
                    ScenarioArguments arguments;
                    arguments.paths = {(test::project_root() / "tests/scenarios/03_first_wall_keyboard.toml").string()};
                    return run_scenarios(arguments, out, err, progress);
                }),
                Contains(HasSubstr("Playing ")));
}

TEST(CommandWork, ends_before_a_problem_is_reported) {
    const test::TemporaryFolder folder;
    std::ostringstream out, err;
    std::vector<std::string> all;
    const LongWork progress = LongWork::begun([&](const std::string& what) {
        all.push_back(what);
        EXPECT_EQ(err.str(), "") << what;
    });
    InfoArguments info;
    info.world = folder.path() / "none.map";
    EXPECT_EQ(run_info(info, out, err, progress), 1);
    EXPECT_EQ(all.back(), "");
    ReplayArguments replay;
    replay.folder = folder.path() / "none";
    replay.check = true;
    err.str("");
    EXPECT_EQ(run_replay(replay, {}, out, err, progress), 1);
    EXPECT_THAT(all, Contains("Reading the recording"));
    EXPECT_EQ(all.back(), "");
}

// The thread that writes to a terminal runs in real time. Therefore this tests only that the thread ends immediately,
// with or without work.
TEST(LongWorkLines, stop_at_once_with_and_without_work) {
    std::ostringstream to;
    const LongWork progress = LongWork::begun();
    { const LongWorkLines idle(progress, to); }
    progress.at("Anything");
    { const LongWorkLines busy(progress, to); }
    { const LongWorkLines nobody({}, to); }
    EXPECT_EQ(to.str(), "");
}

}  // namespace long_work_test
}  // namespace handrail
