#include "app/core/words.h"

namespace handrail {
namespace {

TEST(DistanceWords, are_whole_steps_and_rounded_to_five_past_twenty) {
    const DistanceWords steps{true, 0.7};
    EXPECT_EQ(distance_words(3.5, steps), "5 steps");
    EXPECT_EQ(distance_words(0.7, steps), "1 step");
    EXPECT_EQ(distance_words(0.2, steps), "close by");
    EXPECT_EQ(distance_words(15.0, steps), "20 steps");  // 21.4 steps
    EXPECT_EQ(distance_words(33.0, steps), "45 steps");  // 47.1 steps
}

TEST(DistanceWords, are_half_metres_when_metres_are_chosen) {
    const DistanceWords metres{false, 0.7};
    EXPECT_EQ(distance_words(3.4, metres), "3.5 metres");
    EXPECT_EQ(distance_words(1.1, metres), "1 metre");
    EXPECT_EQ(distance_words(0.1, metres), "close by");
}

TEST(SizeWords, give_metres_and_steps) { EXPECT_EQ(size_words(6.0, 4.0, {true, 0.7}), "6 by 4 metres, 9 by 6 steps"); }

TEST(RelativeWords, are_seen_from_where_one_faces) {
    EXPECT_EQ(relative_words(0.0, radians_from_degrees(90.0)), "left");
    EXPECT_EQ(relative_words(radians_from_degrees(180.0), radians_from_degrees(-135.0)), "ahead left");
    EXPECT_EQ(relative_words(3.0, 3.0), "ahead");
}

TEST(WrapAngle, stays_within_half_a_turn) {
    for (const double a : {-20.0, -kPi, 0.0, kPi, 3.5, 1e3}) {
        const double w = wrap_angle(a);
        EXPECT_GT(w, -kPi - 1e-12);
        EXPECT_LE(w, kPi + 1e-12);
        EXPECT_NEAR(std::sin(w), std::sin(a), 1e-9);
    }
}

}  // namespace
}  // namespace handrail
