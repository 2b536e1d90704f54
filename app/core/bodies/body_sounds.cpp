#include "app/core/bodies/body_sounds.h"

#include <algorithm>
#include <cmath>

namespace handrail::core {
namespace {

// Impulse of the hit that plays at full loudness: a crate of 4 kg that falls from more than a metre.
constexpr double kLoudest_ns = 20.0;
constexpr double kFaintest = 0.05;            // share of the full loudness; quieter sounds are not played
constexpr double kLoudestRoll_m_per_s = 1.5;  // speed at which a rolling sound plays at full loudness: walking speed
// If the engine sends no report for this long, the sound of a body stops. The engine reports rolling and sliding 20
// times a second.
constexpr double kSilent_s = 0.2;
constexpr std::uint32_t kFirstSource = 16;  // first sound source of bodies; lower numbers belong to the hands

}  // namespace

void BodySounds::enter_world(std::size_t bodies, double now_s) {
    for (std::size_t body = 0; body < loops_.size(); ++body)
        if (loops_[body].sounds) loop(body, 0.0, SoundClass::Generic, now_s);
    loops_.assign(bodies, {});
}

SoundClass BodySounds::sound_of(FeatureId feature) const {
    const Feature* found = context_.world.scene->find(feature);
    return found ? context_.world.scene->material(found->material).sound : SoundClass::Generic;
}

void BodySounds::loop(std::size_t body, double loudness, SoundClass material, double now_s) {
    cues::CueRequest request;
    request.kind = cues::CueRequestKind::WorldSound;
    request.time_s = now_s;
    request.sound = cues::SoundKind::Slide;
    request.material = material;
    request.position_m = loops_[body].at_m;
    request.loudness = loudness;
    request.source = kFirstSource + static_cast<std::uint32_t>(body);
    context_.cues.cue(std::move(request));
    loops_[body].sounds = loudness > 0.0;
}

void BodySounds::hear(const render::BodyEvent& event, const render::DynamicsScene& scene, double now_s) {
    const FeatureId own = scene.bodies[event.body].feature;
    const FeatureId other = event.other_body != render::kNoBody ? scene.bodies[event.other_body].feature : event.other;
    switch (event.kind) {
        case render::BodyEvent::Kind::Hit: {
            const double loudness = std::min(1.0, std::sqrt(event.impulse_ns / kLoudest_ns));
            if (loudness < kFaintest) return;
            cues::CueRequest knock = sound_at(cues::SoundKind::Contact, event.at_m, now_s);
            knock.loudness = loudness;
            knock.material = sound_of(own);
            context_.cues.cue(knock);
            if (!other || sound_of(other) == knock.material) return;
            knock.material = sound_of(other);
            context_.cues.cue(std::move(knock));
            return;
        }
        case render::BodyEvent::Kind::Rolls:
        case render::BodyEvent::Kind::Slides: {
            Loop& heard = loops_[event.body];
            heard.heard_s = now_s;
            heard.at_m = event.at_m;
            // At the same speed, a sliding body sounds twice as loud as a rolling one.
            const double most = event.kind == render::BodyEvent::Kind::Slides ? 1.0 : 0.5;
            const double loudness = most * std::min(1.0, event.speed_m_per_s / kLoudestRoll_m_per_s);
            loop(event.body, loudness < kFaintest ? 0.0 : loudness, sound_of(other), now_s);
            return;
        }
        case render::BodyEvent::Kind::Falls:
        case render::BodyEvent::Kind::Rests:
        case render::BodyEvent::Kind::PutBack:
            return;
    }
}

void BodySounds::tick(double now_s) {
    for (std::size_t body = 0; body < loops_.size(); ++body)
        if (loops_[body].sounds && now_s - loops_[body].heard_s > kSilent_s)
            loop(body, 0.0, SoundClass::Generic, now_s);
}

}  // namespace handrail::core
