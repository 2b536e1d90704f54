// Tests the spotlight, outside which nothing sounds, and the greatest number of sounds at once.
#include "app/core/context/spotlight.h"

#include <gmock/gmock.h>

#include <set>

#include "app/core/context/soundscape.h"
#include "app/core/places/mark_list.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace spotlight_test {

using settings::SpotlightChoice;
using test::SceneBuilder;
using ::testing::ElementsAre;

// Eight lamps in a circle of three metres around the base, the first in the north and the others clockwise.
struct InTheCircle {
    InTheCircle() { soundscape.enter(*plain.world.scene); }
    static std::shared_ptr<const Scene> lamps() {
        SceneBuilder b;
        b.box({-100, -100, -1}, {100, 100, 0}, "ground", SolidRole::Solid, "grass", FeatureKind::Floor);
        for (int i = 0; i < 8; ++i)
            b.scene().sounds.push_back(
                {forward_of_heading(0.25 * kPi * i) * 3.0 + Vec3(0.0, 0.0, 1.6), "lamp", "ambient_light_buzz", 1.0});
        b.start({0, 0, 0}, 0.0);
        return b.share();
    }
    // Returns the lamps that are heard after two seconds.
    std::set<std::uint32_t> heard() {
        for (int i = 0; i < 120; ++i) {
            std::vector<CueRequest> cues;
            soundscape.tick(*plain.world.solids, plain.avatar.ears_m(), now_s += 1.0 / 60.0, cues,
                            {spotlight(plain.context), static_cast<std::size_t>(sound.most_at_once)});
            for (const CueRequest& cue : cues) {
                if (cue.loudness > 0.0) playing.insert(cue.source);
                else playing.erase(cue.source);
            }
        }
        return playing;
    }
    test::PlainSession plain{lamps()};
    Settings::Sound& sound = plain.person.settings.sound;
    Soundscape soundscape;
    std::set<std::uint32_t> playing;
    double now_s = 0.0;
};

TEST(Spotlight, lets_only_what_is_inside_its_width_sound) {
    InTheCircle one;
    one.sound.most_at_once = 8;
    EXPECT_EQ(one.heard().size(), 8U);
    one.sound.spotlight = SpotlightChoice::Ahead;
    EXPECT_EQ(one.heard(), (std::set<std::uint32_t>{0}));
    one.sound.spotlight_deg = 100.0;
    EXPECT_EQ(one.heard(), (std::set<std::uint32_t>{0, 1, 7}));
    one.plain.avatar.heading_rad = 0.5 * kPi;
    EXPECT_EQ(one.heard(), (std::set<std::uint32_t>{1, 2, 3})) << "it turns with the person";
    one.sound.spotlight = SpotlightChoice::Off;
    EXPECT_EQ(one.heard().size(), 8U);
}

TEST(Spotlight, points_where_the_hand_is) {
    InTheCircle one;
    one.sound.spotlight = SpotlightChoice::Hand;
    EXPECT_EQ(one.heard(), (std::set<std::uint32_t>{0})) << "without a hand it points ahead";
    one.plain.hands.right.present = true;
    one.plain.hands.tool.ticks = 1;
    one.plain.hands.tool.proxy_m = Vec3(0.0, -0.5, 1.0);
    EXPECT_EQ(one.heard(), (std::set<std::uint32_t>{4}));
}

TEST(Spotlight, is_switched_on_and_off_by_one_command) {
    InTheCircle one;
    const auto turn = [&] {
        turn_spotlight_on(one.plain.context, 0.0);
        return one.sound.spotlight;
    };
    EXPECT_EQ(turn(), SpotlightChoice::Ahead);
    EXPECT_EQ(turn(), SpotlightChoice::Off) << "there is no hand";
    one.plain.hands.right.present = true;
    one.plain.hands.tool.ticks = 1;
    EXPECT_EQ(turn(), SpotlightChoice::Ahead);
    EXPECT_EQ(turn(), SpotlightChoice::Hand);
    EXPECT_EQ(turn(), SpotlightChoice::Off);
    EXPECT_THAT(
        one.plain.said(),
        ElementsAre("Spotlight ahead, 60 degrees wide. Only what is ahead of you sounds.", "Spotlight off",
                    "Spotlight ahead, 60 degrees wide. Only what is ahead of you sounds.",
                    "Spotlight on the hand, 60 degrees wide. Only what is in its direction sounds.", "Spotlight off"));
}

TEST(Density, limits_the_sounds_that_play_at_once_and_can_be_reduced_while_they_play) {
    InTheCircle one;
    EXPECT_EQ(one.heard().size(), 3U);
    one.sound.most_at_once = 5;
    EXPECT_EQ(one.heard().size(), 5U);
    one.sound.most_at_once = 1;
    EXPECT_EQ(one.heard().size(), 1U);
}

TEST(Density, lets_only_the_nearest_landmarks_sound_and_the_spotlight_chooses_among_them) {
    SceneBuilder b;
    b.box({-100, -100, -1}, {100, 100, 0}, "ground", SolidRole::Solid, "grass", FeatureKind::Floor);
    for (int i = 0; i < 6; ++i) {
        const Vec3 at = forward_of_heading(kPi / 3.0 * i) * (0.6 + 0.1 * i);
        const FeatureId post = b.box(at - Vec3(0.05, 0.05, 0.0), at + Vec3(0.05, 0.05, 1.2), "post");
        b.scene().features[post.value].landmark = true;
    }
    b.start({0, 5, 0}, 0.0);
    const auto sounded = [&](int most, bool beam) {
        test::PlainSession plain(b.share());
        plain.person.settings.sound.most_at_once = most;
        plain.person.settings.sound.spotlight = beam ? SpotlightChoice::Ahead : SpotlightChoice::Off;
        MarkList marks(plain.context, plain.world.marks);
        marks.enter_world();
        marks.tick(0.0);
        plain.stand(Vec3(0.0));
        plain.cues.take();
        marks.tick(0.1);
        return plain.heard(SoundKind::Landmark);
    };
    EXPECT_EQ(sounded(3, false), 3U);
    EXPECT_EQ(sounded(6, false), 6U);
    EXPECT_EQ(sounded(6, true), 1U) << "only the post ahead";
}

}  // namespace spotlight_test
}  // namespace handrail
