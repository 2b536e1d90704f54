// Turns named triangle meshes into a Scene. The readers of glTF, PLY and STL share it. Closed meshes become solids
// (mesh_bodies chooses which). All other triangles become sheets that can be touched from both sides.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/readers/diagnostics.h"
#include "worlds/readers/reader.h"

namespace handrail::readers {

inline constexpr std::size_t kMostMeshTriangles = 2'000'000;

struct MeshPart {
    // Parts with the same number are one object, which has the name of the first of these parts.
    std::uint32_t thing = 0;
    std::string name;      // name as the file states it
    std::string material;  // name of the material as the file states it
    std::vector<Vec3> points_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // corners of each triangle, as indices into points_m
};

struct MeshFile {
    std::string_view format;
    double metres_per_unit = 1.0;
    std::vector<MeshPart> parts;
    int parts_left_out = 0, faces_left_out = 0;
};

// Makes the scene. Triangles with a missing or illegal point are left out and counted. Fails if no triangle is left.
Result<Scene> scene_of_meshes(MeshFile file, Diagnostics diagnostics, const std::string& file_name,
                              const ReadOptions& options);

}  // namespace handrail::readers
