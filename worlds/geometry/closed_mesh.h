// Triangle meshes as the skin of something: which pieces of one are closed, what lies inside, and the convex solids
// that fill them. Pure functions on plain values, any thread; metres. Triangles are three places in `points_m`; seen
// from outside their corners run counter-clockwise.
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

// Triangles that hang together by their edges: a piece of a mesh.
struct MeshShell {
    std::vector<std::uint32_t> triangles;  // their places in the mesh, rising
    Aabb box;
    bool closed = false;     // each edge is gone along once in each direction
    double volume_m3 = 0.0;  // of a closed one; negative: seen from inside, as a hollow or a room
};

// In the order of their first triangles. Corners in exactly the same place are one. O(n log n).
std::vector<MeshShell> shells_of(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles);

// How many times closed shells of the given triangles go round a place: 1 inside, 0 outside or in a hollow. By the
// solid angles that they are seen at, so that no ray can meet an edge. Source: Van Oosterom and Strackee, The solid
// angle of a plane triangle, 1983.
int times_around(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles,
                 std::span<const std::uint32_t> which, const Vec3& at_m);

struct FillLimits {
    std::size_t most_triangles = 100'000, most_planes = 1'000, most_solids = 2'000;
    std::size_t most_faces = 64;        // of one solid; rounder ones are cut in two
    std::size_t* looks_left = nullptr;  // of faces at planes, shared by several meshes; some 5 ns each
};

// Convex solids without gaps and overlaps that together hold what closed shells enclose: the space is cut by the planes
// of faces beyond which others lie, until in each part the rest is convex. Corners may be off by a 100,000th of the
// mesh's size. Nothing where the limits are reached, or where the solids hold another volume than the shells do, as
// with a skin that goes through itself. Source: Fuchs, Kedem and Naylor, On visible surface generation by a priori tree
// structures, 1980.
std::optional<std::vector<ConvexSolid>> solids_within(std::span<const Vec3> points_m,
                                                      std::span<const MeshCorners> triangles,
                                                      std::span<const std::uint32_t> which,
                                                      const FillLimits& limits = {}, const std::stop_token& stop = {});

}  // namespace handrail
