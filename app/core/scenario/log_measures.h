// Measurements for the expectations of a scenario: words in a line, how deep a proxy is inside solids, a frequency in a
// force. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::core {

// True if the words of `wanted` occur in `line` in that order, ignoring case and punctuation.
bool words_in_order(const std::string& wanted, const std::string& line);

// How deep the proxy overlaps the nearest solid or sheet, by brute force over planes and independent of the renderer. 0
// means no overlap; clearance is not measured.
double overlap_m(const Scene& scene, const Vec3& centre_m, double radius_m);

// The amplitude of the strongest spectral line of `samples` (spaced by dt_s) between two frequencies. The straight line
// through the samples is removed, and a Hann window applied, scaled so that a pure sine shows its amplitude. With equal
// frequencies, only that line is measured.
double line_amplitude(const std::vector<double>& samples, double dt_s, double from_hz, double to_hz);

}  // namespace handrail::core
