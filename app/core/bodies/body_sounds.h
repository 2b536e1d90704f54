// What is heard of things that move: where they hit, roll and slide, at their places, by impulse, speed and both
// materials. App thread only.
#pragma once

#include <vector>

#include "app/core/context/session_part.h"
#include "haptic/render/body_word.h"

namespace handrail {

class BodySounds : SessionPart {
public:
    explicit BodySounds(const SessionContext& context) : SessionPart(context) {}

    // Another world, or none: what sounds falls silent.
    void enter_world(std::size_t bodies, double now_s);
    void hear(const BodyEvent& event, const DynamicsScene& scene, double now_s);
    // What has rolled or slid and does no more falls silent.
    void tick(double now_s);

private:
    struct Loop {
        double heard_s = -1e9;
        bool sounds = false;
        Vec3 at_m{0.0};
    };
    SoundClass sound_of(FeatureId feature) const;
    void loop(std::size_t body, double loudness, SoundClass material, double now_s);

    std::vector<Loop> loops_;  // per body
};

}  // namespace handrail
