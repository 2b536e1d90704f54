// Checks whether a HapticScene is consistent in everything that the tick relies on without checking. For tests and the
// preset debug, after each compilation; app or loading thread. Looks at everything once: costs about a tenth of
// building the scene.
#pragma once

#include "haptic/render/haptic_scene.h"
#include "worlds/base/result.h"

namespace handrail::render {

// Reports the first fault: an index out of range, a place that is not finite, a direction without length, a body
// without a shape. The message is for developers.
Result<void> validate(const HapticScene& scene);

}  // namespace handrail::render
