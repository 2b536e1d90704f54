// Closed meshes of any form for tests: the outer surface of unit blocks side by side, turned and stretched at will. Has
// an independent test for what is inside: how often a ray crosses the surface.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "worlds/base/vec.h"

namespace handrail::test {

struct BlockMesh {
    std::vector<Vec3> points_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    bool holds(const Vec3& at_m) const;
    // Computed from the planes of the faces, so it never exceeds the real distance.
    double distance_m(const Vec3& at_m) const;
    // The mesh as one solid of a text STL.
    std::string stl(const std::string& name) const;
    // The mesh as one object of an .obj; `points` counts the points of all objects before it.
    std::string obj(const std::string& name, std::size_t& points) const;
};

using Block = std::array<int, 3>;

// `place` maps the corners of the blocks, which are at whole numbers, to points.
BlockMesh block_mesh(const std::set<Block>& blocks, const std::function<Vec3(const Vec3&)>& place);

// A table with four legs, 8 by 6 by 4 blocks.
std::set<Block> table_blocks();

// Three sides of a square, `high` blocks high.
std::set<Block> horseshoe_blocks(int wide, int high);

// A closed, empty chest.
std::set<Block> hollow_blocks(int wide);

}  // namespace handrail::test
