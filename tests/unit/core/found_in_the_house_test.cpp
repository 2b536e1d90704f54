// Everything that has a name in our house is found within 20 seconds by each of the tools that are there for it.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "app/core/hand_way.h"
#include "app/core/words.h"
#include "audio-cues/plan/speakable.h"
#include "tests/support/scale.h"
#include "tests/unit/core/explorer.h"
#include "worlds/navigation/way_place.h"

namespace handrail {
namespace {

using test::Explorer;

constexpr double kWithin_s = 20.0;
constexpr double kBefore_m = 2.0;  // on foot, from where a thing comes into the hand's reach
constexpr double kHandHeight_m = 1.0, kBody_m = 0.3;

std::string told(const NamedThing& thing) { return sentence_case(speakable(thing.name)); }

// All of them, or under instruments some from all over the house.
std::vector<NamedThing> sought_things(const Scene& scene) {
    const std::vector<NamedThing> all = named_things(scene);
    EXPECT_GT(all.size(), 50U);
    const std::size_t every = all.size() / static_cast<std::size_t>(test::scaled(static_cast<int>(all.size())));
    std::vector<NamedThing> some;
    for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
    return some;
}

// The hand rests, opens the doors it is told of and goes where it is pulled.
TEST(FoundInTheHouse, by_a_hand_that_is_taken_there_from_the_front_door) {
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t");
    double longest_s = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
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
    }
    fmt::print("{} things: taken to each in {:.1f} s at most\n", things.size(), longest_s);
}

// Where somebody stands on the way to a thing, at most so far before it, as far off as nothing stands between: who is farther off is taken there, or walks.
class Approach {
public:
    explicit Approach(const std::shared_ptr<const Scene>& scene)
        : scene_(scene), world_(scene), navigation_(*Navigation::make(*scene, walk_body(*scene, 0.25, 1.7, 0.2))) {}
    std::optional<Vec3> before(const NamedThing& thing, double most_m) {
        const Route route = walk_to_thing(*navigation_, world_, scene_->starts.front().feet_m, thing.bounds_m, thing.feature);
        if (!route.reaches) return std::nullopt;
        double length_m = 0.0;
        for (std::size_t i = 1; i < route.points_m.size(); ++i) length_m += glm::length(route.points_m[i] - route.points_m[i - 1]);
        for (double off_m = most_m; off_m > 0.0; off_m -= 0.25) {
            const Vec3 feet = place_along(route.points_m, std::max(0.0, length_m - off_m));
            const Vec3 hand = feet + Vec3(0.0, 0.0, kHandHeight_m);
            if (in_sight(hand, place_on(thing.bounds_m, hand), thing.feature)) return feet;
            // A door's frame hides the door from the side, but not the place before it.
            if (in_sight(hand, route.points_m.back() + Vec3(0.0, 0.0, kHandHeight_m), thing.feature)) return feet;
        }
        return route.points_m.back();
    }

private:
    // From a body's width farther off, too: nobody stands in the leaf of a shut door.
    bool in_sight(const Vec3& hand, const Vec3& place, FeatureId thing) const {
        const Vec3 way = place - hand;
        const double length_m = glm::length(way);
        return free_line(world_, length_m > kBody_m ? hand - kBody_m / length_m * way : hand, place, thing);
    }

    std::shared_ptr<const Scene> scene_;
    BodyWorld world_;
    std::shared_ptr<Navigation> navigation_;
};

// A hand that is nowhere held back: the whole reach is for seeking.
Settings free_reach() {
    Settings settings;
    settings.workspace.rim = settings.desk.use = false;
    return settings;
}

// The body is set down there, facing north, and the hand lies in the middle of its reach.
void stand(Explorer& p, const Vec3& feet_m) {
    p.leave_lists();
    p.hold(Vec3(0.0));
    p.app().place(feet_m, 0.0, p.now_s());
    p.run(1.2);
}

// Whoever seeks along one axis after the other for where the push of a line turns round has the place. The hand is a strong one: it goes on through walls,
// which the lines go through too.
TEST(FoundInTheHouse, by_a_hand_along_the_lines_that_cross_there) {
    constexpr double kReach_m = 0.07;
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t", free_reach());
    Approach approach(house);
    double longest_s = 0.0, farthest_m = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const auto feet = approach.before(thing, kBefore_m);
        ASSERT_TRUE(feet) << told(thing);
        stand(p, *feet);
        ASSERT_TRUE(p.ask(told(thing), thing.feature, "Lines through it")) << told(thing);
        const double begins_s = p.now_s();
        p.run(1.6);  // told, and come in
        Vec3 at(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            // To one end of the reach, then slowly through it, until the push, which was onwards, holds back.
            Vec3 from = at;
            from[axis] = -kReach_m;
            p.hold(from, 0.2);
            bool pushed = false, turned = false;
            while (!turned && from[axis] < kReach_m) {
                from[axis] += 0.0005;
                p.hold(from, 0.08);
                const double push_n = p.tool().guidance.force_n[axis];
                pushed = pushed || push_n > 0.05;
                turned = pushed && push_n <= 0.0;
            }
            EXPECT_TRUE(turned) << told(thing) << ", axis " << axis;
            at[axis] = from[axis];
        }
        const double took_s = p.now_s() - begins_s, off_m = glm::length(p.tool().hip_m - thing.bounds_m.centre_m()) / 60.0;
        EXPECT_LE(off_m, 0.001) << told(thing);
        EXPECT_LE(took_s, kWithin_s) << told(thing);
        longest_s = std::max(longest_s, took_s);
        farthest_m = std::max(farthest_m, off_m);
        p.tap(Command::CrossLines);
    }
    fmt::print("{} things: each found along its lines in {:.1f} s at most, its middle to {:.1f} mm of the hand\n", things.size(), longest_s,
               1000.0 * farthest_m);
}

// Who counts the ticks knows how far away it is, and by how much nearer a small step brings the hand, which way to go. Walls and things hold this hand back.
TEST(FoundInTheHouse, by_a_hand_that_listens_to_warmer_and_colder) {
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t", free_reach());
    Approach approach(house);
    double longest_s = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const auto feet = approach.before(thing, kBefore_m);
        ASSERT_TRUE(feet) << told(thing);
        stand(p, *feet);
        const std::size_t from = p.lines();
        ASSERT_TRUE(p.ask(told(thing), thing.feature, "Warmer and colder")) << told(thing);
        const double begins_s = p.now_s();
        const auto here = [&] { return p.heard("Here: " + told(thing), from); };
        const auto over = [&] { return here() || p.now_s() - begins_s > kWithin_s; };
        // From one tick to the next.
        const auto felt_m = [&] {
            std::size_t heard = p.sounds().size(), ticks = 0;
            double last_s = 0.0, interval_s = 0.0;
            while (ticks < 2 && !over()) {
                p.run(1.0 / 60.0);
                for (; heard < p.sounds().size(); ++heard) {
                    if (p.sounds()[heard].cue.kind != SoundKind::Warmer) continue;
                    interval_s = p.sounds()[heard].time_s - last_s;
                    last_s = p.sounds()[heard].time_s;
                    ++ticks;
                }
            }
            return (interval_s - 0.08) / 11.0;
        };
        // Goes there, and does not press on against what it meets. True: it came as far as it wanted.
        const auto go = [&](const Vec3& to_m) {
            p.hold(to_m);
            const Vec3 pressed_m = (p.tool().hip_m - p.tool().proxy_m) / 60.0;
            p.hold(to_m - pressed_m);
            return glm::length(pressed_m) < 0.001;
        };
        while (!over()) {
            const Vec3 at = p.hand_m();
            const double far_m = felt_m(), step_m = std::clamp(0.3 * far_m, 0.003, 0.012);
            Vec3 slope(0.0);
            for (int axis = 0; axis < 3 && !over(); ++axis) {
                Vec3 aside = at;
                aside[axis] += at[axis] > 0.05 ? -step_m : step_m;
                if (!go(aside)) {
                    aside[axis] = 2.0 * at[axis] - aside[axis];
                    if (!go(aside)) continue;
                }
                slope[axis] = (felt_m() - far_m) / (aside[axis] - at[axis]);
            }
            if (over()) break;
            Vec3 next = at;
            if (glm::length(slope) > 0.1) next -= slope / glm::length(slope) * std::max(far_m, 0.004);
            if (glm::length(next) > 0.07) next *= 0.07 / glm::length(next);
            go(next);
        }
        EXPECT_TRUE(here()) << told(thing) << ":\n" << p.all_heard(from);
        longest_s = std::max(longest_s, p.now_s() - begins_s);
        if (!here()) {
            p.choose(told(thing), thing.feature);
            p.line("Warmer and colder");  // off
        }
    }
    fmt::print("{} things: each found by warmer and colder in {:.1f} s at most\n", things.size(), longest_s);
}

// Keys only, and nothing but which of its three sounds the beacon makes and from which side it comes: turns by notches until it rings, and walks. What is
// bumped into is stepped round, or followed with the trailing hand.
TEST(FoundInTheHouse, by_somebody_who_walks_by_keys_to_where_the_beacon_rings) {
    const auto house = test::our_world("house.map");
    Explorer p(house, nullptr);
    Approach approach(house);
    double longest_s = 0.0;
    std::size_t walked = 0;  // the others began where the beacon takes one to be there
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const auto feet = approach.before(thing, 1.5 * kBefore_m);
        ASSERT_TRUE(feet) << told(thing);
        stand(p, *feet);
        const std::size_t from = p.lines();
        ASSERT_TRUE(p.ask(told(thing), thing.feature, "Beacon")) << told(thing);
        const double begins_s = p.now_s();
        const auto here = [&] { return p.heard("Here: " + told(thing), from); };
        const auto over = [&] { return here() || p.now_s() - begins_s > kWithin_s; };
        const auto walk = [&](double seconds) {
            const std::size_t heard = p.sounds().size();
            bool bumped = false;
            p.app().press(Command::Forward, p.now_s());
            for (const double until = p.now_s() + seconds; !bumped && !over() && p.now_s() < until;) {
                p.run(1.0 / 60.0);
                for (std::size_t i = heard; i < p.sounds().size(); ++i) bumped = bumped || p.sounds()[i].cue.kind == SoundKind::Bump;
            }
            p.app().release(Command::Forward);
            return !bumped;
        };
        std::size_t listened = p.sounds().size();
        int bumps = 0;
        while (!over()) {
            p.run(1.0 / 60.0);
            std::optional<SoundCue> beat;
            for (; listened < p.sounds().size(); ++listened)
                if (is_beacon(p.sounds()[listened].cue.kind)) beat = p.sounds()[listened].cue;
            if (!beat) continue;
            if (beat->kind != SoundKind::BeaconAhead) {
                const Listener& ears = p.ears();
                const Vec3 way = beat->position_m - ears.ears_m;
                const bool right = wrap_angle(std::atan2(way.x, way.y) - ears.heading_rad) >= 0.0;
                for (int notch = 0; notch < (beat->kind == SoundKind::BeaconBehind ? 5 : 1); ++notch)
                    p.tap(right ? Command::TurnRight : Command::TurnLeft, 0.25);
            } else if (!walk(0.5)) {
                // A step round it, to the left where there is none to the right; where that did not do, two metres along it with the right hand.
                if (++bumps % 2 == 1) {
                    for (int side = 0; side < 2; ++side) {
                        for (int notch = 0; notch < (side == 0 ? 4 : 8); ++notch) p.tap(Command::TurnRight, 0.25);
                        if (walk(0.6 + 0.3 * bumps)) break;
                    }
                } else {
                    p.app().press(Command::TrailRight, p.now_s());
                    p.run(2.0);
                    p.app().release(Command::TrailRight);
                }
            }
            listened = p.sounds().size();
        }
        EXPECT_TRUE(here()) << told(thing) << ":\n" << p.all_heard(from);
        longest_s = std::max(longest_s, p.now_s() - begins_s);
        walked += p.now_s() - begins_s > 0.1;
        if (!here()) p.tap(Command::MuteBeacon);
    }
    EXPECT_GT(walked, things.size() / 3);
    fmt::print("{} things: walked to {} of them by the beacon, in {:.1f} s at most\n", things.size(), walked, longest_s);
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
