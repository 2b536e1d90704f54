#include "app/core/world/questions.h"

#include <random>
#include <set>

#include "app/core/session/session.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail {
namespace questions_test {

using test::SceneBuilder;
using testing::HasSubstr;
using testing::Not;

// Makes a hall of 8 by 8 metres with the base in the middle, facing north. The hall has a cupboard in each quarter, one
// of them behind a screen, a low bench ahead, and a ticking clock.
SceneBuilder hall() {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {8, 8, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({-0.2, 8, 0}, {8.2, 8.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({-0.2, -0.2, 0}, {8.2, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({8, 0, 0}, {8.2, 8, 2.6}, "east wall", SolidRole::Solid, "wood", FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 8, 2.6}, "west wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.box({3.5, 6, 0}, {4.5, 6.4, 0.5}, "Bench", SolidRole::Solid, "wood", FeatureKind::Object);
    b.box({7, 3.5, 0}, {7.5, 4.5, 2}, "Cupboard", SolidRole::Solid, "wood", FeatureKind::Object);
    b.box({3, 1, 0}, {5, 1.1, 2.2}, "Screen", SolidRole::Solid, "glass", FeatureKind::Object);
    b.box({3.9, 0.3, 0.5}, {4.1, 0.5, 1.2}, "Statue", SolidRole::Solid, "concrete", FeatureKind::Object);
    b.scene().sounds.push_back({{1.0, 4.0, 1.5}, "Clock", "clock_tick", 1.0});
    b.scene().name = "hall";
    b.start({4, 4, 0}, 0.0);
    return b;
}

std::vector<std::string> names(const std::vector<Sight>& sights) {
    std::vector<std::string> all;
    for (const Sight& sight : sights) all.push_back(sight.name);
    return all;
}

TEST(Questions, about_the_surroundings_are_answered_with_one_unhidden_thing_per_quarter) {
    const WalkerWorld world(hall().share());
    const auto quarters = around({world, {4, 4, 0}, 0.0});
    EXPECT_EQ(quarters[0]->name, "Bench");
    EXPECT_EQ(quarters[1]->name, "Cupboard");
    EXPECT_EQ(quarters[2]->name, "Screen") << "the statue stands behind it";
    EXPECT_EQ(quarters[3]->name, "Clock");
    const auto turned = around({world, {4, 4, 0}, kPi / 2.0});
    EXPECT_EQ(turned[0]->name, "Cupboard");
    EXPECT_EQ(turned[3]->name, "Bench");
    for (const Sight& sight : in_sight({world, {4, 4, 0}, 0.0}, 24)) EXPECT_NE(sight.name, "Statue");
    EXPECT_THAT(names(in_sight({world, {2, 0.6, 0}, 0.0}, 24)), testing::Contains("Statue"));
}

TEST(Questions, mention_a_sound_only_if_it_does_not_come_from_a_thing_that_they_mention) {
    SceneBuilder b = hall();
    b.box({0.8, 3.8, 0}, {1.2, 4.2, 1.7}, "Grandfather clock", SolidRole::Solid, "wood", FeatureKind::Object);
    b.scene().sounds.push_back({{7.0, 7.0, 1.0}, "Fan", "hum", 1.0});
    const auto mentioned = names(in_sight({WalkerWorld(b.share()), {4, 4, 0}, 0.0}, 24));
    EXPECT_THAT(mentioned, testing::Contains("Grandfather clock"));
    EXPECT_THAT(mentioned, Not(testing::Contains("Clock")));
    EXPECT_THAT(mentioned, testing::Contains("Fan"));
}

TEST(Questions, about_an_empty_quarter_are_answered_with_its_wall_or_that_it_is_open) {
    SceneBuilder b;
    b.box({-5, -5, -0.2}, {5, 5, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({-5, 5, 0}, {5, 5.2, 2}, "north wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    const WalkerWorld world(b.share());
    const auto quarters = around({world, {0, 0, 0}, 0.0});
    ASSERT_TRUE(quarters[0]);
    EXPECT_EQ(quarters[0]->name, "north wall");
    EXPECT_NEAR(quarters[0]->seen.distance_m, 5.0, 1e-3);
    EXPECT_FALSE(quarters[1] || quarters[2] || quarters[3]);
}

TEST(Questions, about_ahead_are_answered_with_at_most_four_things_by_distance_and_the_wall) {
    SceneBuilder b = hall();
    for (int i = 0; i < 4; ++i)
        b.box({3.2 + 0.5 * i, 6.6 + 0.35 * i, 0}, {3.3 + 0.5 * i, 6.7 + 0.35 * i, 1.5}, fmt::format("Post {}", i));
    const WalkerWorld world(b.share());
    const auto sights = ahead({world, {4, 4, 0}, 0.0});
    EXPECT_THAT(names(sights), testing::ElementsAre("Bench", "Post 0", "Post 1", "Post 2"));
    for (std::size_t i = 1; i < sights.size(); ++i) EXPECT_LE(sights[i - 1].seen.distance_m, sights[i].seen.distance_m);
    EXPECT_THAT(names(ahead({WalkerWorld(hall().share()), {4, 4, 0}, 0.0})),
                testing::ElementsAre("Bench", "north wall"));
}

TEST(Questions, about_one_direction_find_low_things_and_things_behind_them) {
    const WalkerWorld world(hall().share());
    EXPECT_THAT(names(look_towards({world, {4, 4, 0}, 0.0}, 0.0)), testing::ElementsAre("Bench", "north wall"));
    EXPECT_THAT(names(look_towards({world, {4, 4, 0}, 0.0}, kPi / 4.0)), testing::ElementsAre("north wall"));
}

// Compares the answer with a slow method: it draws straight lines to many points of each box, and checks that no other
// box blocks them.
TEST(Questions, mention_no_hidden_thing_and_every_thing_with_a_visible_middle) {
    std::mt19937_64 random(test::seed_of_run());
    std::uniform_real_distribution<double> place(-6.0, 6.0), size(0.2, 1.5);
    for (const double far : {0.0, 1e4})
        for (int round = 0; round < 40; ++round) {
            SceneBuilder b;
            std::vector<Aabb> boxes;
            for (int i = 0; i < 12; ++i) {
                const Vec3 at(far + place(random), place(random), 0.0);
                const Vec3 extent(size(random), size(random), 0.3 + size(random));
                Aabb box{at, at + extent};
                if (glm::length(box.centre_m() - Vec3(far, 0, 1)) < 2.0) continue;
                boxes.push_back(box);
                b.box(box.min_m, box.max_m, fmt::format("box {}", boxes.size() - 1));
            }
            const WalkerWorld world(b.share());
            const Vec3 eye(far, 0.0, kLookHeight_m);
            // Slab test, which excludes the ends of the line.
            const auto crosses = [&](const Aabb& box, const Vec3& to) {
                double enter = 0.0, leave = 1.0;
                for (int axis = 0; axis < 3; ++axis) {
                    const double way = to[axis] - eye[axis];
                    if (std::abs(way) < 1e-12) {
                        if (eye[axis] < box.min_m[axis] || eye[axis] > box.max_m[axis]) return false;
                        continue;
                    }
                    const double a = (box.min_m[axis] - eye[axis]) / way, c = (box.max_m[axis] - eye[axis]) / way;
                    enter = std::max(enter, std::min(a, c));
                    leave = std::min(leave, std::max(a, c));
                }
                return enter < leave - 1e-9;
            };
            const auto reached = [&](std::size_t which, const Vec3& to) {
                for (std::size_t i = 0; i < boxes.size(); ++i)
                    if (i != which && crosses(boxes[i], to)) return false;
                return true;
            };
            std::set<std::string> reported;
            for (const Sight& sight : in_sight({world, {far, 0, 0}, 0.0}, 100)) reported.insert(sight.name);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const std::string name = fmt::format("box {}", i);
                const Vec3 middle = boxes[i].centre_m();
                if (reached(i, middle)) {
                    EXPECT_TRUE(reported.contains(name)) << name << " round " << round;
                }
                bool any = false;
                for (int x = 0; x <= 12 && !any; ++x)
                    for (int y = 0; y <= 12 && !any; ++y)
                        for (int z = 0; z <= 12 && !any; ++z)
                            any = reached(i, boxes[i].min_m + boxes[i].size_m() * Vec3(x / 12.0, y / 12.0, z / 12.0));
                if (!any) {
                    EXPECT_FALSE(reported.contains(name)) << name << " round " << round;
                }
            }
        }
}

TEST(Questions, are_answered_in_more_detail_at_higher_verbosity_and_with_a_name_at_every_level) {
    Sight sight{{0.0, 2.8, FeatureId{0}, {}}, "Door", "wood", false};
    DescriptionStyle how;
    const auto at = [&](int verbosity) {
        how.verbosity = verbosity;
        return describe(sight, "shut, hinged left", how);
    };
    EXPECT_EQ(at(0), "Door");
    EXPECT_EQ(at(1), "Door");
    EXPECT_EQ(at(2), "Door, 4 steps ahead");
    EXPECT_EQ(at(3), "Door, wood, shut, hinged left, 4 steps ahead");
    EXPECT_EQ(at(4), "Door: it is 4 steps ahead. It is made of wood. It is shut, hinged left.");
    sight.surface = true;
    EXPECT_EQ(at(2), "Door, wood, 4 steps ahead") << "a surface's name includes its material";
}

TEST(Questions, about_doors_are_answered_with_hinge_and_handle_as_seen_from_here) {
    Feature door;
    door.hinge = "west";
    door.handle = "east";
    EXPECT_EQ(sides_of_door(door, 0.0), "hinged left, handle right");
    EXPECT_EQ(sides_of_door(door, kPi), "hinged right, handle left");
    EXPECT_EQ(sides_of_door(door, kPi / 2.0), "") << "along the wall there is no side";
    EXPECT_EQ(sides_of_door(Feature{}, 0.0), "");
}

TEST(LookRound, begins_ahead_turns_in_sixteenths_and_follows_the_hand) {
    LookRound look;
    const Vec3 here{1, 2, 0};
    EXPECT_NEAR(look.step(1, here, 0.3, std::nullopt), 0.3, 1e-12);
    EXPECT_NEAR(look.step(1, here, 0.3, std::nullopt), 0.3 + kPi / 8, 1e-12);
    EXPECT_NEAR(look.step(-1, here, 0.3, std::nullopt), 0.3, 1e-12);
    EXPECT_NEAR(look.step(1, here, 1.0, std::nullopt), 1.0, 1e-12) << "turned: ahead again";
    EXPECT_NEAR(look.step(1, here, 1.0, 2.0), 2.0, 1e-12) << "the hand points";
    EXPECT_NEAR(look.step(1, here, 1.0, 2.0), 2.0 + kPi / 8, 1e-12) << "and has not moved";
    EXPECT_NEAR(look.step(1, here, 1.0, 2.5), 2.5, 1e-12);
    for (int i = 0; i < 16; ++i) look.step(1, here, 1.0, 2.5);
    EXPECT_NEAR(look.step(1, here + Vec3(0.5, 0, 0), 1.0, 2.5), 1.0, 1e-12) << "the body has moved";
}

TEST(ScaleBar, is_five_steps_indoors_and_25_metres_outdoors_with_north) {
    DescriptionStyle how;
    how.heading_rad = kPi / 2.0;
    EXPECT_EQ(
        scale_bar_words(false, how, 60.0, 0.0),
        "5 steps or 3.5 metres are 5.8 centimetres under your hand. Under your hand, north is away from you; from "
        "where you stand, it is left.");
    EXPECT_EQ(scale_bar_words(true, how, 0.0, 0.0), "25 metres, 36 steps. North is left.");
    how.directions = DirectionChoice::Clock;
    EXPECT_THAT(scale_bar_words(true, how, 0.0, 0.0), HasSubstr("North is at 9 o'clock."));
    EXPECT_TRUE(under_roof(WalkerWorld([] {
                               SceneBuilder b;
                               b.box({-1, -1, 2.5}, {1, 1, 2.6}, "ceiling");
                               return b.share();
                           }()),
                           {0, 0, 0}));
    EXPECT_FALSE(under_roof(WalkerWorld(hall().share()), {4, 4, 0}));
}

TEST(Coordinates, give_metres_from_the_origin_and_the_height_above_the_surface_below) {
    EXPECT_EQ(coordinates_words({3.04, -0.51, 1.0}), "3 east, 0.5 south, height 1 metre");
    EXPECT_EQ(coordinates_words({-2.0, 0.0, -0.0001}), "2 west, 0 north, height 0 metres");
    const WalkerWorld world(hall().share());
    EXPECT_NEAR(above_floor_m(world, {4, 4, 1.3}).value(), 1.3, 1e-3);
    EXPECT_NEAR(above_floor_m(world, {4, 6.2, 1.3}).value(), 0.8, 1e-3) << "above the bench";
    EXPECT_FALSE(above_floor_m(world, {40, 4, 1.3}));
}

// In a session, the command keys ask these questions.
TEST(SessionQuestions, are_answered_in_the_chosen_vocabulary_and_at_the_chosen_level) {
    Settings settings;
    settings.speech.directions = DirectionChoice::Clock;
    Session app(settings, HandFacts{});
    app.apply(WorldEntered{make_ready(hall().share())}, 0.0);
    double now = 0.0;
    const auto request = [&](Command command) {
        app.take_cues();
        app.apply(CommandDown{command}, now += 1.0);
        app.apply(CommandUp{command}, now);
        std::string said;
        for (const CueRequest& cue : app.take_cues())
            if (cue.kind == CueRequestKind::Say) said += cue.text;
        return said;
    };
    app.tick(0.1, ToolState{});
    EXPECT_THAT(request(Command::AheadOfMe), HasSubstr("Bench, 3 steps at 12 o'clock."));
    EXPECT_THAT(request(Command::AroundMe), HasSubstr("9 o'clock: Clock, 4 steps."));
    EXPECT_THAT(request(Command::LookNext), HasSubstr("At 12 o'clock: Bench"));
    EXPECT_THAT(request(Command::LookNext), HasSubstr("At 1 o'clock: Bench, 3 steps; north wall, plaster, 6 steps."));
    EXPECT_THAT(request(Command::Coordinates), HasSubstr("4 east, 4 north, height 0 metres"));
    EXPECT_THAT(request(Command::ScaleBar), HasSubstr("25 metres"));
    settings.speech.verbosity = 1;
    settings.speech.directions = DirectionChoice::Compass;
    app.apply(SettingsChanged{settings}, now);
    EXPECT_EQ(request(Command::AroundMe), "North: Bench. East: Cupboard. South: Screen. West: Clock.");
    settings.speech.verbosity = 4;
    app.apply(SettingsChanged{settings}, now);
    EXPECT_THAT(request(Command::AheadOfMe), HasSubstr("Bench: it is 3 steps north. It is made of wood."));
    settings.speech.distances_in_steps = false;
    app.apply(SettingsChanged{settings}, now);
    EXPECT_THAT(request(Command::AheadOfMe), HasSubstr("2 metres north"));
    EXPECT_THAT(request(Command::WhereAmI), Not(HasSubstr("steps")));
}

}  // namespace questions_test
}  // namespace handrail
