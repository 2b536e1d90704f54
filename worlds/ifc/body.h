// The shape of a part of a building while the file is being read: convex solids, and sheets for surfaces that enclose
// no volume. Pure functions on plain values; all lengths in metres.
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

inline constexpr double kFlush_m = 1e-4;  // overhangs smaller than this are not cut off

struct Body {
    std::vector<ConvexSolid> solids;
    std::vector<Polygon> sheets;

    bool empty() const { return solids.empty() && sheets.empty(); }
    Aabb bounds_m() const;
    void add(Body other);
};

// A flat face: the outline first, then the holes.
struct FlatFace {
    std::vector<std::vector<Vec3>> rings;
};

// Sweeps a convex outline along `way_m`, in the axes of `frame`. Returns nothing if the result has no volume.
std::optional<ConvexSolid> prism(const Ring& outline, const Vec3& way_m, const Frame& frame);
// The box between two corners, in the axes of `frame`.
std::optional<ConvexSolid> box_solid(const Vec3& least_m, const Vec3& most_m, const Frame& frame);
// Builds a solid from planes around `near_m`. Returns nothing if they enclose no volume.
std::optional<ConvexSolid> solid_within(std::vector<Plane> planes, const Vec3& near_m, double reach_m);

// Reads shells. Each connected piece becomes one convex solid if it is convex, or a prism cut into convex solids if it
// is a prism. Otherwise it stays sheets.
Body body_of_faces(const std::vector<FlatFace>& faces);

// Turns sheets that together enclose a volume into convex solids. Open or too complex ones stay sheets.
void fill(Body& body);
// Returns whether the sheets face all directions equally, as a closed skin does. Solids always enclose a volume.
bool encloses(const Body& body);

// `same_body` compares bit for bit, in the same order. `number_of` is a hash: equal shapes have equal numbers.
bool same_body(const Body& a, const Body& b);
std::uint64_t number_of(const Body& body);

// The volume of the solids, plus the volume that outward-facing sheets enclose.
double volume_m3(const Body& body);
// The volume enclosed by a closed skin of outward-facing faces. Returns nothing if an edge is open or runs twice in the
// same direction. It is computed from the faces alone, so that the volume of the solids made from them can be checked
// against it.
std::optional<double> enclosed_m3(const std::vector<FlatFace>& faces);

// Moves a shape into another frame. Pieces that become flat or not finite are left out.
Body transformed(const Body& body, const Frame& frame);

inline constexpr double kFarthestPart_m = 1e6;  // replay and rendering take positions up to here

// Removes the pieces that reach beyond kFarthestPart_m from the world's origin. Returns how many there were.
int drop_far(Body& body);

// The interval that the points cover along a direction.
struct Reach {
    double least = 0.0, most = 0.0;
};
Reach reach_along(const ConvexSolid& solid, const Vec3& direction);
std::optional<Reach> reach_along(const Body& body, const Vec3& direction);

// `cut_away` removes what is behind all planes and returns true if something changed; `keep_within` removes everything
// else.
bool cut_away(Body& body, std::span<const Plane> planes);
void keep_within(Body& body, std::span<const Plane> planes);
// Returns whether something crosses the vertical line from `low` up to `high`.
bool crosses(const Body& body, const Vec3& low, const Vec3& high);
// Returns true if `shape` and the body overlap by more than a flush contact.
bool meets(const Body& body, const ConvexSolid& shape);

}  // namespace handrail::ifc
