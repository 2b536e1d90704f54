// Finds the closed pieces of meshes that are solid bodies. A body is filled with convex solids; if it is too finely
// made for that, only its outer surface can be touched. The remaining triangles are sheets. One reading thread.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "worlds/geometry/closed_mesh.h"

namespace handrail::readers {

struct MeshPiece {
    std::span<const Vec3> points_m;
    std::span<const MeshCorners> triangles;
};

struct MeshBody {
    std::size_t piece = 0;                 // index of its mesh
    std::vector<std::uint32_t> triangles;  // its triangles, including those of its hollows
    Aabb box;
    std::vector<ConvexSolid> solids;  // empty: only its outer surface can be touched
};

struct MeshBodies {
    std::vector<MeshBody> bodies;
    std::vector<std::vector<std::uint32_t>> rest;  // for each mesh, the triangles that belong to no body
};

// A closed piece that faces outwards is a body, together with the closed pieces inside it that face inwards. It is no
// body if it contains others, as the shell of a room does. It is no body either if it is convex and alone, because a
// person may stand in it. Fills at most 20,000 solids in all, for some seconds; for further bodies only the outer
// surface can be touched.
MeshBodies mesh_bodies(std::span<const MeshPiece> meshes, const std::stop_token& stop = {});

}  // namespace handrail::readers
