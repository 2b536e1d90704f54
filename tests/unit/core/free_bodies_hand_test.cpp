// Tests the hand of a device with freely movable bodies, in the whole program on a virtual clock. The hand pushes,
// grips, turns, drops and feels the bodies, and the session announces what happens.
#include <fstream>
#include <iterator>
#include <random>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/core/explorer.h"

namespace handrail {
namespace free_bodies_hand_test {

using test::box_brush;
using test::entity;
using test::key;

std::shared_ptr<const Scene> hall(const std::string& entities) {
    const std::string room = test::room_brushes(0, 0, 0, 256, 256, 128);
    const std::string base = entity("info_player_start", key("origin", "128 32 24") + key("angle", "90"));
    auto scene = read_quake_map(
        entity("worldspawn", key("message", "Hall") + key("building", "1"), room) + base + entities, "hall.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    return std::make_shared<const Scene>(std::move(*scene));
}

// Returns the map text of a box of half a metre on the floor, with its middle this far east and north.
std::string box(const std::string& name, double kg, double east_m, double north_m) {
    const double x = 32.0 * east_m, y = 32.0 * north_m;
    return entity("thing", key("cs_name", "dynamic_box") + key("name", name) + key("mass", std::to_string(kg)),
                  box_brush(x - 8, y - 8, 0, x + 8, y + 8, 16));
}
std::string ball(const std::string& name, double east_m, double north_m) {
    const double x = 32.0 * east_m, y = 32.0 * north_m;
    return entity("thing", key("cs_name", "dynamic_sphere") + key("name", name) + key("mass", "1"),
                  box_brush(x - 6, y - 6, 0, x + 6, y + 6, 12));
}

// Returns settings without the desk, because a random hand would move its sliders.
Settings without_a_desk() {
    Settings settings;
    settings.desk.use = false;
    return settings;
}

struct Hand : test::Explorer {
    explicit Hand(std::shared_ptr<const Scene> scene) : Explorer(std::move(scene), "sim-t", without_a_desk()) {}
    explicit Hand(const std::string& entities) : Hand(hall(entities)) {}
    // Moves the device so that its point is at `world_m` in the world.
    void to(const Vec3& world_m, double speed_m_per_s = 0.05) {
        const HandOutput reported = app().hand();
        hold((world_m - reported.pose.origin_m) / reported.tuning.touch.world_m_per_hand_m, speed_m_per_s);
    }
    Vec3 at(const std::string& name) { return app().thing_at(name).value_or(Placement{}).position_m; }
    Rotation turned(const std::string& name) { return app().thing_at(name).value_or(Placement{}).rotation; }
};

TEST(HandOnBodies, no_physics_engine_runs_for_a_hand_if_no_body_is_free) {
    Hand hand("");
    EXPECT_EQ(hand.app().hand().engine, nullptr);
    EXPECT_EQ(hand.app().free_bodies().engine(), nullptr);
}

TEST(HandOnBodies, a_pushed_crate_moves_along_and_does_so_bit_identically_each_time) {
    std::array<Placement, 2> ends;
    std::array<Vec3, 2> forces;
    for (int run = 0; run < 2; ++run) {
        Hand hand(box("Crate", 2.0, 4.0, 2.5));
        hand.to({4.0, 1.9, 0.25});
        hand.to({4.1, 3.0, 0.3}, 0.004);
        forces[run] = hand.tool().force_n;
        hand.to({4.1, 2.0, 0.3}, 0.02);
        hand.run(1.0);
        ends[run] = hand.app().thing_at("Crate").value_or(Placement{});
        EXPECT_GT(ends[run].position_m.y, 2.9);
        EXPECT_NEAR(ends[run].position_m.z, 0.25, 3e-3);
        EXPECT_TRUE(hand.heard("Crate"));
    }
    EXPECT_EQ(ends[0], ends[1]);
    EXPECT_EQ(forces[0], forces[1]);
}

TEST(HandOnBodies, the_key_grips_the_touched_body_turns_it_and_releases_it) {
    Hand hand(box("Crate", 1.0, 4.0, 2.5));
    hand.to({4.0, 1.9, 0.25});
    hand.to({4.0, 2.16, 0.25}, 0.01);
    ASSERT_TRUE(hand.tool().touches());
    hand.tap(Command::Use, 0.2);
    EXPECT_TRUE(hand.heard("Crate held, 1 kilogram.")) << hand.all_heard();
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), hand.app().world().scene->bodies[0].feature);
    hand.to({4.0, 2.16, 1.0}, 0.005);
    hand.run(4.0);
    EXPECT_NEAR(hand.at("Crate").z, 0.25 + 0.75, 0.2) << "lifted, and its weight draws at the grip";
    hand.tap(Command::WorkspaceTurnLeft, 2.0);
    EXPECT_TRUE(hand.heard("A quarter turn to the left."));
    const Rotation turned = hand.turned("Crate");
    EXPECT_NEAR(std::abs(turned.w), std::sqrt(0.5), 0.05) << turned.w << " " << turned.z;
    hand.tap(Command::Use, 0.2);
    EXPECT_TRUE(hand.heard("Crate released."));
    hand.run(1.5);
    EXPECT_NEAR(hand.at("Crate").z, 0.25, 0.01);
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), kNoFeature);
}

TEST(HandOnBodies, a_body_gripped_in_one_world_is_not_gripped_in_the_next) {
    Hand hand(box("Crate", 1.0, 4.0, 2.5));
    hand.to({4.0, 1.9, 0.25});
    hand.to({4.0, 2.16, 0.25}, 0.01);
    hand.tap(Command::Use, 0.2);
    ASSERT_TRUE(hand.heard("Crate held, 1 kilogram.")) << hand.all_heard();
    hand.app().apply(WorldEntered{make_ready(hall(box("Barrel", 1.0, 6.0, 6.0)))}, hand.now_s());
    hand.run(1.0);
    EXPECT_FALSE(hand.heard("Barrel held")) << hand.all_heard();
    EXPECT_FALSE(hand.heard("Barrel let go")) << hand.all_heard();
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), kNoFeature);
}

TEST(HandOnBodies, a_ball_on_a_rubber_string_hangs_pulls_back_and_swings_home) {
    const std::string hook = entity("info_null", key("origin", "192 96 48") + key("targetname", "hook"));
    Hand hand(hook + entity("thing",
                            key("cs_name", "dynamic_sphere") + key("name", "Ball") + key("mass", "0.3") +
                                key("string", "hook") + key("stiffness_n_per_m", "20"),
                            box_brush(186, 90, 42, 198, 102, 54)));
    hand.run(12.0);
    const double hangs_m = 1.5 - 0.3 * 9.81 / 20.0;
    EXPECT_NEAR(hand.at("Ball").z, hangs_m, 0.03) << "the weight of 0.3 kg draws a string of 20 N/m 15 cm long";
    hand.to({6.0, 1.6, hangs_m});
    hand.to({6.0, 2.5, hangs_m});
    hand.to({6.0, 3.2, hangs_m}, 0.005);
    hand.run(1.0);
    // The hand is more than half a metre to the north, so the string pulls with about 10 N. The hand feels a twentieth
    // of that.
    EXPECT_LT(hand.tool().force_n.y, -0.2);
    const double pulled_m = hand.at("Ball").y - 3.0;
    EXPECT_NEAR(-hand.tool().force_n.y * 20.0, 20.0 * pulled_m, 0.25 * 20.0 * pulled_m);
    hand.to({5.0, 1.0, 0.6}, 0.2);
    hand.run(20.0);
    EXPECT_NEAR(glm::length(hand.at("Ball") - Vec3(6.0, 3.0, hangs_m)), 0.0, 0.1);
}

TEST(HandOnBodies, a_body_that_is_too_heavy_slips_out_of_the_grip_and_its_weight_is_announced) {
    Hand hand(box("Safe", 20.0, 4.0, 2.5));
    hand.to({4.0, 1.9, 0.25});
    hand.to({4.0, 2.16, 0.25}, 0.01);
    hand.button(true);
    EXPECT_TRUE(hand.heard("Safe held, 20 kilograms.")) << hand.all_heard();
    hand.to({4.0, 2.16, 3.4}, 0.02);
    hand.run(0.5);
    EXPECT_TRUE(hand.heard("Safe. Heavy, 20 kilograms.")) << hand.all_heard();
    EXPECT_LT(hand.at("Safe").z, 0.4);
    EXPECT_EQ(hand.app().free_bodies().held_by_hand(0), kNoFeature);
}

TEST(HandOnBodies, a_crate_that_falls_on_the_hand_is_felt) {
    Hand hand(box("Crate", 2.0, 4.0, 1.8));
    hand.to({6.0, 3.0, 1.0});
    hand.tap(Command::Use, 0.3);  // The Use key takes hold of what is in front of the walker.
    ASSERT_TRUE(hand.heard("Crate held, 2 kilograms.")) << hand.all_heard();
    for (int i = 0; i < 6; ++i) hand.tap(Command::TiltUp, 0.8);
    ASSERT_GT(hand.at("Crate").z, 1.2);
    hand.to({hand.at("Crate").x, hand.at("Crate").y, 0.6}, 0.02);
    ASSERT_FALSE(hand.tool().touches());
    hand.tap(Command::Use, 0.0);
    double felt_n = 0.0;
    for (int i = 0; i < 1000; ++i) {
        hand.run(1e-3);
        felt_n = std::max(felt_n, -hand.tool().force_n.z);
    }
    EXPECT_GT(felt_n, 0.5);
    EXPECT_LE(felt_n, 2.5 + 1e-9);
    EXPECT_TRUE(hand.heard("Crate released."));
}

TEST(HandOnBodies, random_pushes_grips_and_drops_keep_all_bodies_in_the_hall_and_force_below_the_ceiling) {
    const std::uint32_t seed = test::seed_of_run();
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::string things;
    for (int i = 0; i < 12; ++i) {
        const double east = 1.5 + 1.6 * (i % 4), north = 2.2 + 1.8 * (i / 4);
        const std::string name = "Thing " + std::to_string(i);
        things += i % 3 == 0 ? ball(name, east, north) : box(name, 0.3 + 20.0 * part(random), east, north);
    }
    Hand hand(things);
    const char* const all = std::getenv("HANDRAIL_ACTS");
    const int acts = all ? std::atoi(all) : test::scaled(60);
    int held = 0;
    double most_n = 0.0;
    bool down = false;
    for (int act = 0; act < acts; ++act) {
        const Vec3 thing = hand.at("Thing " + std::to_string(static_cast<int>(part(random) * 12)));
        const Vec3 beside = 0.6 * Vec3(part(random) - 0.5, part(random) - 0.5, 0.5 * part(random));
        hand.to(part(random) < 0.6 ? thing + beside : Vec3(1.0 + 6.0 * part(random), 1.0 + 5.0 * part(random), 1.0),
                0.01 + 0.06 * part(random));
        most_n = std::max(most_n, glm::length(hand.tool().force_n));
        if (part(random) < 0.5) hand.button(down = !down);
        if (part(random) < 0.2) hand.tap(Command::Use);
        if (part(random) < 0.1) hand.tap(Command::WorkspaceTurnRight);
        if (part(random) < 0.05) hand.tap(Command::PutBack);
        held += hand.tool().holds != kNoBody;
        for (int i = 0; i < 12; ++i) {
            const Vec3 at = hand.at("Thing " + std::to_string(i));
            ASSERT_TRUE(at.x > 0.0 && at.x < 8.0 && at.y > 0.0 && at.y < 8.0 && at.z > 0.0 && at.z < 4.0)
                << "act " << act << ", thing " << i << " at " << at.x << " " << at.y << " " << at.z;
        }
    }
    EXPECT_LE(most_n, 2.5 + 1e-9);
    fmt::print("{} acts, something held after {} of them\n", acts, held);
    EXPECT_TRUE(held > 0 || acts < 1000);
}

// Twenty things are in sight of the start of a building. A random person walks, pushes, grips, turns and drops things
// with hand and keys. HANDRAIL_ACTS sets the number of acts in each building.
constexpr int kThings = 20;

std::string name_of(int thing) { return "Thing " + std::to_string(thing); }

// Returns the map with this many things around its start, none of them inside another thing or a wall. Returns an empty
// text if there is not enough room.
std::string among_things(const std::string& map, const WalkerWorld& bare, std::mt19937_64& random) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const Vec3 eye = bare.scene().starts.at(0).feet_m + Vec3(0.0, 0.0, 1.0);
    std::vector<Vec3> places;
    std::string text = map;
    for (int tries = 0; tries < 20000 && std::ssize(places) < kThings; ++tries) {
        // There is one statement for each number, so that every compiler evaluates them in the same order.
        const double north = part(random), east = part(random);
        const Vec3 at = eye + Vec3(14.0 * (east - 0.5), 14.0 * (north - 0.5), -0.3);
        if (glm::length(at - eye) < 1.0 || bare.trace(eye, at, {}).hit) continue;
        const TraceHit floor = bare.trace(at, at - Vec3(0.0, 0.0, 3.0), {});
        const Vec3 feet = floor.end_m + Vec3(0.0, 0.0, 0.01);
        if (!floor.hit || bare.blocked(feet, {0.22, 0.4})) continue;
        if (std::any_of(places.begin(), places.end(), [&](const Vec3& one) { return glm::length(one - at) < 0.5; }))
            continue;
        const int thing = static_cast<int>(places.size());
        places.push_back(at);
        const Vec3 low = 32.0 * (feet - Vec3(0.15, 0.15, 0.0)), high = low + Vec3(9.6);
        text += entity("thing",
                       key("cs_name", thing % 3 == 0 ? "dynamic_sphere" : "dynamic_box") + key("name", name_of(thing)) +
                           key("mass", std::to_string(0.3 + 20.0 * part(random) * part(random))),
                       box_brush(low.x, low.y, low.z, high.x, high.y, high.z));
    }
    return std::ssize(places) == kThings ? text : std::string();
}

struct Among : Hand {
    Among(std::shared_ptr<const Scene> scene, const WalkerWorld& bare) : Hand(std::move(scene)), bare_(bare) {
        forget();
    }
    // Stores the present positions of the things for later comparison.
    void forget() {
        for (int i = 0; i < kThings; ++i) were_m_[i] = at(name_of(i));
    }
    void watched(double seconds) {
        for (const double until = now_s() + seconds; now_s() < until - 1e-9;) {
            run(1.0 / 60.0);
            look();
        }
    }
    void moved(Vec3 target_m, double speed_m_per_s) {
        target_m = glm::clamp(target_m, Vec3(-0.07, -0.05, -0.05), Vec3(0.07, 0.05, 0.05));
        while (!::testing::Test::HasFailure()) {
            const Vec3 way = target_m - at_m();
            const double far = glm::length(way), step = speed_m_per_s / 60.0;
            if (far < 1e-6) return;
            hold(far <= step ? target_m : at_m() + way * (step / far), speed_m_per_s);
            look();
        }
    }
    void key_down(Command command, double seconds) {
        app().apply(CommandDown{command}, now_s());
        watched(seconds);
        app().apply(CommandUp{command}, now_s());
    }
    double most_n() const { return most_n_; }

private:
    // Returns true for doors and lifts, which also move in the building without things.
    bool moves(FeatureId feature) const {
        const std::vector<Mover>& all = bare_.scene().movers;
        return std::any_of(all.begin(), all.end(), [&](const Mover& one) { return one.feature == feature; });
    }
    void look() {
        most_n_ = std::max(most_n_, glm::length(tool().force_n));
        for (int i = 0; i < kThings; ++i) {
            const Vec3 now = at(name_of(i)), was = std::exchange(were_m_[i], now);
            if (now == was) continue;
            const TraceHit wall = bare_.trace(was, now, {}, true);
            EXPECT_FALSE(wall.hit && !moves(wall.feature))
                << name_of(i) << " went from " << was.x << " " << was.y << " " << was.z << " to " << now.x << " "
                << now.y << " " << now.z << " through " << bare_.scene().features[wall.feature.value].name;
        }
    }
    const WalkerWorld& bare_;
    std::array<Vec3, kThings> were_m_;
    double most_n_ = 0.0;
};

void lives_among_things(const std::filesystem::path& file) {
    const std::uint32_t seed = test::seed_of_run();
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::ifstream in(file, std::ios::binary);
    const std::string map{std::istreambuf_iterator<char>(in), {}};
    auto read = read_quake_map(map, "building.map", {});
    ASSERT_TRUE(read);
    read->placed.clear();
    const WalkerWorld bare(std::make_shared<const Scene>(std::move(*read)));
    const char* const all = std::getenv("HANDRAIL_ACTS");
    const int acts = all ? std::atoi(all) : test::scaled(40);
    int held = 0;
    double walked_m = 0.0, rolled_m = 0.0, most_n = 0.0;
    bool down = false;
    std::unique_ptr<Among> is_here;
    for (int act = 0; act < acts; ++act) {
        if (act % 100 == 0) {  // Places the walker at the start again, because it may have walked away from all things.
            const std::string text = among_things(map, bare, random);
            ASSERT_FALSE(text.empty()) << "no room for the things";
            auto scene = read_quake_map(text, "building.map", {});
            ASSERT_TRUE(scene);
            is_here = std::make_unique<Among>(std::make_shared<const Scene>(std::move(*scene)), bare);
            ASSERT_GE(is_here->app().world().scene->bodies.size(), static_cast<std::size_t>(kThings));
            down = false;
        }
        Among& here = *is_here;
        SCOPED_TRACE("seed " + std::to_string(seed) + ", act " + std::to_string(act));
        const Vec3 feet = here.app().feet_m(), was = here.at(name_of(act % kThings));
        const double what = part(random);
        if (what < 0.45) {
            const Vec3 thing = here.at(name_of(static_cast<int>(part(random) * kThings)));
            const HandOutput reported = here.app().hand();
            const Vec3 there = (thing - reported.pose.origin_m) / reported.tuning.touch.world_m_per_hand_m;
            const double z = part(random), y = part(random), x = part(random);
            const Vec3 anywhere = 0.14 * (Vec3(x, y, z) - Vec3(0.5));
            here.moved(glm::length(there) < 0.1 ? there : anywhere, 0.05 + 0.1 * part(random));
        } else if (what < 0.65) {
            const double for_s = 0.2 + 0.8 * part(random);
            here.key_down(part(random) < 0.8 ? Command::Forward : Command::Back, for_s);
        } else if (what < 0.75) {
            const double for_s = 0.1 + 0.4 * part(random);
            here.key_down(part(random) < 0.5 ? Command::TurnLeft : Command::TurnRight, for_s);
        } else if (what < 0.85) {
            here.button(down = !down);
        } else if (what < 0.95) {
            here.tap(Command::Use);
        } else if (what < 0.98) {
            here.tap(part(random) < 0.5 ? Command::TiltUp : Command::WorkspaceTurnRight);
        } else {
            here.tap(Command::PutBack);
            here.forget();
        }
        here.watched(0.1);
        most_n = std::max(most_n, here.most_n());
        held += here.tool().holds != kNoBody;
        walked_m += glm::length(here.app().feet_m() - feet);
        rolled_m += glm::length(here.at(name_of(act % kThings)) - was);
        if (::testing::Test::HasFailure()) return;
    }
    EXPECT_LE(most_n, 2.5 + 1e-9);
    fmt::print(
        "{}: seed {}, {} acts, held after {} of them, walked {:.0f} m, things moved {:.1f} m in the acts looked at\n",
        file.filename().string(), seed, acts, held, walked_m, rolled_m);
    EXPECT_GT(walked_m, acts * 0.01) << "nobody is stuck";
}

TEST(HandAmongThings, in_our_house_no_body_passes_through_a_wall_and_the_walker_is_never_stuck) {
    lives_among_things(test::project_root() / "worlds" / "maps" / "house.map");
}

TEST(HandAmongThings, in_our_school_no_body_passes_through_a_wall_and_the_walker_is_never_stuck) {
    lives_among_things(test::project_root() / "worlds" / "maps" / "school.map");
}

TEST(HandAmongThings, in_e1m1_no_body_passes_through_a_wall_and_the_walker_is_never_stuck) {
    const auto file = test::real_world("quake-e1m1.map");
    if (!file) GTEST_SKIP() << test::needs_real_world("quake-e1m1.map");
    lives_among_things(*file);
}

}  // namespace free_bodies_hand_test
}  // namespace handrail
