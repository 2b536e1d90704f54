// Measures what a hand feels of a moving object, with three methods:
// - the servo's model of the object (our own method)
// - interpolated poses of the engine
// - interpolated poses, with the force on the object damped as by a virtual coupling (Colgate and others, "Issues in
//   the haptic display of tool use", 1995)
// A hand that follows a prescribed path exactly pushes a ball on a rubber string to and fro for ten loops. A formula
// gives the force that it should feel.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "haptic/dynamics/dynamics.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"
#include "tests/bench/compare/bench.h"
#include "tests/support/names.h"

namespace handrail::bench {
namespace {

constexpr double kScale = 20.0, kGain = 1.0 / 20.0;  // world metres per hand metre; hand newtons per world newton
constexpr double kHand_n_per_m = 800.0;              // stiffness of the contact
constexpr double kString_n_per_m = 50.0, kBall_m = 0.2;
constexpr double kMiddle_m = 6e-3, kSwing_m = 3e-3, kLoop_s = 2.0;  // path of the hand: middle, amplitude and period
constexpr int kLoops = 10, kSettling = 15;
constexpr Vec3 kStart_m{0.0, 0.0, 0.2};

double seconds_since(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

struct PushedWorld {
    std::shared_ptr<const HapticScene> felt;
    std::shared_ptr<const DynamicsScene> moves;
    BodyNature nature;
};
PushedWorld pushed_world(double kg) {
    const Aabb floor{{-5.0, -5.0, -1.0}, {5.0, 5.0, 0.0}};
    const Placement start{kStart_m, {}, 1.0};
    const SphereShape ball{Vec3(0.0), kBall_m};
    HapticSceneBuilder shape, felt;
    shape.add_sphere(ball, {FeatureId{2}});
    felt.add_box(floor, {FeatureId{1}});
    felt.add_body(FeatureId{2}, shape.build(), start);
    PushedWorld world;
    world.nature.mass_kg = kg;
    world.nature.friction = world.nature.friction_static = world.nature.elasticity = world.nature.rolling = 0.0;
    world.nature.string = BodyNature::String{kStart_m, kString_n_per_m};
    DynamicsSceneBuilder moves;
    moves.add_fixed_box(floor, FeatureId{1});
    const DynamicsPiece piece = make_piece(RoundShape(ball));
    if (moves.add_body(std::span(&piece, 1), FeatureId{2}, 0, start, world.nature) != BodyFault::None) return {};
    world.felt = felt.build();
    world.moves = moves.build();
    return world;
}

// Returns how far the hand has moved beyond the point where it touched the ball at rest, in hand metres.
double hand_at_m(double t_s) {
    return kMiddle_m * std::min(1.0, t_s / kLoop_s) + kSwing_m * std::sin(2.0 * kPi * t_s / kLoop_s);
}

// The steady oscillation of a mass with spring and damper, which is driven through another spring. Forces and lengths
// are those of the hand.
struct Swing {
    double middle_n = 0.0;
    // Amplitude: the real part belongs to sin(2 pi t / loop), the imaginary part to the cosine.
    std::complex<double> swing_n;
    double at(double t_s) const {
        const double turn = 2.0 * kPi * t_s / kLoop_s;
        return middle_n + swing_n.real() * std::sin(turn) + swing_n.imag() * std::cos(turn);
    }
    // Returns the energy given to the hand in one loop. It is negative, because the string's rubber absorbs energy.
    double given_j() const { return -kPi * kSwing_m * swing_n.imag(); }
};
Swing right_swing(const BodyNature& nature) {
    const double turn_per_s = 2.0 * kPi / kLoop_s, to_hand = kScale * kGain;
    const double string = kString_n_per_m * to_hand;
    const std::complex<double> body(string - nature.mass_kg * to_hand * turn_per_s * turn_per_s,
                                    string_damping_ns_per_m(nature) * to_hand * turn_per_s);
    return {kMiddle_m * kHand_n_per_m * string / (kHand_n_per_m + string),
            kSwing_m * kHand_n_per_m * body / (kHand_n_per_m + body)};
}

enum class Way : std::uint8_t { Model, Interpolated, Coupled };

BodiesMeasured measured(Way way, double kg) {
    const PushedWorld world = pushed_world(kg);
    Dynamics engine(world.moves);
    TouchTuning tuning;
    tuning.radius_m = 0.002 * kScale;
    tuning.world_m_per_hand_m = kScale;
    tuning.override_stiffness_n_per_m = kHand_n_per_m;
    tuning.damping_ns_per_m = 0.0;
    tuning.override_friction_static = tuning.override_friction_kinetic = 0.0;
    BodyFeel feel;
    feel.world_m_per_hand_m = kScale;
    feel.felt_gain = kGain;
    feel.ceiling_n = 1e9;
    feel.proxy_radius_m = tuning.radius_m;
    BodiesInReach bodies(0);
    bodies.enter(world.moves.get());
    HandPushRing pushes;
    TouchState state;
    std::vector<BodyPose> poses{{world.felt->bodies[0].start, true}};
    std::uint64_t number = 1;
    DynamicsFrame before, frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    before = frame;
    const double contact_n_per_m = kHand_n_per_m / (kGain * kScale), step_s = Dynamics::kStep_s;
    const double passed_on = way == Way::Coupled ? kg / (kg + contact_n_per_m * step_s * step_s) : 1.0;
    const Swing right = right_swing(world.nature);
    double work_j = 0.0, squares = 0.0, hand_s = 0.0, engine_s = 0.0, last_x_m = 0.0, last_n = 0.0;
    Vec3 sum_n(0.0);
    int summed = 0, steps = 0, counted = 0;
    const int ticks = static_cast<int>(std::lround(kLoop_s * 1e3)) * (kSettling + kLoops);
    for (int tick = 0; tick < ticks; ++tick) {
        const double t_s = 1e-3 * tick, now_s = step_s + t_s, x_m = hand_at_m(t_s);
        const Vec3 hand_m = kStart_m + Vec3(-kBall_m - tuning.radius_m + kScale * x_m, 0.0, 0.0);
        const auto begun = std::chrono::steady_clock::now();
        Vec3 force_n;
        if (way == Way::Model) {
            bodies.hear(frame);
            if (bodies.place(now_s, hand_m, feel, poses)) ++number;
            const TouchResult touch =
                touch_tick(state, *world.felt, tuning, hand_m, 1e-3, bodies.carried_m(), {poses, number});
            force_n = touch.force_n;
            bodies.react(touch, 1.0, now_s, 1e-3, feel, pushes);
        } else {
            // The poses are played back one step late, so that there is always a later pose for the interpolation.
            const double part = std::clamp((now_s - step_s - before.time_s) / step_s, 0.0, 1.0);
            poses[0].at.position_m =
                before.things[0].position_m + part * (frame.things[0].position_m - before.things[0].position_m);
            force_n = touch_tick(state, *world.felt, tuning, hand_m, 1e-3, Vec3(0.0), {poses, ++number}).force_n;
            sum_n += force_n;
            ++summed;
        }
        hand_s += seconds_since(begun);
        const double f_n = -force_n.x;  // force against the hand's motion
        if (tick >= ticks - static_cast<int>(kLoop_s * 1e3) * kLoops) {
            if (counted > 0) work_j += -0.5 * (f_n + last_n) * (x_m - last_x_m);
            squares += (f_n - right.at(t_s)) * (f_n - right.at(t_s));
            ++counted;
        }
        last_x_m = x_m;
        last_n = f_n;
        engine.place_hand(0, {hand_m, way == Way::Model ? feel.proxy_radius_m : 0.0, 0.0});
        for (HandPush push; pushes.pop(push);) engine.push(0, push);
        while (engine.time_s() + step_s <= now_s + 1e-9) {
            if (way != Way::Model && summed > 0) {
                HandPush push;
                push.time_s = engine.time_s();
                push.dt_s = step_s;
                push.body = 0;
                push.game = frame.game;
                push.force_n = sum_n * (-passed_on / (summed * kGain));
                engine.push(0, push);
                sum_n = Vec3(0.0);
                summed = 0;
            }
            before = frame;
            const auto stepped = std::chrono::steady_clock::now();
            engine.step(frame, events);
            engine_s += seconds_since(stepped);
            ++steps;
            events.clear();
        }
    }
    BodiesMeasured out;
    out.way = way == Way::Model          ? "Handrail: the model in the servo"
              : way == Way::Interpolated ? "Poses interpolated"
                                         : "Virtual coupling";
    out.mass_kg = kg;
    out.error_n = std::sqrt(squares / counted);
    out.felt_n = std::abs(right.swing_n);
    out.given_j = work_j / kLoops;
    out.right_given_j = right.given_j();
    out.tick_s = hand_s / ticks;
    out.step_s = engine_s / std::max(1, steps);
    return out;
}

}  // namespace

std::vector<BodiesMeasured> run_bodies() {
    std::vector<BodiesMeasured> all;
    for (const double kg : {0.05, 1.0, 10.0})
        for (const Way way : {Way::Model, Way::Interpolated, Way::Coupled}) all.push_back(measured(way, kg));
    return all;
}

}  // namespace handrail::bench
