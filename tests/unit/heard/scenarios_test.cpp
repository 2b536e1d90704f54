// Runs every scenario with a voice of 180 words a minute, and ten of them also with a slow and a fast voice. By 15 s
// after the last key, the person must have heard everything that is still valid, and nothing may have cut a warning.
// Also mixes the sounds of every scenario, and no mix may be too loud.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/core/scenario/scenario_run.h"
#include "app/core/session/headless_session.h"
#include "tests/support/loudness_meter.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/unit/heard/heard.h"
#include "tests/unit/heard/sounding.h"
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

// Returns whether the scenario presses a key that stops speech. Such a key also silences warnings.
bool stops(const Scenario& scenario) {
    return std::any_of(scenario.actions.begin(), scenario.actions.end(), [](const ScenarioAction& action) {
        const auto* tap = std::get_if<TapCommand>(&action.step);
        return tap && (tap->command == Command::StopSpeech || tap->command == Command::StopEverything);
    });
}

Scenario read(const std::string& name) {
    auto scenario =
        read_scenario(kScenarios / (name + ".toml"), {test::project_root() / "worlds" / "maps", kScenarios / "worlds"});
    if (!scenario) throw std::runtime_error(scenario.error().sentence());
    return std::move(*scenario);
}

void hear(const std::string& name, double words_per_minute) {
    Scenario scenario = read(name);
    scenario.tail_s = test::kAfterLastKey_s * 180.0 / words_per_minute;  // a slow voice needs longer for the same lines
    auto world = read_requested(scenario.world);
    ASSERT_TRUE(world) << world.error().sentence();
    RecordingAudio audio;
    RecordingSpeech voice{words_per_minute};
    bool leads = false;
    const auto log =
        run_scenario(scenario, std::make_shared<const Scene>(std::move(*world)), audio, voice, {read_requested},
                     [&](HeadlessSession& session) { leads = session.app().guide().leads(); });
    ASSERT_TRUE(log) << log.error().sentence();
    const std::string how = fmt::format("{}, {} words a minute:\n{}", name, words_per_minute, test::said_by(voice));
    // A person who presses a stop key does not want to hear the lines.
    if (stops(scenario)) return;
    EXPECT_THAT(test::unheard(voice, {SpeechTopic::Place, SpeechTopic::Arrival}), IsEmpty()) << how;
    // If the first minutes have reached their last step, these lines are no longer valid.
    if (how.find("What to do next") == std::string::npos) {
        EXPECT_THAT(test::unheard(voice, {SpeechTopic::Praise, SpeechTopic::Lesson}), IsEmpty()) << how;
    }
    if (leads) {
        EXPECT_THAT(test::unheard(voice, {SpeechTopic::Summary, SpeechTopic::Leg}), IsEmpty()) << how;
    }
    EXPECT_THAT(test::cut_warnings(voice), IsEmpty()) << how;
}

class HeardScenario : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, HeardScenario, ::testing::ValuesIn(all_scenarios()),
                         [](const auto& row) { return "of_" + row.param; });

// Under the sanitizers, no other test runs every scenario.
TEST_P(HeardScenario, leaves_nothing_unheard_that_still_holds) { hear(GetParam(), 180.0); }

class HeardAtOtherRates : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Ten, HeardAtOtherRates,
                         ::testing::Values("03_first_wall_keyboard", "04_perimeter_lap_keyboard",
                                           "08_stairs_and_a_drop", "14_way_to_another_room_keyboard",
                                           "14_following_by_ear", "15_where_am_i_and_look", "16_rooms_and_exits",
                                           "first_contact", "first_minutes_keyboard", "kept_way"),
                         [](const auto& row) { return "of_" + row.param; });

TEST_P(HeardAtOtherRates, leaves_nothing_unheard_that_still_holds) {
    // A sanitizer has seen the scenario at 180 words a minute, so it needs only one of the two rates.
    const bool even = GetParam().size() % 2 == 0;
    for (const double words_per_minute : {120.0, 350.0})
        if (test::kSanitizerScale == 1.0 || even == (words_per_minute < 180.0)) hear(GetParam(), words_per_minute);
}

class SoundingScenario : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, SoundingScenario, ::testing::ValuesIn(all_scenarios()),
                         [](const auto& row) { return "of_" + row.param; });

TEST_P(SoundingScenario, keeps_its_true_peak_3_db_below_full_scale) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "sound takes too long to mix under a sanitizer";
    const auto scenario = read(GetParam());
    auto world = read_requested(scenario.world);
    ASSERT_TRUE(world) << world.error().sentence();
    test::Sounding sounding;
    const auto log = run_scenario(scenario, std::make_shared<const Scene>(std::move(*world)), sounding.audio(),
                                  sounding, {read_requested}, [&](HeadlessSession&) { sounding.mix_ms(); });
    ASSERT_TRUE(log) << log.error().sentence();
    EXPECT_GT(sounding.mix().size(), 48000U);
    EXPECT_LT(test::measured(sounding.mix(), 2).true_peak_db, -3.0);
}

}  // namespace heard_scenarios_test
}  // namespace handrail
