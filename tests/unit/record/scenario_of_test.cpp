// Tests how a recording is converted to a scenario, and which of its lines become expectations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/core/scenario/scenario_run.h"
#include "app/record/scenario_of.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace scenario_of_test {

using testing::HasSubstr;

std::string line_at(int t_ms, const std::string& is, nlohmann::json with) {
    with["t"] = t_ms;
    with["is"] = is;
    if (is != "said" && is != "room_entered") with["frame"] = 0, with["now_s"] = t_ms / 1000.0;
    return with.dump() + "\n";
}

std::string said(int t_ms, const std::string& text) {
    return line_at(t_ms, "said", {{"text", text}, {"class", "answer"}, {"voiced", true}});
}

std::string where_at(int t_ms) {
    return line_at(t_ms, "command_down", {{"command", "where"}}) + line_at(t_ms, "command_up", {{"command", "where"}});
}

std::string scenario_with(const std::string& between) {
    const std::string events = line_at(0, "recording",
                                       {{"form", 2},
                                        {"program", "1"},
                                        {"language", "en"},
                                        {"begun_utc", "2026-01-01T00:00:00Z"},
                                        {"begun_s", 0.0},
                                        {"virtual_time", false},
                                        {"settings", nlohmann::json::object()}}) +
                               line_at(10, "world_entered",
                                       {{"world", test::bundled_world("house.map")},
                                        {"map_metres_per_unit", 0.03125},
                                        {"obj_metres_per_unit", 1.0},
                                        {"unit_is_known", false},
                                        {"checksum", ""},
                                        {"additions", ""}}) +
                               where_at(700) + said(710, "At the door.") + between + where_at(2000) +
                               said(2010, "Hall, at the door.");
    const auto read = read_events(events, "events.jsonl");
    EXPECT_TRUE(read) << read.error().sentence();
    const auto made = scenario_of(*read, "made");
    EXPECT_TRUE(made) << made.error().sentence();
    return made ? with_expectations(*made) : "";
}

TEST(ScenarioOfRecording, expects_no_answer_from_before_the_rooms_were_found) {
    const std::string early = scenario_with(line_at(1500, "room_entered", {{"room", 1}, {"name", "Hall"}}));
    EXPECT_THAT(early, HasSubstr("say_in_order = \"Hall, at the door.\""));
    EXPECT_THAT(early, HasSubstr("press = \"where\""));
}

TEST(ScenarioOfRecording, expects_all_answers_if_no_room_is_ever_entered) {
    EXPECT_THAT(scenario_with(""), HasSubstr("say_in_order = \"At the door. | Hall, at the door.\""));
}

TEST(ScenarioOfRecording, keeps_typed_lines_as_lines_and_counted_commands_as_one_action) {
    const std::string toml = scenario_with(line_at(1500, "line", {{"line", "enter"}}) +
                                           line_at(1600, "command_down", {{"command", "forward"}, {"times", 3}}) +
                                           line_at(1600, "command_up", {{"command", "forward"}}));
    EXPECT_THAT(toml, HasSubstr("line = \"enter\"\n"));
    EXPECT_THAT(toml, HasSubstr("press = \"forward\"\nfor_s = 0.000\ntimes = 3\n"));
}

TEST(ScenarioOfRecording, uses_the_same_input_mode_as_the_session) {
    EXPECT_THAT(scenario_with(""), HasSubstr("acts_by = \"window-keys\"\n"));
}

// The conversion must omit and count actions that the scenario cannot perform, and lines that a session announces
// differently when it plays the scenario. The remaining expectations must be met.
TEST(ScenarioOfRecording, omits_lines_and_expectations_that_fail_in_a_trial_run) {
    ScenarioText text;
    text.toml =
        "title = \"t\"\nworld = \"house.map\"\n\n[[do]]\nat_s = 0.5\nline = \"nobody asked\"\n\n[[do]]\nat_s = "
        "1.0\npress = \"where\"\n";
    const auto scene = std::make_shared<const Scene>(*read_world(test::bundled_world("house.map")));
    text.toml.replace(text.toml.find("house.map"), 9, test::bundled_world("house.map"));
    text.expected = {"Something that it never says."};
    EXPECT_FALSE(as_it_runs(text, {read_requested}));
    const auto log = [&] {
        RecordingAudio audio;
        RecordingSpeech speech;
        std::vector<int> undone;
        const auto scenario = read_scenario_text(with_expectations(text), "t.toml", {});
        EXPECT_TRUE(scenario && run_scenario(*scenario, scene, audio, speech, {read_requested}, {}, &undone));
        EXPECT_EQ(undone, std::vector<int>{4});
        return speech.lines().back().utterance.text;
    }();
    text.expected.push_back(log);
    const auto made = as_it_runs(text, {read_requested});
    ASSERT_TRUE(made) << made.error().sentence();
    EXPECT_EQ(made->expected, std::vector<std::string>{log});
    EXPECT_EQ(made->left_out.size(), 2U);
    EXPECT_THAT(made->toml, testing::Not(HasSubstr("nobody asked")));
    EXPECT_THAT(made->toml, HasSubstr("press = \"where\""));
}

TEST(ScenarioOfRecording, keeps_the_longest_common_subsequence_of_answers) {
    using Texts = std::vector<std::string>;
    EXPECT_EQ(said_by_both({"a", "b", "c", "d"}, {"d", "b", "x", "c", "d"}), (Texts{"b", "c", "d"}));
    EXPECT_EQ(said_by_both({}, {"a"}), Texts{});
}

}  // namespace scenario_of_test
}  // namespace handrail
