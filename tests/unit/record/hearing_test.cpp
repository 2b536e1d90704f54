// Tests the playback of a recording: times, speed, stopping, moving back and forth, and a voice that needs more time
// than the recorded one.
#include <gtest/gtest.h>

#include "app/record/hearing.h"
#include "tests/support/names.h"

namespace handrail {
namespace hearing_test {

constexpr const char* kHead =
    R"({"t":0,"is":"recording","form":1,"program":"1","language":"en","begun_utc":"2026-01-01T00:00:00Z",)"
    R"("begun_s":100.0,"virtual_time":true,"settings":{}})"
    "\n";

Recording recording_of(const std::string& lines) {
    auto read = read_events(kHead + lines, "events.jsonl");
    EXPECT_TRUE(read);
    return std::move(*read);
}

std::string said(int t_ms, const std::string& text, bool voiced = true) {
    return R"({"t":)" + std::to_string(t_ms) + R"(,"is":"said","text":")" + text + R"(","class":"answer","voiced":)" +
           (voiced ? "true" : "false") + "}\n";
}

// Plays for `for_s`, with a voice that needs `voice_s` for each line. Returns the lines, each with the hundredth of a
// second at which it begins.
std::vector<std::string> heard(Hearing& hearing, double for_s, double voice_s) {
    std::vector<std::string> all;
    double silent_at_s = -1.0;
    for (double t_s = 0.0; t_s < for_s - 1e-9; t_s += 0.01)
        for (const SaidLine& line : hearing.go_on(0.01, t_s < silent_at_s).lines) {
            all.push_back(std::to_string(std::lround((t_s + 0.01) * 100.0)) + " " + line.text);
            if (line.voiced) silent_at_s = t_s + voice_s;
        }
    return all;
}

TEST(Hearing, plays_each_line_at_its_time_and_at_other_speeds) {
    const Recording recording = recording_of(said(493, "One") + said(1493, "Two") + said(2993, "Three"));
    Hearing plain(recording, 1.0), fast(recording, 4.0), slow(recording, 0.5);
    EXPECT_EQ(heard(plain, 4.0, 0.1), (std::vector<std::string>{"50 One", "150 Two", "300 Three"}));
    EXPECT_TRUE(plain.over());
    EXPECT_EQ(heard(fast, 4.0, 0.1), (std::vector<std::string>{"13 One", "38 Two", "75 Three"}));
    EXPECT_EQ(heard(slow, 7.0, 0.1), (std::vector<std::string>{"99 One", "299 Two", "599 Three"}));
}

TEST(Hearing, waits_for_a_voice_that_needs_longer_but_not_for_text_that_was_only_written) {
    const Recording recording = recording_of(said(493, "One") + said(593, "Written", false) + said(993, "Two"));
    Hearing hearing(recording, 1.0);
    EXPECT_EQ(heard(hearing, 4.0, 1.995), (std::vector<std::string>{"50 One", "60 Written", "250 Two"}));
    EXPECT_NEAR(hearing.length_s(), 0.993, 1e-9);
}

TEST(Hearing, can_pause_and_move_back_and_forth) {
    std::string lines;
    for (int i = 0; i < 30; ++i) lines += said(i * 1000 + 993, "Line " + std::to_string(i));
    const Recording recording = recording_of(lines);
    Hearing hearing(recording, 1.0);
    EXPECT_EQ(heard(hearing, 2.5, 0.1).size(), 2U);
    hearing.stop_or_go_on();
    EXPECT_TRUE(heard(hearing, 5.0, 0.1).empty());
    EXPECT_NEAR(hearing.at_s(), 2.5, 1e-6);
    hearing.stop_or_go_on();
    hearing.jump(Hearing::kJump_s);
    EXPECT_EQ(heard(hearing, 1.0, 0.1), (std::vector<std::string>{"50 Line 12"}));
    hearing.jump(-Hearing::kJump_s);
    EXPECT_EQ(heard(hearing, 1.0, 0.1), (std::vector<std::string>{"50 Line 3"}));
    hearing.jump(-Hearing::kJump_s);
    EXPECT_EQ(hearing.at_s(), 0.0);
    hearing.jump(1000.0);
    EXPECT_NEAR(hearing.at_s(), 29.993, 1e-9);
    EXPECT_EQ(heard(hearing, 1.0, 0.1), (std::vector<std::string>{"1 Line 29"}));
    EXPECT_TRUE(hearing.over());
}

TEST(Hearing, plays_knocks_and_places_as_recorded) {
    Recording recording = recording_of(R"({"t":200,"is":"contact","at_m":[1,2,3],"force_mn":640})"
                                       "\n"
                                       R"({"t":300,"is":"contact","at_m":"nowhere"})"
                                       "\n");
    recording.frames = {{100.0, 0, 0, {1.0, 0.0, 0.0}, 0.0}, {100.25, 0, 0, {2.0, 0.0, 0.0}, 0.0}};
    Hearing hearing(recording, 1.0);
    EXPECT_EQ(hearing.place()->feet_m.x, 1.0);
    const Hearing::Heard first = hearing.go_on(0.26, false);
    ASSERT_EQ(first.knocks.size(), 1U);
    EXPECT_EQ(first.knocks[0].at_m, Vec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(first.knocks[0].force_n, 0.64, 1e-12);
    EXPECT_EQ(hearing.place()->feet_m.x, 2.0);
    EXPECT_TRUE(hearing.go_on(1.0, false).knocks.empty());
}

}  // namespace hearing_test
}  // namespace handrail
