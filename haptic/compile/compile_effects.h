// Effects of a Scene -> effect volumes with their laws. App or worker thread.
#pragma once

#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail {

// After the bodies: an effect that belongs to one hangs on it, in its frame. What a reader has let through is sound and
// is taken.
void add_effects(HapticSceneBuilder& builder, const Scene& scene);

}  // namespace handrail
