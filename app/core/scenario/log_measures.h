// What the expectations of a scenario measure: words of a line, how far a ball is inside solids, a frequency in a
// force. Pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

// True when the words of `wanted` stand in `line` in that order, ignoring case and punctuation.
bool words_in_order(const std::string& wanted, const std::string& line);

// How deep the ball overlaps the nearest solid or sheet: brute force over planes, independent of the renderer.
// Negative: clearance is not measured, so 0 is "not at all".
double overlap_m(const Scene& scene, const Vec3& centre_m, double radius_m);

// The amplitude of the strongest line of `samples` (evenly spaced by dt_s) between two frequencies, after removing the
// straight line through them and a Hann window (scaled so that a pure sine shows its amplitude). Equal frequencies:
// that one line.
double line_amplitude(const std::vector<double>& samples, double dt_s, double from_hz, double to_hz);

}  // namespace handrail
