// What a part of a building is made of while it is read: convex solids, and sheets where there is no inside. Pure
// functions on plain values; metres.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "worlds/geometry/convex.h"
#include "worlds/geometry/flat_parts.h"
#include "worlds/ifc/ifc_model.h"

namespace handrail {

inline constexpr double kFlush_m = 1e-4;  // what sticks out less than this is not cut off

struct Body {
    std::vector<ConvexSolid> solids;
    std::vector<Polygon> sheets;

    bool empty() const { return solids.empty() && sheets.empty(); }
    Aabb bounds_m() const;
    void add(Body other);
};

// A flat face: an outline, then holes.
struct FlatFace {
    std::vector<std::vector<Vec3>> rings;
};

// Convex outline swept along `way`, in a frame; nothing where it has no volume.
std::optional<ConvexSolid> prism(const Ring& outline, const Vec3& way_m, const Frame& frame);
// The box in a frame between two corners.
std::optional<ConvexSolid> box_solid(const Vec3& least_m, const Vec3& most_m, const Frame& frame);
// From planes around a place; nothing where they enclose no volume.
std::optional<ConvexSolid> solid_within(std::vector<Plane> planes, const Vec3& near_m, double reach_m);

// Shells: each connected piece becomes one convex solid or a prism cut into convex ones where it is such, else sheets.
Body body_of_faces(const std::vector<FlatFace>& faces);

// Sheets that together enclose a volume become convex solids. Open or too complex ones stay sheets.
void fill(Body& body);
// Whether its sheets look all ways alike, as a closed skin does. Solids always enclose.
bool encloses(const Body& body);

// Bit for bit the same forms in the same order; a number that is the same for those that are.
bool same_body(const Body& a, const Body& b);
std::uint64_t number_of(const Body& body);

// Of its solids, and of what its sheets enclose, where those are turned outwards.
double volume_m3(const Body& body);
// What a closed skin of faces encloses, each turned outwards; nothing where an edge of it is open, or runs twice the
// same way. Knows nothing of solids, so that what they hold can be compared with it.
std::optional<double> enclosed_m3(const std::vector<FlatFace>& faces);

// The same elsewhere. What becomes flat or not finite is left out.
Body transformed(const Body& body, const Frame& frame);

inline constexpr double kFarthestPart_m = 1e6;  // replay and rendering take positions up to here

// Takes out what reaches beyond kFarthestPart_m of the world's origin; how many pieces that was.
int drop_far(Body& body);

// How far the points reach along a direction.
struct Reach {
    double least = 0.0, most = 0.0;
};
Reach reach_along(const ConvexSolid& solid, const Vec3& direction);
std::optional<Reach> reach_along(const Body& body, const Vec3& direction);

// What lies behind all planes is taken away, or all else. True where something changed.
bool cut_away(Body& body, std::span<const Plane> planes);
void keep_within(Body& body, std::span<const Plane> planes);
// Whether something lies across the upright line from one place to another above it.
bool crosses(const Body& body, const Vec3& low, const Vec3& high);
// True where a body of that shape and this one share more than a flush touch.
bool meets(const Body& body, const ConvexSolid& shape);

}  // namespace handrail
