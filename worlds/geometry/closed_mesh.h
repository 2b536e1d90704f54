// Treats triangle meshes as the surfaces of solids. Finds which pieces are closed, which places are inside them, and
// the convex solids that fill them. Pure functions on plain values in metres; any thread may call them. A triangle is
// three indices into `points_m`; its corners run counter-clockwise seen from outside.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail {

using MeshCorners = std::array<std::uint32_t, 3>;

// A piece of a mesh: triangles that are connected by edges.
struct MeshShell {
    std::vector<std::uint32_t> triangles;  // their indices in the mesh, in rising order
    Aabb box;
    bool closed = false;  // true if each edge occurs exactly once in each direction
    // Volume of a closed shell; negative if the shell faces inwards, like the inside of a hollow or a room.
    double volume_m3 = 0.0;
};

// Returns the shells of a mesh, ordered by their first triangles. Corners at exactly the same position are treated as
// one. Cost: O(n log n).
std::vector<MeshShell> shells_of(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles);

// Returns the winding number around `at_m` of closed shells that consist of the triangles `which`: 1 inside, 0 outside
// or in a hollow. It sums solid angles, so the result does not depend on a ray that might hit an edge. Source: Van
// Oosterom and Strackee, The solid angle of a plane triangle, 1983.
int times_around(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles,
                 std::span<const std::uint32_t> which, const Vec3& at_m);

struct FillLimits {
    std::size_t most_triangles = 100'000, most_planes = 1'000, most_solids = 2'000;
    std::size_t most_faces = 64;  // greatest number of faces of one solid; a solid with more is cut in two
    // Budget for tests of a face against a plane, which take about 5 ns each. Several meshes may share one budget.
    std::size_t* looks_left = nullptr;
};

// Returns convex solids without gaps or overlaps that together fill closed shells. Space is cut by the planes of faces
// that have other faces in front of them, until each part is convex. Corners may be off by a 100,000th of the mesh's
// size. Returns nothing if a limit is reached, or if the volume of the solids differs from that of the shells, for
// example because a surface intersects itself. Source: Fuchs, Kedem and Naylor, On visible surface generation by a
// priori tree structures, 1980.
std::optional<std::vector<ConvexSolid>> solids_within(std::span<const Vec3> points_m,
                                                      std::span<const MeshCorners> triangles,
                                                      std::span<const std::uint32_t> which,
                                                      const FillLimits& limits = {}, const std::stop_token& stop = {});

}  // namespace handrail
