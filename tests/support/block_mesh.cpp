#include "tests/support/block_mesh.h"
#include "tests/support/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace handrail::test {

// Counts how often a ray from the point crosses the surface. The ray's direction is parallel to no face.
bool BlockMesh::holds(const Vec3& at_m) const {
    const Vec3 way = glm::normalize(Vec3(0.6180339, 0.4142135, 0.7320508));
    int through = 0;
    for (const auto& [a, b, c] : triangles) {
        const Vec3 u = points_m[b] - points_m[a], v = points_m[c] - points_m[a], p = glm::cross(way, v);
        const double det = glm::dot(u, p);
        if (std::abs(det) < 1e-15) continue;
        const Vec3 off = at_m - points_m[a], q = glm::cross(off, u);
        const double s = glm::dot(off, p) / det, t = glm::dot(way, q) / det;
        through += s >= 0.0 && t >= 0.0 && s + t <= 1.0 && glm::dot(v, q) / det > 0.0 ? 1 : 0;
    }
    return through % 2 == 1;
}

double BlockMesh::distance_m(const Vec3& at_m) const {
    double least = 1e300;
    for (const auto& [a, b, c] : triangles)
        least = std::min(
            least, std::abs(glm::dot(glm::normalize(glm::cross(points_m[b] - points_m[a], points_m[c] - points_m[a])),
                                     at_m - points_m[a])));
    return least;
}

std::string BlockMesh::stl(const std::string& name) const {
    std::string text = "solid " + name + "\n";
    for (const auto& triangle : triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t corner : triangle)
            text += fmt::format("vertex {} {} {}\n", points_m[corner].x, points_m[corner].y, points_m[corner].z);
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid\n";
}

std::string BlockMesh::obj(const std::string& name, std::size_t& points) const {
    std::string text = "o " + name + "\n";
    for (const Vec3& p : points_m) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : triangles)
        text += fmt::format("f {} {} {}\n", points + a + 1, points + b + 1, points + c + 1);
    points += points_m.size();
    return text;
}

BlockMesh block_mesh(const std::set<Block>& blocks, const std::function<Vec3(const Vec3&)>& place) {
    BlockMesh mesh;
    std::map<Block, std::uint32_t> numbers;
    const auto corner = [&](const Block& at) {
        const auto [found, is_new] = numbers.try_emplace(at, static_cast<std::uint32_t>(mesh.points_m.size()));
        if (is_new) mesh.points_m.push_back(place(Vec3(at[0], at[1], at[2])));
        return found->second;
    };
    for (const Block& block : blocks)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                Block next = block;
                next[axis] += side == 1 ? 1 : -1;
                if (blocks.contains(next)) continue;
                const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                std::array<std::uint32_t, 4> face{};
                for (std::size_t k = 0; k < 4; ++k) {
                    Block at = block;
                    at[axis] += side;
                    at[u] += k == 1 || k == 2 ? 1 : 0;
                    at[v] += k >= 2 ? 1 : 0;
                    face[k] = corner(at);
                }
                if (side == 0) std::swap(face[1], face[3]);
                mesh.triangles.push_back({face[0], face[1], face[2]});
                mesh.triangles.push_back({face[0], face[2], face[3]});
            }
    return mesh;
}

std::set<Block> table_blocks() {
    std::set<Block> blocks;
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 6; ++y) blocks.insert({x, y, 3});
    for (const int x : {0, 7})
        for (const int y : {0, 5})
            for (int z = 0; z < 3; ++z) blocks.insert({x, y, z});
    return blocks;
}

std::set<Block> horseshoe_blocks(int wide, int high) {
    std::set<Block> blocks;
    for (int i = 0; i < wide; ++i)
        for (int z = 0; z < high; ++z) {
            blocks.insert({i, 0, z});
            blocks.insert({0, i, z});
            blocks.insert({wide - 1, i, z});
        }
    return blocks;
}

std::set<Block> hollow_blocks(int wide) {
    std::set<Block> blocks;
    for (int x = 0; x < wide; ++x)
        for (int y = 0; y < wide; ++y)
            for (int z = 0; z < wide; ++z)
                if (std::min({x, y, z}) == 0 || std::max({x, y, z}) == wide - 1) blocks.insert({x, y, z});
    return blocks;
}

}  // namespace handrail::test
