// Named triangle meshes to a Scene: what glTF, PLY and STL have in common. A closed mesh is solid (mesh_bodies says
// which and why not); all else are sheets that both sides can be touched of.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/readers/diagnostics.h"
#include "worlds/readers/reader.h"

namespace handrail {

inline constexpr std::size_t kMostMeshTriangles = 2'000'000;

struct MeshPart {
    std::uint32_t thing = 0;  // parts of one number are one thing, called by the first one's name
    std::string name;         // as the file has it
    std::string material;     // likewise
    std::vector<Vec3> points_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // places in points_m
};

struct MeshFile {
    std::string_view format;
    double metres_per_unit = 1.0;
    std::vector<MeshPart> parts;
    int parts_left_out = 0, faces_left_out = 0;
};

// Triangles with a point out of range or that is not there are left out and counted. Fails where nothing is left.
Result<Scene> scene_of_meshes(MeshFile file, Diagnostics diagnostics, const std::string& file_name,
                              const ReadOptions& options);

}  // namespace handrail
