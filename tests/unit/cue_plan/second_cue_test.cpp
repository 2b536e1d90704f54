#include "audio-cues/plan/second_cue.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <cmath>

namespace handrail {
namespace second_cue_test {

struct Range {
    double least_gain = 1e9, most_gain = 0.0, least_pitch = 1e9, most_pitch = 0.0;
};
Range over_time(const Vec3& head_m, bool behind = true, bool height = true) {
    Range range;
    for (double t = 0.0; t < 5.0; t += 0.005) {
        const SecondCue cue = second_cue(head_m, t, behind, height);
        range.least_gain = std::min(range.least_gain, cue.gain);
        range.most_gain = std::max(range.most_gain, cue.gain);
        range.least_pitch = std::min(range.least_pitch, cue.pitch);
        range.most_pitch = std::max(range.most_pitch, cue.pitch);
    }
    return range;
}

TEST(SecondCue, is_absent_ahead_and_at_the_sides_on_the_same_level) {
    for (const Vec3 head : {Vec3(0, 2, 0), Vec3(2, 0, 0), Vec3(-3, 0, 0), Vec3(1, 1, 0.4), Vec3(0, 0, 0)}) {
        const Range r = over_time(head);
        EXPECT_EQ(r.least_gain, 1.0);
        EXPECT_EQ(r.most_gain, 1.0);
        EXPECT_EQ(r.least_pitch, 1.0);
        EXPECT_EQ(r.most_pitch, 1.0);
    }
}

TEST(SecondCue, flutters_fully_straight_behind_and_less_towards_the_side) {
    const Range back = over_time({0, -2, 0}), slant = over_time({2, -1, 0});
    EXPECT_NEAR(back.least_gain, 1.0 - kFlutterDepth, 0.01);
    EXPECT_EQ(back.most_gain, 1.0) << "it never gets louder";
    EXPECT_GT(slant.least_gain, back.least_gain + 0.1);
    EXPECT_EQ(over_time({0, -2, 0}, false).least_gain, 1.0);
}

TEST(SecondCue, raises_the_pitch_above_and_lowers_it_below_by_a_quarter_of_an_octave) {
    const Range above = over_time({0, 1, 3}), below = over_time({0, 1, -3});
    EXPECT_NEAR(above.most_pitch, std::exp2(kGlideOctaves), 0.01);
    EXPECT_EQ(above.least_pitch, 1.0);
    EXPECT_NEAR(below.least_pitch, std::exp2(-kGlideOctaves), 0.01);
    EXPECT_EQ(below.most_pitch, 1.0);
    int rising = 0, all = 0;
    for (double t = 0.0; t < 9.0; t += 0.01, ++all)
        if (second_cue({0, 1, 3}, t + 0.01, true, true).pitch > second_cue({0, 1, 3}, t, true, true).pitch) ++rising;
    EXPECT_GT(rising, 0.8 * all) << "one hears it rise, not fall";
    EXPECT_EQ(over_time({0, 1, 3}, true, false).most_pitch, 1.0);
}

TEST(SecondCue, changes_without_jumps_in_time_and_space) {
    for (double angle = 0.0; angle < 2.0 * kPi; angle += 0.01) {
        const Vec3 a{std::sin(angle), std::cos(angle), 0.7}, b{std::sin(angle + 0.01), std::cos(angle + 0.01), 0.7};
        EXPECT_NEAR(second_cue(a, 1.23, true, true).gain, second_cue(b, 1.23, true, true).gain, 0.03);
        EXPECT_NEAR(second_cue(a, 1.23, true, true).pitch, second_cue(b, 1.23, true, true).pitch, 0.03);
    }
    for (double t = 0.0; t < 3.0; t += 0.005)
        EXPECT_NEAR(second_cue({0, -1, 2}, t, true, true).gain, second_cue({0, -1, 2}, t + 0.005, true, true).gain,
                    0.12);
}

}  // namespace second_cue_test
}  // namespace handrail
