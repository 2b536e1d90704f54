// Represents the shape of a part of a building while the file is being read: convex solids, and sheets for surfaces
// that enclose no volume. Pure functions on plain values in metres.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "worlds/geometry/convex.h"
#include "worlds/geometry/flat_parts.h"
#include "worlds/ifc/ifc_model.h"

namespace handrail::ifc {

inline constexpr double kFlush_m = 1e-4;  // if a part extends beyond a cutting plane by less than this, it is not cut

struct Body {
    std::vector<ConvexSolid> solids;
    std::vector<Polygon> sheets;

    bool empty() const { return solids.empty() && sheets.empty(); }
    Aabb bounds_m() const;
    void add(Body other);
};

// A flat face: its outline first, then its holes.
struct FlatFace {
    std::vector<std::vector<Vec3>> rings;
};

// Sweeps a convex outline along `way_m`. Outline and `way_m` are in the axes of `frame`. Returns nothing if the result
// has no volume.
std::optional<ConvexSolid> prism(const Ring& outline, const Vec3& way_m, const Frame& frame);
// Returns the box between two corners that are given in the axes of `frame`.
std::optional<ConvexSolid> box_solid(const Vec3& least_m, const Vec3& most_m, const Frame& frame);
// Builds a solid from the planes that bound it. `near_m` is a point near the solid, and `reach_m` the greatest distance
// of a corner from it. Returns nothing if the planes enclose no volume.
std::optional<ConvexSolid> solid_within(std::vector<Plane> planes, const Vec3& near_m, double reach_m);

// Turns the faces of shells into a body. If a connected piece is convex, it becomes one convex solid. A prism is cut
// into convex solids. Any other piece remains a set of sheets.
Body body_of_faces(const std::vector<FlatFace>& faces);

// Turns sheets that together enclose a volume into convex solids. Sheets that are open or too complex stay sheets.
void fill(Body& body);
// Returns true if the shape encloses a volume. Solids always do. Sheets do if they face all directions equally, as a
// closed skin does.
bool encloses(const Body& body);

// same_body compares two bodies bit for bit and in order. number_of returns a hash, so equal shapes have equal numbers.
bool same_body(const Body& a, const Body& b);
std::uint64_t number_of(const Body& body);

// Returns the volume of the solids plus the volume that outward-facing sheets enclose.
double volume_m3(const Body& body);
// Returns the volume within a closed skin of outward-facing faces. Nothing if an edge is open or occurs twice in the
// same direction. The volume is computed from the faces alone, so that the volume of the solids made from them can be
// checked against it.
std::optional<double> enclosed_m3(const std::vector<FlatFace>& faces);

// Moves a shape into another frame. Pieces that become degenerate or not finite are left out.
Body transformed(const Body& body, const Frame& frame);

// Greatest coordinate of a part; replay and rendering accept positions up to this distance.
inline constexpr double kFarthestPart_m = 1e6;

// Removes the pieces that extend beyond kFarthestPart_m from the world's origin. Returns the number of removed pieces.
int drop_far(Body& body);

// The interval that points cover along a direction.
struct Reach {
    double least = 0.0, most = 0.0;
};
Reach reach_along(const ConvexSolid& solid, const Vec3& direction);
std::optional<Reach> reach_along(const Body& body, const Vec3& direction);

// cut_away removes the part of the body that is behind all planes, and returns true if it removed something.
// keep_within removes everything except that part.
bool cut_away(Body& body, std::span<const Plane> planes);
void keep_within(Body& body, std::span<const Plane> planes);
// Returns true if a solid or sheet of the body crosses the vertical line from `low` up to `high`.
bool crosses(const Body& body, const Vec3& low, const Vec3& high);
// Returns true if `shape` and the body overlap. A flush contact of two faces is not an overlap.
bool meets(const Body& body, const ConvexSolid& shape);

}  // namespace handrail::ifc
