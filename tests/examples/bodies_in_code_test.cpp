// Makes a world with movable bodies in code. A simulated hand pushes and lifts them. docs/developer/examples.md
// describes this example.
#include <algorithm>

#include "haptic/dynamics/dynamics.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"

namespace handrail {
namespace bodies_in_code_test {
using namespace dynamics;
using namespace render;
using namespace servo;

// A floor with a crate of one kilogram on it, as one scene for touch and one for dynamics.
struct CrateWorld {
    std::shared_ptr<const HapticScene> felt;
    std::shared_ptr<const DynamicsScene> moves;
};
CrateWorld crate_world() {
    const Aabb floor{{-5.0, -5.0, -1.0}, {5.0, 5.0, 0.0}}, crate{Vec3(-0.2), Vec3(0.2)};
    const Placement start{{0.0, 0.0, 0.2}, {}, 1.0};
    HapticSceneBuilder shape, felt;
    shape.add_box(crate, {FeatureId{2}});
    felt.add_box(floor, {FeatureId{1}});
    felt.add_body(FeatureId{2}, shape.build(), start);  // index 0: the body's index in the scene for touch

    DynamicsSceneBuilder moves;
    moves.add_fixed_box(floor, FeatureId{1});
    BodyNature nature;
    nature.mass_kg = 1.0;
    nature.friction = nature.friction_static = 0.4;
    const DynamicsPiece piece = make_box_piece(crate);
    if (moves.add_body(std::span(&piece, 1), FeatureId{2}, 0, start, nature) != BodyFault::None) return {};
    return {felt.build(), moves.build()};
}

// Moves the hand to the east at 20 mm/s for a second, so that it pushes the crate. One metre of the hand is 20 metres
// in the world. Runs 1,000 ticks of the hand and 240 steps of the engine. Returns the force at the end in newtons.
double push_east(const CrateWorld& world, Dynamics& engine) {
    TouchState state;
    TouchTuning tuning;
    tuning.radius_m = 0.04;  // 4 cm in the world, 2 mm in the hand's workspace
    tuning.world_m_per_hand_m = 20.0;
    tuning.damping_ns_per_m = 5.0;
    BodyFeel feel;
    feel.world_m_per_hand_m = tuning.world_m_per_hand_m;
    feel.proxy_radius_m = tuning.radius_m;

    BodiesInReach bodies(0);  // the index of this hand; a world has up to two
    bodies.enter(world.moves.get());
    HandPushRing pushes;
    std::vector<BodyPose> poses{{world.felt->bodies[0].start, true}};
    std::uint64_t number = 1;
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    double felt_n = 0.0;
    for (int tick = 0; tick < 1000; ++tick) {
        const double now_s = Dynamics::kStep_s + 1e-3 * tick;
        const Vec3 hand_m(-0.25 + 0.4 * (now_s - Dynamics::kStep_s), 0.0, 0.1);
        // One tick of the hand, as the servo thread runs it.
        bodies.hear(frame);
        if (bodies.place(now_s, hand_m, feel, poses)) ++number;
        const TouchResult touch =
            touch_tick(state, *world.felt, tuning, hand_m, 1e-3, bodies.carried_m(), {poses, number});
        felt_n = std::min(glm::length(touch.force_n), feel.ceiling_n);
        bodies.react(touch, felt_n / std::max(1e-9, glm::length(touch.force_n)), now_s, 1e-3, feel, pushes);
        // One step of the engine, as DynamicsLoop runs it on its own thread.
        engine.place_hand(0, {hand_m, feel.proxy_radius_m, now_s});
        for (HandPush push; pushes.pop(push);) engine.push(0, push);
        while (engine.time_s() + Dynamics::kStep_s <= now_s + 1e-3) engine.step(frame, events);
    }
    return felt_n;
}

TEST(Example, a_crate_made_in_code_is_pushed_by_a_simulated_hand) {
    const CrateWorld world = crate_world();
    ASSERT_TRUE(world.moves);
    Dynamics engine(world.moves);
    const double felt_n = push_east(world, engine);
    // The force is the friction under the crate's weight, divided by the world scale of 20.
    EXPECT_NEAR(felt_n, 0.4 * 1.0 * 9.81 / 20.0, 0.06);
    // The second number is the distance by which the proxy pushed the crate.
    EXPECT_NEAR(engine.middle(0).position_m.x, -0.25 + 0.4 + 0.24, 0.02);
    EXPECT_NEAR(engine.middle(0).position_m.z, 0.2, 1e-3);
}

}  // namespace bodies_in_code_test
}  // namespace handrail
