// Every scenario with a voice of 180 words a minute, and ten of them with a slow and a fast one: judged 15 s after the
// last key, what still holds was heard, and no warning was cut.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/core/scenario/scenario_run.h"
#include "app/core/session/headless_session.h"
#include "tests/support/project_root.h"
#include "tests/unit/heard/heard.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace heard_scenarios_test {

using ::testing::IsEmpty;

const std::filesystem::path kScenarios = test::project_root() / "tests" / "scenarios";

std::vector<std::string> all_scenarios() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kScenarios))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

// Stop keys silence warnings too.
bool stops(const Scenario& scenario) {
    return std::any_of(scenario.actions.begin(), scenario.actions.end(), [](const ScenarioAction& action) {
        const auto* tap = std::get_if<TapCommand>(&action.step);
        return tap && (tap->command == Command::StopSpeech || tap->command == Command::StopEverything);
    });
}

void hear(const std::string& name, double words_per_minute) {
    auto scenario =
        read_scenario(kScenarios / (name + ".toml"), {test::project_root() / "worlds" / "maps", kScenarios / "worlds"});
    ASSERT_TRUE(scenario) << scenario.error().sentence();
    scenario->tail_s = 15.0;
    auto world = read_requested(scenario->world);
    ASSERT_TRUE(world) << world.error().sentence();
    RecordingAudio audio;
    RecordingSpeech voice{words_per_minute};
    double now_s = 0.0;
    bool leads = false;
    const auto log = run_scenario(*scenario, std::make_shared<const Scene>(std::move(*world)), audio, voice,
                                  {read_requested}, [&](HeadlessSession& session) {
                                      now_s = session.now_s();
                                      leads = session.app().guide().leads();
                                  });
    ASSERT_TRUE(log) << log.error().sentence();
    EXPECT_THAT(test::unheard(voice, {SpeechTopic::Place, SpeechTopic::Lesson}, now_s), IsEmpty())
        << name << ", " << words_per_minute << " words a minute";
    if (leads) {
        EXPECT_THAT(test::unheard(voice, {SpeechTopic::Summary, SpeechTopic::Leg}, now_s), IsEmpty())
            << name << ", " << words_per_minute << " words a minute";
    }
    if (!stops(*scenario)) {
        EXPECT_THAT(test::cut_warnings(voice), IsEmpty()) << name << ", " << words_per_minute << " words a minute";
    }
}

class HeardScenario : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, HeardScenario, ::testing::ValuesIn(all_scenarios()),
                         [](const auto& row) { return "of_" + row.param; });

TEST_P(HeardScenario, leaves_nothing_unheard_that_still_holds) { hear(GetParam(), 180.0); }

class HeardAtOtherRates : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Ten, HeardAtOtherRates,
                         ::testing::Values("03_first_wall_keyboard", "04_perimeter_lap_keyboard",
                                           "08_stairs_and_a_drop", "14_way_to_another_room_keyboard",
                                           "14_following_by_ear", "15_where_am_i_and_look", "16_rooms_and_exits",
                                           "first_contact", "first_minutes_keyboard", "kept_way"),
                         [](const auto& row) { return "of_" + row.param; });

TEST_P(HeardAtOtherRates, leaves_nothing_unheard_that_still_holds) {
    for (const double words_per_minute : {120.0, 350.0}) hear(GetParam(), words_per_minute);
}

}  // namespace heard_scenarios_test
}  // namespace handrail
