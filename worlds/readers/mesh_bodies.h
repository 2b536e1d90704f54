// Finds the closed pieces of meshes that are solid bodies. A body is filled with convex solids. If it has too many
// faces for that, only its outer surface can be touched. The remaining triangles are sheets. Used on the reading thread
// only.
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
    std::size_t piece = 0;                 // index of the mesh that the body is in
    std::vector<std::uint32_t> triangles;  // triangles of the body, including those of its hollows
    Aabb box;
    std::vector<ConvexSolid> solids;  // the solids that fill the body; empty: only its outer surface can be touched
};

struct MeshBodies {
    std::vector<MeshBody> bodies;
    std::vector<std::vector<std::uint32_t>> rest;  // for each mesh, the triangles that belong to no body
};

// Finds the bodies. A closed piece that faces outwards is a body, together with the closed pieces inside it that face
// inwards. There are two exceptions. A piece that contains other pieces is no body, because it may be the shell of a
// room. A piece that is convex and the only one is no body either, because a person may stand in it. Fills bodies with
// at most 20,000 solids in all, which takes some seconds. Of further bodies only the outer surface can be touched.
MeshBodies mesh_bodies(std::span<const MeshPiece> meshes, const std::stop_token& stop = {});

}  // namespace handrail::readers
