#include "app/core/bodies/device_grip.h"

#include <cmath>
#include <string>
#include <utility>

#include "app/core/bodies/body_words.h"
#include "haptic/servo/bodies_in_reach.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kAnswers_s = 0.3;  // the servo must take hold within this time after a request

}  // namespace

void DeviceGrip::enter_world() {
    sides_ = {};
    hands_.tuning.bodies.hold = hands_.left_bodies.hold = false;
}

bool DeviceGrip::act(Command command, const render::DynamicsScene& scene, double now_s) {
    for (std::size_t which = 0; which < sides_.size(); ++which) {
        const std::uint32_t held = sides_[which].held;
        if (held == render::kNoBody) continue;
        if (command == Command::Use) {
            tuning(which).hold = !tuning(which).hold;
            return true;
        }
        if (command != Command::WorkspaceTurnLeft && command != Command::WorkspaceTurnRight) continue;
        const bool left = command == Command::WorkspaceTurnLeft, ball = scene.bodies[held].ball;
        if (!ball) tuning(which).quarters += left ? 1 : -1;
        context_.answer(phrase(ball   ? "bodies.ball_turns"
                               : left ? "bodies.turned_left"
                                      : "bodies.turned_right"),
                        now_s);
        return true;
    }
    if (command != Command::Use) return false;
    for (std::size_t which = 0; which < sides_.size(); ++which) {
        if (!tool(which).touches() || render::body_of(scene, tool(which).touched()) == render::kNoBody) continue;
        tuning(which).hold = true;
        sides_[which].requested_s = now_s;
        return true;
    }
    return false;
}

void DeviceGrip::announce_held(const render::DynamicsScene& scene, std::uint32_t body, double now_s) {
    const render::DynamicsBody& is = scene.bodies[body];
    context_.play(cues::SoundKind::Grab, now_s);
    std::string said =
        phrase("bodies.held", {{"name", body_name(context_, is.feature)}, {"mass", mass_words(is.nature.mass_kg)}});
    if (!gain_announced_) {
        const double gain = servo::felt_gain(hands_.tuning.force_ceiling_n, context_.settings.dynamics.strength_n);
        said += " " + phrase("bodies.felt_gain", {{"newtons", std::round(1.0 / gain)}});
        gain_announced_ = true;
    }
    context_.answer(std::move(said), now_s);
}

void DeviceGrip::tick(const render::DynamicsScene& scene, double now_s) {
    for (std::size_t which = 0; which < sides_.size(); ++which) {
        Side& side = sides_[which];
        const servo::ToolState& is = tool(which);
        if (is.scene_world != context_.world.felt) continue;  // This report still belongs to the previous world.
        const bool heavy = std::exchange(side.heavies, is.heavies) != is.heavies && side.heavies_known;
        side.heavies_known = true;
        if (heavy && is.heavy < scene.bodies.size()) {
            const render::DynamicsBody& body = scene.bodies[is.heavy];
            context_.say(heavy_words(context_, body.feature, body.nature.mass_kg), cues::SpeechClass::Answer, now_s);
        }
        const std::uint32_t was = std::exchange(side.held, is.holds < scene.bodies.size() ? is.holds : render::kNoBody);
        if (side.held == render::kNoBody && now_s - side.requested_s > kAnswers_s) tuning(which).hold = false;
        if (was == side.held) continue;
        if (side.held != render::kNoBody) {
            announce_held(scene, side.held, now_s);
        } else {
            tuning(which).hold = false;
            context_.play(cues::SoundKind::LetGo, now_s);
            if (!heavy)
                context_.answer(phrase("bodies.let_go", {{"name", body_name(context_, scene.bodies[was].feature)}}),
                                now_s);
        }
    }
}

}  // namespace handrail::core
