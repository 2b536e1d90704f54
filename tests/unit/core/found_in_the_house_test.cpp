// Everything that has a name in our house is found within 20 seconds by each of the tools that are there for it.
#include <fmt/format.h>

#include "app/core/words.h"
#include "audio-cues/plan/speakable.h"
#include "tests/unit/core/explorer.h"

namespace handrail {
namespace {

using test::Explorer;

constexpr double kWithin_s = 20.0;

std::string told(const NamedThing& thing) { return sentence_case(speakable(thing.name)); }

// The hand rests, opens the doors it is told of and goes where it is pulled.
TEST(FoundInTheHouse, by_a_hand_that_is_taken_there_from_the_front_door) {
    Explorer p(test::our_world("house.map"), "sim-t");
    double longest_s = 0.0;
    int found = 0;
    for (const NamedThing& thing : named_things(*p.app().scene())) {
        p.hold(Vec3(0.0));
        p.tap(Command::Home);
        p.run(1.2);
        const std::size_t from = p.lines();
        ASSERT_TRUE(p.ask(told(thing), thing.feature, "Take me there")) << told(thing);
        p.push();
        const double begins_s = p.now_s();
        std::size_t door = from;
        const bool there = p.wait_for(
            [&] {
                if (const std::size_t shut = p.find("opens it", door); shut < p.lines()) {
                    door = shut + 1;
                    p.tap(Command::Use);
                }
                return p.heard("Here: " + told(thing), from);
            },
            kWithin_s);
        EXPECT_TRUE(there) << told(thing) << ":\n" << p.all_heard(from);
        longest_s = std::max(longest_s, p.now_s() - begins_s);
        found += there;
    }
    fmt::print("{} things taken to, the longest in {:.1f} s\n", found, longest_s);
    EXPECT_GT(found, 50);
}

// From the front door to the music room upstairs, and half a second on the way.
void lead_to_piano(Explorer& p) {
    const auto& features = p.app().scene()->features;
    const auto piano = std::find_if(features.begin(), features.end(), [](const Feature& feature) { return feature.name == "Piano"; });
    ASSERT_TRUE(p.ask("Piano", FeatureId{static_cast<std::uint32_t>(piano - features.begin())}, "Take me there"));
    EXPECT_TRUE(p.heard("Taking your hand to Piano")) << p.all_heard(0);
    EXPECT_TRUE(p.heard("By way of Stairs, 2.9 metres up, Music room door.")) << p.all_heard(0);
    p.push();
    p.run(1.5);
    ASSERT_EQ(p.tool().guidance.phase, GuidancePhase::Acts);
}

TEST(TakenAlongAWay, a_hand_whose_body_walks_off_or_is_put_elsewhere_gets_a_new_way_and_one_that_pulls_is_let_go) {
    for (const char* how : {"walks", "home", "pulls"}) {
        Explorer p(test::our_world("house.map"), "sim-t");
        lead_to_piano(p);
        const std::size_t from = p.lines();
        const std::uint32_t first = p.app().guidance().number;
        if (how == std::string("walks")) {
            p.hold(p.hand_m());
            p.app().press(Command::Back, p.now_s());
            p.run(1.5);
            p.app().release(Command::Back);
        } else if (how == std::string("home")) {
            p.tap(Command::Home);
        } else {
            p.push({1.6, 0.0, 0.0});
        }
        p.run(3.0);
        if (how == std::string("pulls")) {
            EXPECT_TRUE(p.heard("Let go", from)) << p.all_heard(from);
            EXPECT_EQ(p.app().guidance().number, 0U);
            continue;
        }
        EXPECT_FALSE(p.heard("Let go", from)) << how << ": " << p.all_heard(from);
        EXPECT_TRUE(p.heard("You have left the way. Taking your hand to Piano", from)) << how << ": " << p.all_heard(from);
        EXPECT_GT(p.app().guidance().number, first) << how;
        EXPECT_EQ(p.tool().guidance.phase, GuidancePhase::Acts) << how;
    }
}

}  // namespace
}  // namespace handrail
