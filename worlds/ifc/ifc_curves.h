// Curves of IFC as points in metres, and profiles as outlines with holes. Bent ones become chords. One reading thread.
#pragma once

#include "worlds/geometry/flat_parts.h"
#include "worlds/ifc/ifc_model.h"

namespace handrail {

// In the curve's own frame; the last point of a closed one is not repeated. Empty: a kind that is not read, or damaged.
std::vector<Vec3> curve_points(const IfcModel& model, std::uint64_t curve);

// Outlines of a profile definition, by the even-odd rule, in its own plane: one list for each part of a composite
// profile. Empty: a kind that is not read.
std::vector<std::vector<Ring>> profile_rings(const IfcModel& model, std::uint64_t profile);

// Corners on a circle.
Ring regular_ring(double radius_m, int corners);

}  // namespace handrail
