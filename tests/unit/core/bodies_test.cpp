// Tests how the session reads the engine of free bodies and what it sends to it. The engine here only does what a test
// tells it to, so each limit is met from both sides: jitter, rest, reach, push, obstruction and hits.
#include "app/core/bodies/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace bodies_test {

using test::box_brush;
using test::entity;
using test::key;

constexpr double kFrame_s = 1.0 / 60.0;

// What a test gives the engine, and what the session sent to it.
struct Script {
    render::DynamicsFrame frame;
    bool newer = false;
    std::deque<render::BodyEvent> events;
    std::vector<dynamics::BodyEngine::Order> shoves;
};

class ScriptedEngine : public dynamics::BodyEngine {
public:
    explicit ScriptedEngine(Script& script) : script_(script) {}
    std::shared_ptr<render::HandChannel> hand(unsigned which) const override { return hands_[which]; }
    bool order(const Order& order) override {
        if (order.kind == Order::Kind::Shove) script_.shoves.push_back(order);
        return true;
    }
    void drive(const DrivenPoses&) override {}
    bool newer_frame_for_app() override { return std::exchange(script_.newer, false); }
    const render::DynamicsFrame& frame_for_app() const override { return script_.frame; }
    bool take_event(render::BodyEvent& event) override {
        if (script_.events.empty()) return false;
        event = script_.events.front();
        script_.events.pop_front();
        return true;
    }

private:
    Script& script_;
    std::array<std::shared_ptr<render::HandChannel>, 2> hands_{std::make_shared<render::HandChannel>(),
                                                               std::make_shared<render::HandChannel>()};
};

SessionOptions played_by(Script& script) {
    SessionOptions options;
    options.bodies.played = [&script](const std::shared_ptr<const render::DynamicsScene>&, double) {
        return std::make_unique<ScriptedEngine>(script);
    };
    return options;
}

// A hall of 10 by 20 m with a table in the far corner and one crate of half a metre, whose middle is this far east and
// north. The walker starts at (5, 1), faces north and is a quarter of a metre in radius.
struct Hall : Script, test::AppSession {
    Hall(double east_m, double north_m) : AppSession({}, {}, played_by(*this)) {
        const double x = 32.0 * east_m, y = 32.0 * north_m;
        auto read =
            read_quake_map(entity("worldspawn", key("message", "Hall") + key("building", "1"),
                                  test::room_brushes(0, 0, 0, 320, 640, 128)) +
                               entity("info_player_start", key("origin", "160 32 24") + key("angle", "90")) +
                               entity("thing", key("name", "Table"), box_brush(288, 608, 0, 312, 632, 24)) +
                               entity("thing", key("cs_name", "dynamic_box") + key("name", "Crate") + key("mass", "4"),
                                      box_brush(x - 8, y - 8, 0, x + 8, y + 8, 16)),
                           "hall.map", {});
        EXPECT_TRUE(read);
        app.apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*read)))}, 0.0);
        frame.things.push_back(*app.thing_at("Crate"));
        run(kFrame_s);
        said.clear();
    }
    Placement& crate() { return frame.things.front(); }
    // The engine computed a new frame, which the session reads in the next tick.
    void step() {
        newer = true;
        ++frame.number;
        run(kFrame_s);
    }
    void place(double east_m, double north_m, double heading_rad = 0.0) {
        app.apply(Placed{{east_m, north_m, 0.0}, heading_rad}, now);
        run(kFrame_s);
    }
    // Walks on for one frame.
    void pace() { hold(Command::Forward, kFrame_s); }
    // The crate in the walker's hands hits the table. The place of the hit is in this direction from its middle.
    void hit_table(const Vec3& direction) {
        render::BodyEvent hit;
        hit.time_s = now;
        hit.at_m = crate().position_m + direction * 0.25;
        for (std::uint32_t f = 0; f < app.scene()->features.size(); ++f)
            if (app.scene()->features[f].name == "Table") hit.other = FeatureId{f};
        EXPECT_TRUE(hit.other);
        events.push_back(hit);
        run(kFrame_s);
    }
    // Tries to carry the crate north, which it does not follow, and returns what the session says about it.
    std::string carry() {
        said.clear();
        tap(Command::Forward, 1.0);
        return news();
    }
};

TEST(BodiesOfASession, ignore_jitter_below_a_tenth_of_a_millimetre_and_of_a_milliradian) {
    for (const auto& [shift_m, turn_rad, follows] : {std::tuple(0.8e-4, 0.0, false), std::tuple(1.3e-4, 0.0, true),
                                                     std::tuple(0.0, 0.8e-4, false), std::tuple(0.0, 1.3e-4, true)}) {
        Hall hall(5.0, 6.0);
        const Placement start = hall.crate();
        hall.crate().position_m.x += shift_m;
        hall.crate().rotation = normalized(rotation_about({0.0, 0.0, 1.0}, turn_rad) * hall.crate().rotation);
        hall.step();
        EXPECT_EQ(hall.app.thing_at("Crate") != start, follows) << shift_m << " m, " << turn_rad << " rad";
        EXPECT_EQ(hall.app.free_bodies().any_moving(), follows);
    }
}

TEST(BodiesOfASession, are_at_rest_a_fifth_of_a_second_after_they_last_moved) {
    Hall hall(5.0, 6.0);
    hall.crate().position_m.x += 0.01;
    hall.step();
    hall.run(0.17);
    EXPECT_TRUE(hall.app.free_bodies().any_moving());
    hall.run(0.06);
    EXPECT_FALSE(hall.app.free_bodies().any_moving());
}

TEST(BodiesOfASession, are_pushed_once_they_are_six_centimetres_ahead) {
    for (const auto& [gap_m, pushed] : {std::pair(0.05, true), std::pair(0.08, false)}) {
        Hall hall(5.0, 4.0);
        hall.place(5.0, 4.0 - 0.25 - 0.25 - gap_m);
        hall.pace();
        EXPECT_EQ(!hall.shoves.empty(), pushed) << gap_m;
    }
}

// A push must last until the push of the next frame, even if that frame is late. It must end soon after the walker
// stops.
TEST(BodiesOfASession, are_pushed_for_more_than_two_and_less_than_four_frames_at_a_time) {
    Hall hall(5.0, 4.0);
    hall.place(5.0, 3.46);
    hall.pace();
    ASSERT_FALSE(hall.shoves.empty());
    EXPECT_GT(hall.shoves.front().for_s, 2.1 * kFrame_s);
    EXPECT_LT(hall.shoves.front().for_s, 4.0 * kFrame_s);
    EXPECT_EQ(hall.shoves.front().most_n, FreeBody::kWalkersPush_n);
}

// The crate does not move, or it moves once by `moved_m` after 0.3 s. Returns after how many seconds of pushing the
// walker bumps into it.
double bumps_after_s(double moved_m) {
    Hall hall(5.0, 4.0);
    hall.place(5.0, 3.46);
    hall.app.apply(CommandDown{Command::Forward}, hall.now);
    double since_s = -1.0;
    bool moved = false;
    for (int i = 0; i < 200 && hall.bumped.empty(); ++i) {
        hall.run(kFrame_s);
        if (since_s < 0.0 && !hall.shoves.empty()) since_s = hall.now;
        if (since_s < 0.0 || moved || hall.now - since_s < 0.3) continue;
        moved = true;
        hall.crate().position_m.y += moved_m;
        hall.newer = true;
        ++hall.frame.number;
    }
    EXPECT_FALSE(hall.bumped.empty());
    return hall.now - since_s;
}

TEST(BodiesOfASession, block_the_walker_after_half_a_second_of_pushing_without_progress) {
    EXPECT_NEAR(bumps_after_s(0.0), 0.5, 0.1);
    EXPECT_NEAR(bumps_after_s(0.008), 0.5, 0.1) << "less than a centimetre is no progress";
    EXPECT_NEAR(bumps_after_s(0.013), 0.8, 0.1) << "more is";
}

TEST(BodiesOfASession, are_announced_as_pushed_again_after_a_pause_of_two_seconds) {
    for (const auto& [pause_s, times] : {std::pair(1.6, 1), std::pair(2.5, 2)}) {
        Hall hall(5.0, 4.0);
        hall.place(5.0, 3.46);
        hall.pace();
        hall.run(pause_s);
        hall.pace();
        EXPECT_EQ(std::count(hall.said.begin(), hall.said.end(), "Crate moves with you."), times) << pause_s;
    }
}

TEST(BodiesOfASession, driven_into_the_walker_are_pushed_off_slowly_unless_they_are_underfoot) {
    Hall hall(5.0, 4.0);
    hall.place(5.0, 3.52);
    hall.pace();
    ASSERT_FALSE(hall.shoves.empty());
    EXPECT_NEAR(hall.shoves.front().speed_m_per_s.y, 0.3, 1e-9) << "away from the walker, slower than a walk";
    // The crate comes up through the floor. A walker would step on it in the next frame.
    for (const auto& [top_m, underfoot] : {std::pair(0.008, true), std::pair(0.013, false)}) {
        Hall low(5.0, 6.0);
        low.crate().position_m += Vec3(0.0, -2.0, -1.0);
        low.step();
        low.place(5.0, 3.8, kPi);
        low.crate().position_m.z = top_m - 0.25;
        low.newer = true;
        ++low.frame.number;
        low.pace();
        EXPECT_EQ(low.shoves.empty(), underfoot) << top_m;
    }
}

// The walker stands a little inside the south side of the crate, so only the part of the speed along that side is left.
TEST(BodiesOfASession, are_announced_as_in_the_way_if_less_than_three_tenths_of_the_speed_are_left) {
    for (const auto& [left, announced] : {std::pair(0.25, true), std::pair(0.35, false)}) {
        Hall hall(5.0, 4.0);
        hall.place(5.0, 3.52, std::asin(left));
        hall.pace();
        EXPECT_EQ(!hall.bumped.empty(), announced) << left;
    }
}

// The nearest corner of the crate is 0.6 m away. `ahead` is the cosine between the direction to it and straight ahead.
TEST(BodiesOfASession, are_gripped_ahead_and_well_to_the_side_but_not_abeam) {
    for (const auto& [ahead, gripped] : {std::pair(0.3, true), std::pair(0.2, false)}) {
        Hall hall(5.0 + 0.6 * std::sqrt(1.0 - ahead * ahead) + 0.25, 4.0 + 0.6 * ahead + 0.25);
        hall.place(5.0, 4.0);
        hall.tap(Command::Use);
        EXPECT_EQ(hall.heard("Crate held"), gripped) << ahead;
    }
}

TEST(BodiesOfASession, that_are_carried_name_what_they_hit_in_the_last_three_seconds) {
    for (const auto& [wait_s, named] : {std::pair(2.0, true), std::pair(3.2, false)}) {
        Hall hall(5.0, 4.0);
        hall.place(5.0, 3.0);
        hall.tap(Command::Use);
        ASSERT_TRUE(hall.heard("Crate held"));
        hall.hit_table({0.0, 1.0, 0.0});
        hall.run(wait_s);
        const std::string said = hall.carry();
        EXPECT_EQ(said.find("Crate stopped by Table.") != std::string::npos, named) << wait_s << ": " << said;
        EXPECT_EQ(said.find("Crate cannot go any farther.") != std::string::npos, !named) << said;
    }
}

// `down` is the cosine between the direction to the hit and straight down.
TEST(BodiesOfASession, that_are_carried_name_no_hit_underneath_them) {
    for (const auto& [down, named] : {std::pair(0.7, true), std::pair(0.9, false)}) {
        Hall hall(5.0, 4.0);
        hall.place(5.0, 3.0);
        hall.tap(Command::Use);
        hall.hit_table({0.0, std::sqrt(1.0 - down * down), -down});
        const std::string said = hall.carry();
        EXPECT_EQ(said.find("Crate stopped by Table.") != std::string::npos, named) << down << ": " << said;
    }
}

}  // namespace bodies_test
}  // namespace handrail
