// Plays the sounds of moving things at the place of contact: hits, rolling and sliding. Impulse, speed and both
// materials determine the sound. Use it on the app thread only.
#pragma once

#include <vector>

#include "app/core/context/session_part.h"
#include "haptic/render/rigid_body_state.h"

namespace handrail::core {

class BodySounds : SessionPart {
public:
    explicit BodySounds(const SessionContext& context) : SessionPart(context) {}

    // Stops all sounds. Call it when another world is entered, or when the world is left.
    void enter_world(std::size_t bodies, double now_s);
    void hear(const render::BodyEvent& event, const render::DynamicsScene& scene, double now_s);
    // Stops the sound of each body that no longer rolls or slides.
    void tick(double now_s);

private:
    struct Loop {
        double heard_s = -1e9;
        bool sounds = false;
        Vec3 at_m{0.0};
    };
    SoundClass sound_of(FeatureId feature) const;
    void loop(std::size_t body, double loudness, SoundClass material, double now_s);

    std::vector<Loop> loops_;  // one entry for each body of the world
};

}  // namespace handrail::core
