// Simulates a hand that pushes a crate against a stack, rolls a ball and lifts a plank. Prints the final poses and the
// forces on the hand as exact numbers, so that builds can be compared.
#include <array>
#include <cmath>
#include <cstdio>

#include "haptic/dynamics/dynamics.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"
#include "tests/support/names.h"

using namespace handrail;

int main() {
    const Aabb floor{{-5.0, -5.0, -1.0}, {5.0, 5.0, 0.0}}, crate{Vec3(-0.2), Vec3(0.2)},
        plank{Vec3(-0.5, -0.1, -0.02), Vec3(0.5, 0.1, 0.02)};
    const SphereShape ball{Vec3(0.0), 0.1};
    const std::array starts{Vec3(0.0, 0.0, 0.2), Vec3(0.6, 0.02, 0.2), Vec3(0.62, -0.03, 0.6), Vec3(1.3, 0.0, 0.1),
                            Vec3(0.61, 0.0, 0.82)};
    HapticSceneBuilder felt, box, round, board;
    box.add_box(crate, {FeatureId{2}});
    round.add_sphere(ball, {FeatureId{3}});
    board.add_box(plank, {FeatureId{4}});
    felt.add_box(floor, {FeatureId{1}});
    const auto box_shape = box.build(), round_shape = round.build(), board_shape = board.build();
    DynamicsSceneBuilder moves;
    moves.add_fixed_box(floor, FeatureId{1});
    for (std::uint32_t i = 0; i < starts.size(); ++i) {
        const FeatureId feature{10 + i};
        const Placement at{starts[i], {}, 1.0};
        felt.add_body(feature, i == 3 ? round_shape : i == 4 ? board_shape : box_shape, at);
        const DynamicsPiece piece = i == 3 ? make_piece(RoundShape(ball)) : make_box_piece(i == 4 ? plank : crate);
        BodyNature nature;
        nature.mass_kg = 0.5 + i;
        if (moves.add_body(std::span(&piece, 1), feature, i, at, nature) != BodyFault::None) return 1;
    }
    const auto scene = felt.build();
    const auto moving = moves.build();
    Dynamics engine(moving);
    TouchState state;
    TouchTuning tuning;
    tuning.radius_m = 0.04;
    tuning.world_m_per_hand_m = 20.0;
    tuning.damping_ns_per_m = 5.0;
    tuning.default_friction_static = tuning.default_friction_kinetic = 0.3;
    BodyFeel feel;
    feel.world_m_per_hand_m = tuning.world_m_per_hand_m;
    feel.proxy_radius_m = tuning.radius_m;
    BodiesInReach bodies(0);
    bodies.enter(moving.get());
    HandPushRing pushes;
    std::vector<BodyPose> poses;
    for (const HapticBody& body : scene->bodies) poses.push_back({body.start, true});
    std::uint64_t number = 1;
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    for (int tick = 0; tick < 4000; ++tick) {
        const double now_s = Dynamics::kStep_s + 1e-3 * tick, t = 1e-3 * tick;
        const Vec3 hand_m(-0.3 + 0.35 * t, 0.05 * std::round(10.0 * t) / 10.0,
                          tick < 3000 ? 0.15 : 0.15 + 0.2 * (t - 3.0));
        bodies.hear(frame);
        if (bodies.place(now_s, hand_m, feel, poses)) ++number;
        if (tick == 3000) bodies.take(now_s, hand_m, feel);
        const TouchResult touch = touch_tick(state, *scene, tuning, hand_m, 1e-3, bodies.carried_m(), {poses, number});
        const Vec3 force_n = touch.force_n + bodies.grip_force_n(hand_m, 1e-3, feel);
        bodies.react(touch, 1.0, now_s, 1e-3, feel, pushes);
        engine.place_hand(0, {hand_m, feel.proxy_radius_m, 0.0});
        for (HandPush push; pushes.pop(push);) engine.push(0, push);
        while (engine.time_s() + Dynamics::kStep_s <= now_s + 1e-3) engine.step(frame, events);
        if (tick % 40 != 0) continue;
        std::printf("%d %a %a %a", tick, force_n.x, force_n.y, force_n.z);
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const Vec3& at = frame.things[i].position_m;
            std::printf(" %a %a %a", at.x, at.y, at.z);
        }
        std::printf("\n");
    }
    return 0;
}
