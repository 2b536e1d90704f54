// Makes small worlds with bodies in code. One or two hands touch the bodies in virtual time, with all the code of the
// hand's side.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "haptic/dynamics/dynamics.h"
#include "haptic/loop/closed_loop.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"
#include "tests/support/names.h"

namespace handrail::test {

inline constexpr FeatureId kFloor{1}, kWall{2}, kThing{5};  // feature of body 0; body n has the number kThing + n

inline DynamicsPiece box_of(double half_m) { return make_box_piece({Vec3(-half_m), Vec3(half_m)}); }
inline DynamicsPiece ball_of(double radius_m) { return make_piece(RoundShape(SphereShape{Vec3(0.0), radius_m})); }

// Returns a material that does not bounce and has no rolling friction.
inline BodyNature nature(double kg, double friction = 0.4) {
    BodyNature n;
    n.mass_kg = kg;
    n.friction = n.friction_static = friction;
    n.elasticity = 0.0;
    n.rolling = 0.0;
    return n;
}

// Runs `steps` steps of the engine and discards the events.
inline void run(Dynamics& engine, int steps) {
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    for (int i = 0; i < steps; ++i) engine.step(frame, events);
}

// Returns a push on body 0 for the next step. The caller must still set the force.
inline HandPush push_of(const Dynamics& engine) {
    HandPush push;
    push.time_s = engine.time_s();
    push.dt_s = Dynamics::kStep_s;
    push.body = 0;
    push.game = 1;
    return push;
}

// Builds one world twice: as a scene for touch and as a scene for dynamics.
class BodyWorldMaker {
public:
    explicit BodyWorldMaker(const Vec3& origin_m = Vec3(0.0)) : bodies_(origin_m) {}

    void box(const Aabb& box_m, FeatureId feature = kFloor) {
        felt_.add_box(box_m, {feature});
        bodies_.add_fixed_box(box_m, feature);
    }
    void floor(const Vec3& at = Vec3(0.0)) { box({at + Vec3(-50, -50, -1), at + Vec3(50, 50, 0)}); }
    // Adds a box or ball. Its feature is kThing plus the body's number.
    std::uint32_t body(const DynamicsPiece& piece, const Vec3& at_m, const BodyNature& nature) {
        const FeatureId feature{kThing.value + count_};
        HapticSceneBuilder own;
        if (const auto* ball = std::get_if<SphereShape>(&piece.round)) own.add_sphere(*ball, {feature});
        else own.add_box(piece.bounds_m, {feature});
        felt_.add_body(feature, own.build(), {at_m, {}, 1.0});
        EXPECT_EQ(bodies_.add_body(std::span(&piece, 1), feature, count_, {at_m, {}, 1.0}, nature), BodyFault::None);
        return count_++;
    }
    DynamicsSceneBuilder& dynamics() { return bodies_; }

    std::shared_ptr<const HapticScene> felt() { return felt_.build(); }
    std::shared_ptr<const DynamicsScene> moves() { return bodies_.build(); }

private:
    HapticSceneBuilder felt_;
    DynamicsSceneBuilder bodies_;
    std::uint32_t count_ = 0;
};

struct HandSetup {
    double scale = 20.0;
    double gain = 1.0 / 20.0;
    double stiffness_n_per_m = 800.0, damping_ns_per_m = 5.0, friction = 0.0;
    double grip_n_per_m = 400.0, grip_ns_per_m = 5.0;
    double ceiling_n = 1e9;
    int latency_ticks = 1;  // ticks from the end of an engine's step until its frame reaches the hand
    Vec3 origin_m{0.0};     // place in the world where the hand's origin is
};

// A hand that touches the bodies of an engine. Several hands may share the engine.
class Hand {
public:
    Hand(unsigned number, std::shared_ptr<const HapticScene> felt, const DynamicsScene& moves, const HandSetup& as)
        : setup(as), number_(number), felt_(std::move(felt)), bodies_(number) {
        tuning_.radius_m = 0.002 * setup.scale;
        tuning_.world_m_per_hand_m = setup.scale;
        tuning_.override_stiffness_n_per_m = setup.stiffness_n_per_m;
        tuning_.damping_ns_per_m = setup.damping_ns_per_m;
        tuning_.override_friction_static = tuning_.override_friction_kinetic = setup.friction;
        feel_ = {setup.scale, setup.gain, setup.ceiling_n, tuning_.radius_m, setup.grip_n_per_m, setup.grip_ns_per_m};
        for (const HapticBody& body : felt_->bodies) poses_.push_back({body.start, body.present});
        bodies_.enter(&moves);
    }

    // Gives the hand the engine's latest frame. If several hands tick at the same time, the test must call this for all
    // of them before their ticks.
    void hear(const DynamicsFrame& frame) { bodies_.hear(frame); }
    Vec3 tick(const Vec3& hand_m, double now_s, double dt_s) {
        const Vec3 goal = setup.origin_m + hand_m * setup.scale;
        if (bodies_.place(now_s, goal, feel_, poses_)) ++poses_number_;
        if (want_grip && bodies_.holds() == kNoBody) bodies_.take(now_s, goal, feel_);
        if (!want_grip && bodies_.holds() != kNoBody) bodies_.let_go(feel_);
        touch = touch_tick(state_, *felt_, tuning_, goal, dt_s, bodies_.carried_m(), {poses_, poses_number_});
        force_n = touch.force_n + bodies_.grip_force_n(goal, dt_s, feel_);
        const double is = glm::length(force_n), share = is > setup.ceiling_n ? setup.ceiling_n / is : 1.0;
        force_n *= share;
        place = {goal, tuning_.radius_m, now_s};
        bodies_.react(touch, share, now_s, dt_s, feel_, pushes);
        return force_n;
    }
    void send_to(Dynamics& engine) {
        engine.place_hand(number_, place);
        HandPush push;
        while (pushes.pop(push)) engine.push(number_, push);
    }

    BodiesInReach& bodies() { return bodies_; }
    std::vector<BodyPose>& poses() { return poses_; }

    HandSetup setup;
    bool want_grip = false;
    TouchResult touch;
    Vec3 force_n{0.0};
    HandPlace place;
    HandPushRing pushes;

private:
    unsigned number_;
    std::shared_ptr<const HapticScene> felt_;
    BodiesInReach bodies_;
    TouchState state_;
    TouchTuning tuning_;
    BodyFeel feel_;
    std::vector<BodyPose> poses_;
    std::uint64_t poses_number_ = 1;
};

// An engine and its hands on one clock. A tick is one millisecond.
class BodyRig {
public:
    BodyRig(BodyWorldMaker& maker, const std::vector<HandSetup>& setups)
        : moves(maker.moves()), engine(moves), latency_(setups.front().latency_ticks) {
        const auto felt = maker.felt();
        for (unsigned i = 0; i < setups.size(); ++i)
            hands.push_back(std::make_unique<Hand>(i, felt, *moves, setups[i]));
        engine.step(frame_, events);  // computes the first frame, so that each hand knows all bodies when it arrives
        heard_ = frame_;
    }

    // Renders hand i at `hand_m`. Returns its force in newtons. Rendering the last hand also advances the engine.
    Vec3 render(std::size_t i, const Vec3& hand_m, double dt_s = 1e-3) {
        Hand& hand = *hands[i];
        if (i == 0)
            while (!under_way_.empty() && under_way_.front().first <= tick_) {
                heard_ = under_way_.front().second;
                under_way_.erase(under_way_.begin());
            }
        hand.hear(heard_);
        const Vec3 force = hand.tick(hand_m, now_s(), dt_s);
        if (i + 1 == hands.size()) {
            for (auto& each : hands) each->send_to(engine);
            ++tick_;
            while (engine.time_s() + Dynamics::kStep_s <= now_s() + 1e-9) {
                engine.step(frame_, events);
                under_way_.emplace_back(tick_ + latency_ - 1, frame_);
            }
        }
        return force;
    }
    double now_s() const { return start_s_ + 1e-3 * static_cast<double>(tick_); }

    std::shared_ptr<const DynamicsScene> moves;
    Dynamics engine;
    std::vector<std::unique_ptr<Hand>> hands;
    std::vector<BodyEvent> events;

private:
    int latency_;
    long tick_ = 0;
    double start_s_ = Dynamics::kStep_s;
    DynamicsFrame frame_, heard_;
    std::vector<std::pair<long, DynamicsFrame>> under_way_;
};

inline LoopSettings light_hand(double grip_ns_per_m = 1.0, double spring_n_per_m = 300.0) {
    LoopSettings s;
    s.hand.mass_kg = 0.4;
    s.hand.damping_ns_per_m = grip_ns_per_m + 0.2;
    s.hand.spring_n_per_m = spring_n_per_m;
    return s;
}

}  // namespace handrail::test
