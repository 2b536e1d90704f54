// A recording as a scenario: what of it is expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/record/scenario_of.h"
#include "tests/support/project_root.h"

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
    return made ? made->toml : "";
}

TEST(ScenarioOfRecording, expects_nothing_that_was_answered_before_the_rooms_were_found) {
    const std::string early = scenario_with(line_at(1500, "room_entered", {{"room", 1}, {"name", "Hall"}}));
    EXPECT_THAT(early, HasSubstr("say_in_order = \"Hall, at the door.\""));
    EXPECT_THAT(early, HasSubstr("press = \"where\""));
}

TEST(ScenarioOfRecording, expects_all_answers_where_no_room_is_ever_entered) {
    EXPECT_THAT(scenario_with(""), HasSubstr("say_in_order = \"At the door. | Hall, at the door.\""));
}

}  // namespace scenario_of_test
}  // namespace handrail
