// Makes closed meshes of any form for tests. A mesh is the outer surface of unit blocks side by side, which may be
// rotated and distorted. holds() tests independently whether a point is inside: it counts how often a ray crosses the
// surface.
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
    // Returns a distance computed from the planes of the faces, which never exceeds the real distance.
    double distance_m(const Vec3& at_m) const;
    // Returns the mesh as one solid of a text STL.
    std::string stl(const std::string& name) const;
    // Returns the mesh as one object of an .obj. `points` is the number of points in all objects before it. The
    // function adds the number of its own points.
    std::string obj(const std::string& name, std::size_t& points) const;
};

using Block = std::array<int, 3>;

// Makes the mesh of these blocks. `place` maps the corners of the blocks, which have whole coordinates, to points.
BlockMesh block_mesh(const std::set<Block>& blocks, const std::function<Vec3(const Vec3&)>& place);

// Returns a table with four legs, 8 by 6 by 4 blocks.
std::set<Block> table_blocks();

// Returns three sides of a square, `high` blocks high.
std::set<Block> horseshoe_blocks(int wide, int high);

// Returns a closed, empty chest.
std::set<Block> hollow_blocks(int wide);

}  // namespace handrail::test
