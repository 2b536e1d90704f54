// Converts curves of IFC to points in metres, and profiles to outlines with holes. Curved pieces are replaced with
// chords. Used on the reading thread only.
#pragma once

#include "worlds/geometry/flat_parts.h"
#include "worlds/ifc/ifc_model.h"

namespace handrail::ifc {

// Returns the points of a curve in its own frame. A closed curve does not repeat its first point at the end. Empty if
// the kind of curve is not supported or the curve is damaged.
std::vector<Vec3> curve_points(const IfcModel& model, std::uint64_t curve);

// Returns the outlines of a profile definition in its own plane, by the even-odd rule. There is one list for each part
// of a composite profile. Empty if the kind of profile is not supported.
std::vector<std::vector<Ring>> profile_rings(const IfcModel& model, std::uint64_t profile);

// Returns the corners of a regular polygon whose corners are on a circle.
Ring regular_ring(double radius_m, int corners);

}  // namespace handrail::ifc
