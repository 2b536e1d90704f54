// Whether a HapticScene holds together: what the tick relies on without looking. For tests and the preset debug, after
// each compiling; app or loading thread. Looks at everything once: about a tenth of what building the scene costs.
#pragma once

#include "haptic/render/haptic_scene.h"
#include "worlds/base/result.h"

namespace handrail {

// Says the first thing that is wrong: a number that points nowhere, a place that is not finite, a direction without
// length, a body without a shape. The message is for developers.
Result<void> validate(const HapticScene& scene);

}  // namespace handrail
