// Tests that with each tool for searching, a simulated person finds everything with a name in the bundled house within
// 20 seconds.
#include <fmt/format.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/core/dialogue/words.h"
#include "app/core/wayfinding/hand_path.h"
#include "audio-cues/plan/speakable.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/core/explorer.h"
#include "worlds/navigation/route_place.h"

namespace handrail {
namespace found_in_the_house_test {

using test::Explorer;

constexpr double kWithin_s = 20.0;
constexpr double kBefore_m = 2.0;  // distance of a thing from the walker at which the search with the hand begins
constexpr double kHandHeight_m = 1.0, kBody_m = 0.3;

std::string announced_name(const NamedThing& thing) { return sentence_case(speakable(thing.name)); }

// Returns all things with a name. Under sanitizers, returns only some things from all parts of the house.
std::vector<NamedThing> sought_things(const Scene& scene) {
    const std::vector<NamedThing> all = named_things(scene);
    EXPECT_GT(all.size(), 50U);
    const std::size_t every = all.size() / static_cast<std::size_t>(test::scaled(static_cast<int>(all.size())));
    std::vector<NamedThing> some;
    for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
    return some;
}

// The hand does not move by itself. It follows the pull, and opens the doors that are announced to it.
TEST(FoundInTheHouse, everything_is_reached_by_a_hand_that_is_guided_from_the_front_door) {
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t");
    double longest_s = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        p.hold(Vec3(0.0));
        p.tap(Command::Home);
        p.run(1.2);
        const std::size_t from = p.lines();
        ASSERT_TRUE(p.request(announced_name(thing), thing.feature, "Take me there")) << announced_name(thing);
        p.push();
        const double begins_s = p.now_s();
        std::size_t door = from;
        const bool there = p.wait_for(
            [&] {
                if (const std::size_t shut = p.find("opens it", door); shut < p.lines()) {
                    door = shut + 1;
                    p.tap(Command::Use);
                }
                return p.heard("Here: " + announced_name(thing), from);
            },
            kWithin_s);
        EXPECT_TRUE(there) << announced_name(thing) << ":\n" << p.all_heard(from);
        longest_s = std::max(longest_s, p.now_s() - begins_s);
    }
    fmt::print("{} things: taken to each in {:.1f} s at most\n", things.size(), longest_s);
}

// Finds a place on the route to a thing where a person stands to search with the hand. The place is at most `most_m`
// before the thing, and as far away as nothing is in between. A person who is farther away walks or is guided to that
// place.
class Approach {
public:
    explicit Approach(const std::shared_ptr<const Scene>& scene)
        : scene_(scene),
          world_(scene),
          navigation_(*Navigation::make(*scene, walker_measures(*scene, 0.25, 1.7, 0.2))) {}
    std::optional<Vec3> before(const NamedThing& thing, double most_m) {
        const Route route =
            walk_to_thing(*navigation_, world_, scene_->starts.front().feet_m, thing.bounds_m, thing.feature);
        if (!route.reaches) return std::nullopt;
        double length_m = 0.0;
        for (std::size_t i = 1; i < route.points_m.size(); ++i)
            length_m += glm::length(route.points_m[i] - route.points_m[i - 1]);
        for (double off_m = most_m; off_m > 0.0; off_m -= 0.25) {
            const Vec3 feet = place_along(route.points_m, std::max(0.0, length_m - off_m));
            const Vec3 hand = feet + Vec3(0.0, 0.0, kHandHeight_m);
            if (in_sight(hand, place_on(thing.bounds_m, hand), thing.feature)) return feet;
            // The frame of a door may hide the door from the side. It is then enough that the place in front of the
            // door is in sight.
            if (in_sight(hand, route.points_m.back() + Vec3(0.0, 0.0, kHandHeight_m), thing.feature)) return feet;
        }
        return route.points_m.back();
    }

private:
    // The line of sight begins farther away by the width of a body, because nobody stands in the leaf of a shut door.
    bool in_sight(const Vec3& hand, const Vec3& place, FeatureId thing) const {
        const Vec3 way = place - hand;
        const double length_m = glm::length(way);
        return free_line(world_, length_m > kBody_m ? hand - kBody_m / length_m * way : hand, place, thing);
    }

    std::shared_ptr<const Scene> scene_;
    WalkerWorld world_;
    std::shared_ptr<Navigation> navigation_;
};

// Returns settings with which the whole workspace is free for searching, because there are no rim and no desk. Guidance
// follows straight lines.
Settings free_reach() {
    Settings settings;
    settings.workspace.rim = settings.desk.use = settings.guidance.along_way = false;
    return settings;
}

// Places the walker at `feet_m`, facing north, with the hand in the middle of its workspace.
void stand(Explorer& p, const Vec3& feet_m) {
    p.leave_lists();
    p.hold(Vec3(0.0));
    p.app().apply(Placed{feet_m, 0.0}, p.now_s());
    p.run(1.2);
}

// Places the walker at the front door, with the hand in the middle of its workspace.
void stand_at_the_front_door(Explorer& p) {
    p.leave_lists();
    p.hold(Vec3(0.0));
    p.tap(Command::Home);
    p.run(1.2);
}

// Moves a hand where its person wants. At the end of its workspace, the hand grabs and moves the world, as a person
// lifts a mouse and puts it down again. The hand does not press on against obstacles, and it opens the doors that are
// announced to it.
class SeekingHand {
public:
    SeekingHand(Explorer& p, std::size_t heard_from) : p_(p), door_(heard_from) {}
    // Makes room for a movement of `by_m` in every direction. Returns true if the world was moved for that.
    bool have_room(double by_m) {
        if (glm::length(p_.hand_m()) + by_m <= kReach_m) return false;
        p_.tap(Command::Grab, 0.1);
        p_.hold(-0.8 * p_.hand_m(), 0.4);
        p_.tap(Command::Grab, 0.05);
        return true;
    }
    // Moves the hand by `by_m`, in hand metres, or along an obstacle if that leads far enough. Returns false if an
    // obstacle stops the hand.
    bool go(const Vec3& by_m, double speed_m_per_s) {
        have_room(glm::length(by_m));
        const auto pressed_m = press_on(by_m, speed_m_per_s);
        if (!pressed_m) return true;
        const Vec3 out = glm::normalize(*pressed_m), along = by_m - out * glm::dot(by_m, out);
        return glm::length(along) > 0.4 * glm::length(by_m) && !press_on(along, speed_m_per_s);
    }

    void let_go_of_it() { p_.hold(p_.hand_m() - pressed()); }
    // Moves the hand by `by_m`. If the hand then presses by more than `most_m` into an obstacle, moves it back until it
    // presses by `most_m`. Returns how far the hand presses in the end. All lengths are in hand metres.
    Vec3 press(const Vec3& by_m, double speed_m_per_s, double most_m) {
        p_.hold(p_.hand_m() + by_m, speed_m_per_s);
        const Vec3 pressed_m = pressed();
        open_doors();  // the Use key opens a door that the hand touches
        const double much_m = glm::length(pressed_m);
        if (much_m <= most_m) return pressed_m;
        p_.hold(p_.hand_m() - pressed_m * (1.0 - most_m / much_m));
        return pressed_m * (most_m / much_m);
    }

private:
    Vec3 pressed() const {
        return (p_.tool().hip_m - p_.tool().proxy_m) / p_.app().hand().tuning.touch.world_m_per_hand_m;
    }
    // Moves the hand by `by_m` and then out of any obstacle. Returns how far it pressed into the obstacle, or no value
    // if there was none.
    std::optional<Vec3> press_on(const Vec3& by_m, double speed_m_per_s) {
        p_.hold(p_.hand_m() + by_m, speed_m_per_s);
        const Vec3 pressed_m = pressed();
        open_doors();  // the Use key opens a door that the hand touches
        if (glm::length(pressed_m) < 0.001) return std::nullopt;
        p_.hold(p_.hand_m() - pressed_m);
        return pressed_m;
    }
    void open_doors() {
        const std::size_t shut = p_.find("opens it", door_);
        if (shut >= p_.lines()) return;
        door_ = shut + 1;
        p_.tap(Command::Use);
    }
    static constexpr double kReach_m = 0.055;

    Explorer& p_;
    std::size_t door_;
};

// Searches for a thing from the front door, with one of the tools in the list. It stores what the session has said
// since the search began.
struct Search {
    Search(Explorer& explorer, const NamedThing& sought, const char* tool) : p(explorer), thing(sought) {
        stand_at_the_front_door(p);
        from = p.lines();
        EXPECT_TRUE(p.request(announced_name(thing), thing.feature, tool)) << announced_name(thing);
        begins_s = p.now_s();
    }
    bool here() const { return p.heard("Here: " + announced_name(thing), from); }
    bool over() const { return here() || p.now_s() - begins_s > kWithin_s; }
    // Returns how long the search took. Call it when the search has ended.
    double found() const {
        EXPECT_TRUE(here()) << announced_name(thing) << ":\n" << p.all_heard(from);
        return p.now_s() - begins_s;
    }
    Explorer& p;
    const NamedThing& thing;
    std::size_t from = 0;
    double begins_s = 0.0;
};

// The four main directions in the plane, their diagonals, up and down.
const std::vector<Vec3> kSides{{0, 1, 0},  {1, 0, 0},  {-1, 0, 0},  {0, -1, 0}, {1, 1, 0},
                               {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {0, 0, 1},  {0, 0, -1}};
const std::vector<Vec3> kSlanting{{0, 1, 1},  {1, 0, 1},  {-1, 0, 1},  {0, -1, 1},
                                  {0, 1, -1}, {1, 0, -1}, {-1, 0, -1}, {0, -1, -1}};

// The hand moves on and yields to the forces. If it is stopped, it searches for a free direction.
TEST(FoundInTheHouse, everything_is_reached_by_a_hand_that_follows_the_lines_from_the_front_door) {
    constexpr double kSpeed_m_per_s = 0.06, kStep_s = 0.02, kFelt_n = 0.03;
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t");
    double longest_s = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const Search search(p, thing, "Lines leading there");
        SeekingHand hand(p, search.from);
        p.run(1.6);  // Wait until the guidance is announced and the force has reached its strength.
        const auto felt = [&] {
            const Vec3 force = p.tool().guidance.force_n;
            return glm::length(force) < kFelt_n ? Vec3(0.0) : force;
        };
        Vec3 way(0.0), came(0.0);  // present direction, and direction of the last centimetre of movement
        std::vector<Vec3> places;
        const auto feel_round = [&] {
            Vec3 best(0.0);
            double least_n = 1e9;
            hand.have_room(0.008);
            for (int i = 0; i < 20 && felt() != Vec3(0.0) && hand.go(0.0005 * glm::normalize(felt()), 0.1);
                 ++i) {  // moves back to where no force is felt
            }
            // Tries every direction except back. Tries the slanting directions only if none of the others is free.
            static constexpr double kFree_n = 0.02;
            for (const auto& sides : {kSides, kSlanting}) {
                if (least_n < kFree_n) break;
                for (const Vec3& side : sides) {
                    const Vec3 probe = glm::normalize(side);
                    if (search.over() || glm::dot(probe, came) < -0.5) continue;
                    const Vec3 at = p.hand_m();
                    const bool free = hand.go(0.003 * probe, 0.25);
                    const double back_n = -glm::dot(p.tool().guidance.force_n, probe);
                    hand.go(at - p.hand_m(), 0.25);
                    if (free && back_n < least_n) least_n = back_n, best = probe;
                }
            }
            way = best;
        };
        feel_round();
        int stalled = 0;
        while (!search.over()) {
            const Vec3 step = kSpeed_m_per_s * kStep_s * (way + felt() / 0.15);
            const bool free = hand.go(step, std::max(glm::length(step) / kStep_s, 0.01));
            if (glm::length(step) > 0.2 * kSpeed_m_per_s * kStep_s)
                way = glm::normalize(way + 0.25 * step / glm::length(step));
            places.push_back(p.tool().hip_m);
            for (std::size_t i = places.size(); i-- > 0;)
                if (const Vec3 along = places.back() - places[i]; glm::length(along) > 0.01 * 60.0) {
                    came = glm::normalize(along);
                    break;
                }
            stalled = !free || glm::dot(step, way) < 0.3 * kSpeed_m_per_s * kStep_s ? stalled + 1 : 0;
            if (stalled > 5) {
                feel_round();
                stalled = 0;
            }
        }
        longest_s = std::max(longest_s, search.found());
        if (!search.here()) p.tap(Command::CrossLines);
    }
    fmt::print("{} things: the lines followed to each in {:.1f} s at most\n", things.size(), longest_s);
}

// The hand searches along one axis after the other for the point where the force of a line reverses; that is the place.
// This hand is stronger than the device, so that it passes through walls, as the lines do.
TEST(FoundInTheHouse, everything_is_reached_by_a_hand_along_the_lines_that_cross_there) {
    constexpr double kReach_m = 0.07;
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t", free_reach());
    Approach approach(house);
    double longest_s = 0.0, farthest_m = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const auto feet = approach.before(thing, kBefore_m);
        ASSERT_TRUE(feet) << announced_name(thing);
        stand(p, *feet);
        ASSERT_TRUE(p.request(announced_name(thing), thing.feature, "Lines leading there")) << announced_name(thing);
        const double begins_s = p.now_s();
        p.run(1.6);  // Wait until the guidance is announced and the force has reached its strength.
        Vec3 at(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            // Moves the hand to one end of the workspace, then slowly through the workspace, until the force along the
            // axis changes from forward to backward.
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
            EXPECT_TRUE(turned) << announced_name(thing) << ", axis " << axis;
            at[axis] = from[axis];
        }
        const double took_s = p.now_s() - begins_s,
                     off_m = glm::length(p.tool().hip_m - thing.bounds_m.centre_m()) / 60.0;
        EXPECT_LE(off_m, 0.001) << announced_name(thing);
        EXPECT_LE(took_s, kWithin_s) << announced_name(thing);
        longest_s = std::max(longest_s, took_s);
        farthest_m = std::max(farthest_m, off_m);
        p.tap(Command::CrossLines);
    }
    fmt::print("{} things: each found along its lines in {:.1f} s at most, its middle to {:.1f} mm of the hand\n",
               things.size(), longest_s, 1000.0 * farthest_m);
}

// Estimates what a person concludes from the sounds of "warmer", each of which conveys how directly the hand has
// approached. The estimate is the direction to the thing, and its certainty along each axis. It is a Kalman filter over
// the sounds, in which older sounds have less weight.
class SenseOfWay {
public:
    void hear(const Vec3& went, double nearer) {
        sure_ += glm::mat<3, 3, double>(kChanges * kChanges);
        const Vec3 gain = sure_ * went / (glm::dot(went, sure_ * went) + kUnsure * kUnsure);
        way_ += gain * (nearer - glm::dot(went, way_));
        sure_ -= glm::outerProduct(gain, sure_ * went);
    }
    const Vec3& way() const { return way_; }
    // Returns the axis along which the direction is least known. The length of the result is the uncertainty.
    Vec3 doubt() const {
        Vec3 axis(0.6, 0.5, 0.62);
        for (int i = 0; i < 30; ++i) axis = glm::normalize(sure_ * axis);
        return axis * std::sqrt(glm::dot(axis, sure_ * axis));
    }

private:
    static constexpr double kChanges = 0.25, kUnsure = 0.15;
    Vec3 way_{0.0};
    glm::mat<3, 3, double> sure_{1.0};  // covariance of the direction
};

// Moves a hand in a weaving path. The hand moves in the direction in which it expects to approach the thing. It also
// moves sideways along the axis that it knows least, so that every sound is informative. It feels its way round
// obstacles.
class WarmerHand {
public:
    explicit WarmerHand(const Search& search)
        : p_(search.p), search_(search), hand_(p_, search.from), heard_(p_.sounds().size()) {}

    void seek() {
        before_m_ = proxy();
        Vec3 way = next_way();
        int held = 0;
        while (!search_.over()) {
            const Vec3 from = proxy();
            const double speed_m_per_s = speed();
            step(0.01 * speed_m_per_s * way, speed_m_per_s);
            held = glm::dot(proxy() - from, way) < 0.003 * speed_m_per_s ? held + 1 : 0;
            if (const auto tick = nearer_heard()) {
                sense_.hear(glm::normalize(tick->went_m), tick->nearer);
                way = next_way();
                held = 0;
            }
            if (held >= 3) {
                way = free_way(way);
                held = 0;
            }
        }
    }

private:
    static constexpr double kFeel_m = 0.002, kPress_m = 0.0006;
    // The hand moves at this speed in hand metres a second for each second of the interval between two sounds.
    static constexpr double kFast = 0.85;
    struct HeardNearer {
        Vec3 went_m{0.0};  // movement since the last sound that was used, in hand metres
        double nearer = 0.0;
    };

    Vec3 proxy() const { return p_.tool().proxy_m / p_.app().hand().tuning.touch.world_m_per_hand_m; }
    // A faster rhythm means that the thing is near, so the hand moves more slowly.
    double speed() const { return std::clamp(kFast * (interval_s_ - 0.05), 0.02, 0.10); }
    Vec3 next_way() {
        const Vec3 doubt = (weave_ = -weave_) * sense_.doubt();
        const Vec3 way = sense_.way() + doubt;
        return glm::length(way) > 0.05 ? glm::normalize(way) : glm::normalize(doubt);
    }
    void step(const Vec3& by_m, double speed_m_per_s) {
        if (hand_.have_room(glm::length(by_m))) {
            nearer_heard();
            deaf_ = true;  // ignores the next sound, because that sound includes the movement that made room
        }
        hand_.press(by_m, speed_m_per_s, kPress_m);
    }
    // If the hand is stopped, returns the free direction that is nearest to `wanted`.
    Vec3 free_way(const Vec3& wanted) {
        std::vector<Vec3> ways;
        for (const auto& sides : {kSides, kSlanting})
            for (const Vec3& side : sides) ways.push_back(glm::normalize(side));
        std::sort(ways.begin(), ways.end(),
                  [&](const Vec3& a, const Vec3& b) { return glm::dot(wanted, a) > glm::dot(wanted, b); });
        for (const Vec3& way : ways) {
            if (search_.over()) break;
            hand_.let_go_of_it();
            const Vec3 from = proxy();
            step(kFeel_m * way, 0.25);
            if (glm::dot(proxy() - from, way) > 0.7 * kFeel_m) return way;
        }
        return -wanted;
    }
    // Returns the result of the last sound, or no value if there was no new sound.
    std::optional<HeardNearer> nearer_heard() {
        std::optional<double> pitch;
        for (; heard_ < p_.sounds().size(); ++heard_)
            if (const SoundCue& cue = p_.sounds()[heard_].cue;
                cue.kind == SoundKind::Warmer || cue.kind == SoundKind::Colder)
                pitch = cue.pitch;
        if (!pitch) return std::nullopt;
        interval_s_ = p_.now_s() - std::exchange(ticked_s_, p_.now_s());
        const Vec3 went = proxy() - std::exchange(before_m_, proxy());
        // Also returns no value if the hand hardly moved.
        if (std::exchange(deaf_, false) || glm::length(went) < 0.0005) return std::nullopt;
        return HeardNearer{went, 2.0 * (*pitch - 1.0)};
    }

    Explorer& p_;
    const Search& search_;
    SeekingHand hand_;
    std::size_t heard_;
    SenseOfWay sense_;
    Vec3 before_m_{0.0};
    bool deaf_ = false;
    double interval_s_ = 0.0, ticked_s_ = 0.0, weave_ = 1.0;
};

// Walls and things stop this hand.
TEST(FoundInTheHouse, everything_is_reached_by_a_hand_that_listens_to_warmer_and_colder_from_the_front_door) {
    const auto house = test::our_world("house.map");
    Explorer p(house, "sim-t");
    double longest_s = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const Search search(p, thing, "Warmer and colder");
        WarmerHand(search).seek();
        longest_s = std::max(longest_s, search.found());
        if (search.here()) continue;
        p.leave_lists();
        p.choose(announced_name(thing), thing.feature);
        p.line("Warmer and colder");  // ends "warmer"
    }
    fmt::print("{} things: each found by warmer and colder from the front door in {:.1f} s at most\n", things.size(),
               longest_s);
}

// This person uses only keys and is in a hurry: the setting of the walking speed is 2 m/s. They know only the kind and
// the direction of each sound of the beacon, and the announced doors. They turn while walking, stand still for larger
// turns, and step round obstacles.
TEST(FoundInTheHouse, everything_is_reached_by_a_walker_who_follows_the_beacon_from_the_front_door) {
    constexpr double kHurried_m_per_s = 2.0;
    Settings settings;
    settings.walk.speed_m_per_s = kHurried_m_per_s;
    const auto house = test::our_world("house.map");
    Explorer p(house, nullptr, settings);
    double longest_s = 0.0;
    const std::vector<NamedThing> things = sought_things(*house);
    for (const NamedThing& thing : things) {
        const Search search(p, thing, "Beacon");
        std::size_t heard = p.sounds().size(), door = search.from;
        bool walking = false;
        const auto walk = [&](bool on) {
            if (on != std::exchange(walking, on))
                on ? p.app().apply(CommandDown{Command::Forward}, p.now_s())
                   : p.app().apply(CommandUp{Command::Forward}, p.now_s());
        };
        // Turns towards the last sound, to within five degrees: first by notches, then by the keys for free turning, 5
        // degrees a tap.
        const auto turn = [&](double right_deg) {
            const int notches = static_cast<int>(right_deg / 22.5),
                      rest = static_cast<int>(std::lround((right_deg - 22.5 * notches) / 5.0));
            for (int i = 0; i < std::abs(notches); ++i)
                p.tap(notches > 0 ? Command::TurnRight : Command::TurnLeft, 0.03);
            for (int i = 0; i < std::abs(rest); ++i) p.tap(rest > 0 ? Command::FreeRight : Command::FreeLeft, 0.03);
        };
        int bumps = 0;
        while (!search.over()) {
            p.run(1.0 / 60.0);
            if (const std::size_t shut = p.find("opens it", door); shut < p.lines()) {
                door = shut + 1;
                walk(false);
                p.tap(Command::Use, 0.6);
            }
            std::optional<SoundCue> beat;
            bool bumped = false;
            for (; heard < p.sounds().size(); ++heard) {
                const SoundCue& cue = p.sounds()[heard].cue;
                if (is_beacon(cue.kind)) beat = cue;
                bumped = bumped || cue.kind == SoundKind::Bump;
            }
            if (bumped && walking) {
                // Steps round the obstacle, on alternate sides, and farther each time.
                walk(false);
                turn(++bumps % 2 == 1 ? 90.0 : -90.0);
                p.run(0.6);
                walk(true);
                p.run(0.2 + 0.1 * bumps);
                walk(false);
                heard = p.sounds().size();
                continue;
            }
            if (!beat) continue;
            const Listener& ears = p.ears();
            const Vec3 way = beat->position_m - ears.ears_m;
            const double right_deg =
                5.0 * std::lround(degrees_from_radians(wrap_angle(std::atan2(way.x, way.y) - ears.heading_rad)) / 5.0);
            if (std::abs(right_deg) > 30.0) walk(false);
            turn(right_deg);
            if (std::abs(right_deg) > 30.0) p.run(std::abs(right_deg) / 150.0);
            walk(true);
        }
        walk(false);
        longest_s = std::max(longest_s, search.found());
        if (!search.here()) p.tap(Command::MuteBeacon);
    }
    fmt::print("{} things: walked to each by the beacon from the front door in {:.1f} s at most\n", things.size(),
               longest_s);
}

// Guides the hand from the front door towards the music room upstairs, for half a second.
void lead_to_piano(Explorer& p) {
    const auto& features = p.app().scene()->features;
    const auto piano =
        std::find_if(features.begin(), features.end(), [](const Feature& feature) { return feature.name == "Piano"; });
    ASSERT_TRUE(p.request("Piano", FeatureId{static_cast<std::uint32_t>(piano - features.begin())}, "Take me there"));
    EXPECT_TRUE(p.heard("Taking your hand to Piano")) << p.all_heard(0);
    EXPECT_TRUE(p.heard("The route goes through: Stairs, 2.9 metres up, Music room door.")) << p.all_heard(0);
    p.push();
    p.run(1.5);
    ASSERT_EQ(p.tool().guidance.phase, GuidancePhase::Acts);
}

TEST(TakenAlongAWay, a_hand_gets_a_new_path_when_its_body_walks_off_or_is_moved_and_is_released_when_it_pulls) {
    for (const char* how : {"walks", "home", "pulls"}) {
        Explorer p(test::our_world("house.map"), "sim-t");
        lead_to_piano(p);
        const std::size_t from = p.lines();
        const std::uint32_t first = p.app().guide().path().number;
        if (how == std::string("walks")) {
            p.hold(p.hand_m());
            p.app().apply(CommandDown{Command::Back}, p.now_s());
            p.run(1.5);
            p.app().apply(CommandUp{Command::Back}, p.now_s());
        } else if (how == std::string("home")) {
            p.tap(Command::Home);
        } else {
            p.push({1.6, 0.0, 0.0});
        }
        p.run(3.0);
        if (how == std::string("pulls")) {
            EXPECT_TRUE(p.heard("Guiding stopped", from)) << p.all_heard(from);
            EXPECT_EQ(p.app().guide().path().number, 0U);
            continue;
        }
        EXPECT_FALSE(p.heard("Guiding stopped", from)) << how << ": " << p.all_heard(from);
        EXPECT_TRUE(p.heard("You have left the route. Taking your hand to Piano", from))
            << how << ": " << p.all_heard(from);
        EXPECT_GT(p.app().guide().path().number, first) << how;
        EXPECT_EQ(p.tool().guidance.phase, GuidancePhase::Acts) << how;
    }
}

// When a door opens, the world changes, so both tools must plan again.
TEST(TakenAlongAWay, beacon_and_warmer_are_both_replanned_when_something_moves) {
    Explorer p(test::our_world("house.map"), nullptr);
    const auto& features = p.app().scene()->features;
    for (const auto& [name, tool] : {std::pair{"Piano", "Beacon"}, std::pair{"Desk", "Warmer and colder"}}) {
        const auto thing = std::find_if(features.begin(), features.end(),
                                        [&, wanted = name](const Feature& feature) { return feature.name == wanted; });
        ASSERT_TRUE(p.request(name, FeatureId{static_cast<std::uint32_t>(thing - features.begin())}, tool));
    }
    p.run(1.5);
    const Seek& seek = p.app().guide().seek();
    const auto before = seek.beacon_along().planned_in;
    ASSERT_TRUE(before);
    p.tap(Command::Use, 4.0);
    EXPECT_TRUE(p.heard("Front door opens")) << p.all_heard();
    EXPECT_NE(seek.beacon_along().planned_in, before);
    EXPECT_EQ(seek.beacon_along().planned_in, p.app().scene());
    EXPECT_EQ(seek.warmer_along().planned_in, p.app().scene());
}

// The hand has already bounced off the door while the person hears which door it is. Another door is nearer to the
// walker.
TEST(TakenAlongAWay, a_hand_opens_the_door_that_was_announced_a_moment_ago) {
    Explorer p(test::our_world("house.map"), "sim-t");
    const auto& features = p.app().scene()->features;
    const auto desk =
        std::find_if(features.begin(), features.end(), [](const Feature& feature) { return feature.name == "Desk"; });
    ASSERT_TRUE(p.request("Desk", FeatureId{static_cast<std::uint32_t>(desk - features.begin())}, "Take me there"));
    p.push();
    ASSERT_TRUE(p.wait_for([&] { return p.heard("Study door, wood is shut. Enter opens it."); }, 15.0))
        << p.all_heard(0);
    p.hold(p.hand_m() - Vec3(0.006, 0.0, 0.0));
    ASSERT_EQ(p.tool().contacts.count, 0U);
    const std::size_t from = p.lines();
    p.tap(Command::Use, 0.3);
    EXPECT_TRUE(p.heard("Study door opens", from)) << p.all_heard(from);
}

}  // namespace found_in_the_house_test
}  // namespace handrail
