#include "app/core/bodies/keyboard_grip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/bodies/body_words.h"
#include "app/core/context/context_words.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kStep_m = 0.25;   // how far one tap moves the held thing; a ball moves by two of its diameters instead
constexpr double kRepeat_s = 1.0;  // a held key repeats its step after this time
constexpr double kRests_s = 0.15;  // a step ends once the thing has not moved for this long
constexpr double kStill_m = 2e-3;  // the thing moved if it shifted by more than this
constexpr double kMost_s = 2.5;    // a step ends after this time, even if the thing still moves
// Share of a step. If the thing ends further than this share from its target, an obstacle stopped the thing.
constexpr double kShort = 0.25;

constexpr std::array kSteps{Command::Forward,   Command::Back,   Command::TurnLeft,
                            Command::TurnRight, Command::TiltUp, Command::TiltDown};

}  // namespace

bool KeyboardGrip::keeps(Command command) const {
    return holds() && std::find(kSteps.begin(), kSteps.end(), command) != kSteps.end();
}

void KeyboardGrip::take(dynamics::BodyEngine& engine, const render::DynamicsScene& scene, std::uint32_t body,
                        const Placement& middle, double now_s) {
    const render::DynamicsBody& is = scene.bodies[body];
    if (is.nature.mass_kg * kGravity_m_per_s2 > context_.settings.dynamics.strength_n)
        return context_.answer(heavy_words(context_, is.feature, is.nature.mass_kg), now_s);
    held_ = body;
    to_m_ = middle.position_m;
    turn_ = middle.rotation;
    stepped_s_.reset();
    keys_.release_all();
    lead(engine);
    context_.play(cues::SoundKind::Grab, now_s);
    std::string said =
        phrase("bodies.held", {{"name", body_name(context_, is.feature)}, {"mass", mass_words(is.nature.mass_kg)}});
    if (!hints_announced_)
        said +=
            " " + phrase(is.ball ? "bodies.ball_hint" : "bodies.hint", {{"key", context_.keys.keys_of(Command::Use)}});
    hints_announced_ = true;
    context_.answer(std::move(said), now_s);
}

void KeyboardGrip::let_go() {
    held_ = render::kNoBody;
    stepped_s_.reset();
    keys_.release_all();
}

void KeyboardGrip::let_go(dynamics::BodyEngine& engine, const render::DynamicsScene& scene, double now_s) {
    const FeatureId feature = scene.bodies[held_].feature;
    let_go();
    engine.order({.kind = dynamics::BodyEngine::Order::Kind::LetGo});
    context_.play(cues::SoundKind::LetGo, now_s);
    context_.answer(phrase("bodies.let_go", {{"name", body_name(context_, feature)}}), now_s);
}

void KeyboardGrip::lead(dynamics::BodyEngine& engine) const {
    dynamics::BodyEngine::Order order;
    order.kind = dynamics::BodyEngine::Order::Kind::Lead;
    order.body = held_;
    order.at_m = to_m_;
    order.most_n = context_.settings.dynamics.strength_n;
    order.turn = turn_;
    engine.order(order);
}

// On a map, "ahead" is north; otherwise it is the direction that the walker faces.
Vec3 KeyboardGrip::way_of(Command command) const {
    const double ahead =
        context_.settings.workspace.frame == settings::FrameChoice::Map ? 0.0 : context_.avatar.heading_goal_rad;
    switch (command) {
        case Command::Forward:
            return forward_of_heading(ahead);
        case Command::Back:
            return forward_of_heading(ahead + kPi);
        case Command::TurnLeft:
            return forward_of_heading(ahead - kPi / 2.0);
        case Command::TurnRight:
            return forward_of_heading(ahead + kPi / 2.0);
        case Command::TiltUp:
            return {0.0, 0.0, 1.0};
        case Command::TiltDown:
            return {0.0, 0.0, -1.0};
        default:
            return Vec3(0.0);
    }
}

double KeyboardGrip::step_m(const render::DynamicsBody& body) const {
    return body.ball ? 4.0 * body.half_width_m : kStep_m;
}

void KeyboardGrip::step(Command command, dynamics::BodyEngine& engine, const render::DynamicsScene& scene,
                        const Placement& middle, double now_s, int times) {
    const render::DynamicsBody& is = scene.bodies[held_];
    const bool lifts = command == Command::TiltUp || command == Command::TiltDown;
    if (is.ball && lifts) return context_.answer(phrase("bodies.ball_rolls"), now_s);
    // A step begins at the target of the previous step. If that step is over, it begins at the thing's present
    // position.
    if (!stepped_s_) to_m_ = Vec3(middle.position_m.x, middle.position_m.y, lifts ? middle.position_m.z : to_m_.z);
    to_m_ += way_of(command) * (step_m(is) * times);
    stepped_s_ = rests_since_s_ = now_s;
    lead(engine);
}

bool KeyboardGrip::act(Command command, dynamics::BodyEngine& engine, const render::DynamicsScene& scene,
                       const Placement& middle, double now_s, int times) {
    if (!holds()) return false;
    if (keeps(command)) {
        keys_.press(command);
        step(command, engine, scene, middle, now_s, times);
        return true;
    }
    switch (command) {
        case Command::Use:
            let_go(engine, scene, now_s);
            return true;
        case Command::WorkspaceTurnLeft:
        case Command::WorkspaceTurnRight: {
            const bool left = command == Command::WorkspaceTurnLeft;
            if (scene.bodies[held_].ball) {
                context_.answer(phrase("bodies.ball_turns"), now_s);
                return true;
            }
            turn_ = normalized(rotation_about({0.0, 0.0, 1.0}, left ? kPi / 2.0 : -kPi / 2.0) * turn_);
            lead(engine);
            context_.answer(phrase(left ? "bodies.turned_left" : "bodies.turned_right"), now_s);
            return true;
        }
        default:
            return false;
    }
}

void KeyboardGrip::tick(dynamics::BodyEngine& engine, const render::DynamicsScene& scene, const Placement& middle,
                        FeatureId hit, double now_s) {
    if (!holds()) return;
    if (glm::length(middle.position_m - last_m_) > kStill_m) {
        last_m_ = middle.position_m;
        rests_since_s_ = now_s;
    }
    if (!stepped_s_) return;
    if (now_s - *stepped_s_ >= kRepeat_s)
        for (const Command command : kSteps)
            if (keys_.held(command)) return step(command, engine, scene, middle, now_s, 1);
    const bool begun = now_s - *stepped_s_ > 2.0 * kRests_s;
    if (now_s - *stepped_s_ < kMost_s && !(begun && now_s - rests_since_s_ > kRests_s)) return;
    stepped_s_.reset();
    const render::DynamicsBody& is = scene.bodies[held_];
    Vec3 missing = to_m_ - middle.position_m;
    if (is.ball) missing.z = 0.0;
    const std::string name = body_name(context_, is.feature);
    if (glm::length(missing) < kShort * step_m(is))
        return context_.answer(phrase("bodies.moved", {{"name", name}}), now_s);
    to_m_ = middle.position_m;
    lead(engine);
    context_.answer(hit ? phrase("bodies.meets", {{"name", name}, {"what", name_of(context_, hit)}})
                        : phrase("bodies.stuck", {{"name", name}}),
                    now_s);
}

}  // namespace handrail::core
