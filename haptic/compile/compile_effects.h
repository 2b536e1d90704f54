// Effects of a Scene -> effect volumes with their laws. App or background thread.
#pragma once

#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::compile {

// Call it after the bodies were added: an effect that belongs to a body is attached to it, in its frame. Effects that a
// reader has accepted are sound and are all added.
void add_effects(render::HapticSceneBuilder& builder, const Scene& scene);

}  // namespace handrail::compile
