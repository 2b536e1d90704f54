// Takes measurements for the expectations of a scenario: words in a line, the depth of a proxy inside solids, and a
// frequency in a force signal. Pure functions, which any thread may call.
#pragma once

#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::core {

// Returns true if the words of `wanted` occur in `line` in the same order. Case and punctuation are ignored.
bool words_in_order(const std::string& wanted, const std::string& line);

// Returns how deep the proxy overlaps the nearest solid or sheet. The depth is computed by brute force over planes,
// independent of the renderer. 0 means no overlap. The distance to a solid that the proxy does not overlap is not
// measured.
double overlap_m(const Scene& scene, const Vec3& centre_m, double radius_m);

// Returns the amplitude of the strongest spectral line of `samples` between two frequencies. The samples are `dt_s`
// apart. First, the function subtracts the least-squares straight line and applies a Hann window, scaled so that a pure
// sine gives its amplitude. If both frequencies are equal, only that frequency is measured.
double line_amplitude(const std::vector<double>& samples, double dt_s, double from_hz, double to_hz);

}  // namespace handrail::core
