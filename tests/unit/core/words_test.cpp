#include "app/core/dialogue/words.h"

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace words_test {

TEST(DistanceWords, are_whole_steps_rounded_to_five_above_twenty) {
    const DistanceWords steps{true, 0.7};
    EXPECT_EQ(distance_words(3.5, steps), "5 steps");
    EXPECT_EQ(distance_words(0.7, steps), "1 step");
    EXPECT_EQ(distance_words(0.2, steps), "close by");
    EXPECT_EQ(distance_words(15.0, steps), "20 steps");  // 21.4 steps before rounding
    EXPECT_EQ(distance_words(33.0, steps), "45 steps");  // 47.1 steps before rounding
}

TEST(DistanceWords, are_half_metres_in_metres_mode) {
    const DistanceWords metres{false, 0.7};
    EXPECT_EQ(distance_words(3.4, metres), "3.5 metres");
    EXPECT_EQ(distance_words(1.1, metres), "1 metre");
    EXPECT_EQ(distance_words(0.1, metres), "close by");
}

TEST(SizeWords, give_metres_and_steps) { EXPECT_EQ(size_words(6.0, 4.0, {true, 0.7}), "6 by 4 metres, 9 by 6 steps"); }

TEST(DistanceWords, are_exact_if_rounding_is_off) {
    EXPECT_EQ(distance_words(3.36, {true, 0.7, false}), "4.8 steps");
    EXPECT_EQ(distance_words(33.04, {false, 0.7, false}), "33 metres");
    EXPECT_EQ(distance_words(33.0, {false, 0.7}), "35 metres");
}

TEST(DirectionWords, depend_only_on_the_chosen_vocabulary) {
    const double north_east = radians_from_degrees(45.0);
    struct Case {
        double bearing_deg;
        const char *sides, *clock, *compass;
    };
    for (const Case& c :
         {Case{45, "ahead", "at 12 o'clock", "north-east"}, Case{135, "right", "at 3 o'clock", "south-east"},
          Case{-45, "left", "at 9 o'clock", "north-west"}, Case{225, "behind", "at 6 o'clock", "south-west"},
          Case{75, "30 degrees right", "at 1 o'clock", "east"}, Case{22, "25 degrees left", "at 11 o'clock", "north"},
          Case{255, "150 degrees left", "at 7 o'clock", "west"}, Case{46, "ahead", "at 12 o'clock", "north-east"}}) {
        const double bearing = radians_from_degrees(c.bearing_deg);
        EXPECT_EQ(direction_words(bearing, north_east, DirectionChoice::Sides), c.sides) << c.bearing_deg;
        EXPECT_EQ(direction_words(bearing, north_east, DirectionChoice::Clock), c.clock) << c.bearing_deg;
        EXPECT_EQ(direction_words(bearing, north_east, DirectionChoice::Compass), c.compass) << c.bearing_deg;
    }
    EXPECT_EQ(direction_words(radians_from_degrees(22.5), 0.0, DirectionChoice::Compass, false), "north-north-east");
    EXPECT_EQ(direction_words(radians_from_degrees(22.5), 0.0, DirectionChoice::Sides, false), "23 degrees right");
}

// In every direction and for every heading, the hour is the nearest one, and the direction in words names the same
// side.
TEST(DirectionWords, agree_with_each_other_in_every_direction) {
    for (int heading = -360; heading <= 360; heading += 30)
        for (int turn = -175; turn <= 175; turn += 5) {
            const double facing = radians_from_degrees(heading), bearing = radians_from_degrees(heading + turn);
            const std::string sides = direction_words(bearing, facing, DirectionChoice::Sides);
            EXPECT_EQ(sides.find("right") != std::string::npos, turn > 0) << heading << ' ' << turn;
            EXPECT_EQ(sides.find("left") != std::string::npos, turn < 0) << heading << ' ' << turn;
            int hour = 0;
            ASSERT_EQ(
                std::sscanf(direction_words(bearing, facing, DirectionChoice::Clock).c_str(), "at %d o'clock", &hour),
                1);
            EXPECT_LE(std::abs(degrees_from_radians(wrap_angle(radians_from_degrees(hour * 30.0 - turn)))), 15.0 + 1e-6)
                << heading << ' ' << turn;
        }
}

TEST(PlaceWords, combine_distance_and_direction) {
    const DistanceWords steps{true, 0.7};
    const double right = kPi / 2.0;
    EXPECT_EQ(place_words(6.3, radians_from_degrees(25), 0.0, DirectionChoice::Clock, steps), "9 steps at 1 o'clock");
    EXPECT_EQ(place_words(6.3, radians_from_degrees(25), 0.0, DirectionChoice::Sides, steps),
              "9 steps, 25 degrees right");
    EXPECT_EQ(place_words(6.3, right, 0.0, DirectionChoice::Sides, steps), "9 steps to the right");
    EXPECT_EQ(place_words(0.1, 0.0, 0.0, DirectionChoice::Sides, steps), "close by, ahead");
    EXPECT_EQ(place_words(6.3, right, 0.0, DirectionChoice::Compass, steps), "9 steps east");
}

TEST(Words, are_german_in_german) {
    const test::InLanguage german("de");
    const DistanceWords steps{true, 0.7}, metres{false, 0.7}, exact{true, 0.7, false};
    const double right = kPi / 2.0;
    EXPECT_EQ(distance_words(0.7, steps), "1 Schritt");
    EXPECT_EQ(distance_words(3.5, metres), "3,5 Meter");
    EXPECT_EQ(distance_words(3.36, exact), "4,8 Schritte");
    EXPECT_EQ(size_words(6.0, 4.5, steps), "6 mal 4,5 Meter, 9 mal 6 Schritte");
    EXPECT_EQ(place_words(6.3, 0.0, 0.0, DirectionChoice::Sides, steps), "9 Schritte geradeaus");
    EXPECT_EQ(place_words(6.3, right, 0.0, DirectionChoice::Sides, steps), "9 Schritte nach rechts");
    EXPECT_EQ(place_words(6.3, radians_from_degrees(-25), 0.0, DirectionChoice::Sides, steps),
              "9 Schritte, 25 Grad links");
    EXPECT_EQ(place_words(6.3, right, 0.0, DirectionChoice::Compass, steps), "9 Schritte nach Osten");
    EXPECT_EQ(place_words(6.3, right, 0.0, DirectionChoice::Clock, steps), "9 Schritte auf 3 Uhr");
    EXPECT_EQ(place_words(0.1, right, 0.0, DirectionChoice::Compass, steps), "ganz nah, im Osten");
    EXPECT_EQ(minutes_words(900.0), "15 Minuten");
    EXPECT_EQ(sentence_case("überall"), "Überall");
}

TEST(FoundWords, use_the_correct_article_in_english_and_none_in_german) {
    EXPECT_EQ(found_words("Falcon"), "I found a Falcon.");
    EXPECT_EQ(found_words("omega.7"), "I found an omega.7.");
    const test::InLanguage german("de");
    EXPECT_EQ(found_words("Falcon"), "Gefunden: Falcon.");
}

TEST(SentenceCase, changes_only_the_first_letter_in_any_script) {
    EXPECT_EQ(sentence_case("north wall"), "North wall");
    EXPECT_EQ(sentence_case("éCRAN"), "ÉCRAN");
    EXPECT_EQ(sentence_case("дверь"), "Дверь");
    EXPECT_EQ(sentence_case("4 steps"), "4 steps");
    EXPECT_EQ(sentence_case(""), "");
}

TEST(WrapAngle, stays_within_half_a_turn) {
    for (const double a : {-20.0, -kPi, 0.0, kPi, 3.5, 1e3}) {
        const double w = wrap_angle(a);
        EXPECT_GT(w, -kPi - 1e-12);
        EXPECT_LE(w, kPi + 1e-12);
        EXPECT_NEAR(std::sin(w), std::sin(a), 1e-9);
    }
}

}  // namespace words_test
}  // namespace handrail
