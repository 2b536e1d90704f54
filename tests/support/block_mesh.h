// Closed meshes of any form for tests: the skin of unit blocks set side by side, turned and stretched at will, with a
// way of its own to say what is inside: how often a ray goes through it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::test {

struct BlockMesh {
    std::vector<Vec3> points_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    bool holds(const Vec3& at_m) const;
    // From the planes of the faces, so at most the real one.
    double distance_m(const Vec3& at_m) const;
    // As one solid of an STL in words.
    std::string stl(const std::string& name) const;
    // As one thing of an .obj; `points` counts those of the things before.
    std::string obj(const std::string& name, std::size_t& points) const;
};

using Block = std::array<int, 3>;

// Corners of blocks at whole numbers, put where `place` says.
BlockMesh block_mesh(const std::set<Block>& blocks, const std::function<Vec3(const Vec3&)>& place);

// A table of four legs, 8 by 6 by 4 blocks.
std::set<Block> table_blocks();

// Three sides of a square, `high` blocks high.
std::set<Block> horseshoe_blocks(int wide, int high);

// A closed chest with nothing in it.
std::set<Block> hollow_blocks(int wide);

}  // namespace handrail::test
