// Curves of IFC as points in metres, and profiles as outlines with holes. Curved pieces become chords. One reading
// thread uses them.
#pragma once

#include "worlds/geometry/flat_parts.h"
#include "worlds/ifc/ifc_model.h"

namespace handrail::ifc {

// The points of a curve in its own frame; a closed curve does not repeat its first point at the end. Empty if the kind
// is not supported or the curve is damaged.
std::vector<Vec3> curve_points(const IfcModel& model, std::uint64_t curve);

// The outlines of a profile definition in its own plane, by the even-odd rule: one list for each part of a composite
// profile. Empty if the kind is not supported.
std::vector<std::vector<Ring>> profile_rings(const IfcModel& model, std::uint64_t profile);

// The corners of a regular polygon on a circle.
Ring regular_ring(double radius_m, int corners);

}  // namespace handrail::ifc
