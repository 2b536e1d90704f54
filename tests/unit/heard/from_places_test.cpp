// Tests the setting speech.from_places from the session to the ears: with it, the voice comes from the direction of
// what it speaks about.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>

#include "tests/support/heard_legs.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/heard/recorded.h"
#include "worlds/base/language.h"

namespace handrail {
namespace from_places_test {

constexpr double kEqual = 1.05, kClear = 2.0;  // ratios of the energies at the two ears: equal, and clearly one-sided

class VoiceFromPlaces : public ::testing::TestWithParam<bool> {
protected:
    void SetUp() override {
        if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "minutes of sound take too long to mix under a sanitizer";
        ASSERT_TRUE(speak_language("en"));
        if (from_places()) {
            ASSERT_TRUE(recorded.app().apply(SettingSet{"speech.from_places", "true"}, recorded.now_s()));
        }
    }
    static bool from_places() { return GetParam(); }
    // Returns how much more energy the right ear hears than the left ear.
    static double right_to_left(std::span<const float> both) {
        std::array<double, 2> ears{};
        for (std::size_t i = 0; i < both.size(); ++i)
            ears.at(i % 2) += static_cast<double>(both[i]) * static_cast<double>(both[i]);
        return ears[1] / ears[0];
    }
    // Checks that the session has the line spoken in the middle, or from the right or left if the setting is on, and
    // that the line sounds so in `both`.
    static void expect_from(const test::PrintedLine& line, std::span<const float> both, bool right) {
        const double ratio = right ? right_to_left(both) : 1.0 / right_to_left(both);
        EXPECT_EQ(line.utterance.right_rad.has_value(), from_places()) << line.utterance.text;
        if (!from_places()) {
            EXPECT_NEAR(std::log(ratio), 0.0, std::log(kEqual)) << line.utterance.text;
            return;
        }
        EXPECT_GE(ratio, kClear) << line.utterance.text;
        EXPECT_GT((right ? 1.0 : -1.0) * std::sin(line.utterance.right_rad.value_or(0.0)), 0.3) << line.utterance.text;
    }

    test::Recorded recorded;
};

INSTANTIATE_TEST_SUITE_P(Switch, VoiceFromPlaces, ::testing::Bool(),
                         [](const auto& row) { return row.param ? "on" : "off"; });

TEST_P(VoiceFromPlaces, speaks_a_leg_from_the_direction_in_which_it_goes) {
    recorded.enter("house.map");
    recorded.press(Command::Exits);  // so that the session knows the rooms from now on
    recorded.listen();
    recorded.type("routes study");
    for (const bool right : {true, false}) {
        recorded.app().apply(Placed{recorded.app().feet_m(), (right ? -0.5 : 0.5) * kPi}, recorded.now_s());
        recorded.listen();
        recorded.press(Command::RepeatLeg);
        recorded.listen();
        const test::PrintedLine& line = recorded.lines().back();
        ASSERT_EQ(line.utterance.topic, SpeechTopic::Leg) << line.utterance.text;
        const auto leg = test::understood(line.utterance.text, test::english_legs());
        ASSERT_TRUE(leg) << line.utterance.text;
        EXPECT_EQ(leg->turn_notches > 0, right) << line.utterance.text;
        expect_from(line, std::span(recorded.mix()).subspan(2 * line.begin_frame), right);
    }
}

// The walker steps to the left until the wall is there. Compares the ears without the sound of the bump, which comes
// from that side in any case.
TEST_P(VoiceFromPlaces, names_what_the_walker_bumps_into_from_its_side) {
    recorded.enter("first_room.map");
    recorded.app().apply(Placed{{3.0, 2.0, 0.0}, 0.5 * kPi}, recorded.now_s());
    recorded.listen();
    const std::size_t from = recorded.lines().size();
    for (int steps = 0; steps < 10 && recorded.lines().size() == from; ++steps) recorded.press(Command::SideLeft);
    recorded.listen();
    for (std::size_t i = from; i < recorded.lines().size(); ++i)
        if (recorded.lines()[i].utterance.speech_class == SpeechClass::Warning)
            return expect_from(recorded.lines()[i], test::Sounding::alone(recorded.lines()[i]), false);
    FAIL() << "the walker met no wall";
}

}  // namespace from_places_test
}  // namespace handrail
