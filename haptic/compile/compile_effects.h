// Compiles the effects of a Scene to effect volumes with their force laws. App thread or background thread.
#pragma once

#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::compile {

// Call it after the bodies were added, because an effect that belongs to a body is attached to that body, in the body's
// frame. All effects are added without a further check, since the reader of the world file has validated them.
void add_effects(render::HapticSceneBuilder& builder, const Scene& scene);

}  // namespace handrail::compile
