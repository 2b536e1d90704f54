// Checks that a HapticScene is consistent in everything that the tick relies on without checking. For tests and for the
// preset debug, after each compilation; app thread or loading thread. Visits each part once, which costs about a tenth
// of building the scene.
#pragma once

#include "haptic/render/haptic_scene.h"
#include "worlds/base/result.h"

namespace handrail::render {

// Checks the scene and reports the first fault found: an index out of range, a position that is not finite, a direction
// without length, or a body without a shape. The message is for developers.
Result<void> validate(const HapticScene& scene);

}  // namespace handrail::render
