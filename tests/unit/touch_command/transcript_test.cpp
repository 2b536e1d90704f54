// Tests the command that writes transcripts of scenarios. Different events must never give the same text.
#include "app/main/transcript.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "app/main/commands.h"
#include "tests/support/names.h"
#include "tests/support/project_files.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace transcript_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

SessionLog small_log() {
    SessionLog log;
    for (int i = 0; i < 150; ++i) {
        LoggedTick tick;
        tick.time_s = i * 1e-3;
        tick.hip_m = {0.1 * i, 0.0, 1.0};
        log.ticks.push_back(tick);
    }
    const LoggedLine line{0.05, "North wall, plaster"};
    log.lines.push_back(line);
    log.sounds.push_back({0.12, {}, false});
    return log;
}

TEST(Transcript, is_in_chronological_order) {
    const std::string text = transcript(small_log());
    const auto at = [&](const char* words) { return text.find(words); };
    ASSERT_NE(at("0.050 say North wall, plaster\n"), std::string::npos) << text;
    EXPECT_LT(at("0.050 say"), at("0.099 hand"));
    EXPECT_LT(at("0.099 hand"), at("0.120 play"));
    EXPECT_LT(at("0.120 play"), at("0.149 hand"));
    EXPECT_EQ(transcript({}), "");
}

TEST(Transcript, differs_if_anything_differs_in_a_single_bit) {
    const std::string before = transcript(small_log());
    const auto next = [](double& value) { value = std::nextafter(value, 1e9); };
    const std::vector<std::function<void(SessionLog&)>> changes{
        [&](SessionLog& log) { next(log.ticks[17].force_n.y); },
        [&](SessionLog& log) { next(log.ticks[17].hip_m.x); },
        [&](SessionLog& log) { next(log.ticks[17].proxy_m.z); },
        [&](SessionLog& log) { next(log.ticks[17].feet_m.x); },
        [&](SessionLog& log) { next(log.ticks[17].heading_rad); },
        [&](SessionLog& log) { next(log.ticks[17].radius_m); },
        [&](SessionLog& log) { next(log.ticks[17].scale); },
        [&](SessionLog& log) { log.ticks[17].force_n.x = -0.0; },
        [&](SessionLog& log) { log.ticks[17].touched = FeatureId{3}; },
        [&](SessionLog& log) { log.ticks[17].contact = true; },
        [&](SessionLog& log) { log.left_ticks.emplace_back(); },
        [&](SessionLog& log) { log.lines[0].text += "."; },
        [&](SessionLog& log) { next(log.sounds[0].cue.pitch); },
        [&](SessionLog& log) { next(log.sounds[0].cue.position_m.z); },
        [&](SessionLog& log) { log.sounds[0].loop = true; },
        [&](SessionLog& log) { log.ticks.pop_back(); },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        SessionLog changed = small_log();
        changes[i](changed);
        EXPECT_NE(transcript(changed), before) << "change " << i;
    }
}

std::string transcript_of_a_wall(const fs::path& folder) {
    ScenarioArguments arguments;
    arguments.paths = {test::project_root() / "tests" / "scenarios" / "03_first_wall_keyboard.toml"};
    arguments.transcripts = folder;
    std::ostringstream out, err;
    EXPECT_EQ(run_scenarios(arguments, out, err), 0) << out.str() << err.str();
    return content_of(folder / "03_first_wall_keyboard.txt");
}

TEST(Transcript, of_a_scenario_is_written_on_request_and_is_the_same_each_time) {
    const TemporaryFolder folder;
    const std::string once = transcript_of_a_wall(folder.path() / "new" / "once");
    EXPECT_THAT(once, HasSubstr(" say "));
    EXPECT_THAT(once, HasSubstr(" play "));
    EXPECT_EQ(once, transcript_of_a_wall(folder.path() / "twice"));
}

TEST(Transcript, that_cannot_be_written_is_reported_and_fails) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "taken") << "a file";
    ScenarioArguments arguments;
    arguments.paths = {test::project_root() / "tests" / "scenarios" / "03_first_wall_keyboard.toml"};
    arguments.transcripts = folder.path() / "taken";
    std::ostringstream out, err;
    EXPECT_EQ(run_scenarios(arguments, out, err), 1);
    EXPECT_THAT(out.str(), HasSubstr("03_first_wall_keyboard.txt"));
}

}  // namespace transcript_test
}  // namespace handrail::test
