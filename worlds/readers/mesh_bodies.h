// Which closed pieces of meshes are bodies: filled by convex solids, or, where they are too finely made for that, skins
// that are touched from outside only. What is left of the meshes are sheets. One reading thread.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "worlds/geometry/closed_mesh.h"

namespace handrail {

struct MeshPiece {
    std::span<const Vec3> points_m;
    std::span<const MeshCorners> triangles;
};

struct MeshBody {
    std::size_t piece = 0;                 // its place in the meshes
    std::vector<std::uint32_t> triangles;  // of it, with those of its hollows
    Aabb box;
    std::vector<ConvexSolid> solids;  // none: its skin is touched from outside
};

struct MeshBodies {
    std::vector<MeshBody> bodies;
    std::vector<std::vector<std::uint32_t>> rest;  // of each mesh, triangles that are no part of a body
};

// A closed piece that is seen from outside is a body, together with the closed pieces in it that are seen from inside.
// It is none where others lie in it, as in the shell of a room, or where it is convex and alone, since one may stand in
// that. At most 20,000 solids in all, and some seconds of filling; what comes after is touched from outside.
MeshBodies mesh_bodies(std::span<const MeshPiece> meshes, const std::stop_token& stop = {});

}  // namespace handrail
