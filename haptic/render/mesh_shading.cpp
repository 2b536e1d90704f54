#include "haptic/render/mesh_shading.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace handrail::render {
namespace {

constexpr double kFlat_m = 1e-9;  // a smaller rise is treated as a rounding error

std::vector<std::uint32_t> welded(std::span<const Vec3> points) {
    std::map<std::tuple<double, double, double>, std::uint32_t> known;
    std::vector<std::uint32_t> first(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        first[i] = known.try_emplace({points[i].x, points[i].y, points[i].z}, i).first->second;
    return first;
}

double angle_between(const Vec3& a, const Vec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0.0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0.0;
}

// Returns the slope of a facet's rise at its steepest corner.
double steepest(const std::array<Vec3, 3>& p, const MeshShading::Facet& facet) {
    const Vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double size2 = glm::dot(normal, normal);
    if (size2 <= 0.0) return 0.0;
    std::array<Vec3, 3> slope;
    for (std::size_t i = 0; i < 3; ++i) slope[i] = glm::cross(normal, p[(i + 2) % 3] - p[(i + 1) % 3]) / size2;
    double most = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
        most = std::max(most, 4.0 * glm::length(slope[next] * static_cast<double>(facet.sagitta_m[i]) +
                                                slope[last] * static_cast<double>(facet.sagitta_m[last])));
    }
    return most;
}

}  // namespace

MeshShading shade_mesh(std::span<const Vec3> points, std::span<const Corners> triangles, double crease_cosine) {
    MeshShading shading;
    const std::vector<std::uint32_t> weld = welded(points);
    const auto count = static_cast<std::uint32_t>(triangles.size());
    shading.facets.resize(count);
    std::vector<std::array<Vec3, 3>> corners(count);
    std::vector<Vec3> normals(count, Vec3(0.0));  // unit vectors; zero for a facet without area
    for (std::uint32_t t = 0; t < count; ++t) {
        for (std::size_t k = 0; k < 3; ++k) corners[t][k] = points[triangles[t][k]];
        const Vec3 n = glm::cross(corners[t][1] - corners[t][0], corners[t][2] - corners[t][0]);
        if (const double size = glm::length(n); size > 0.0) normals[t] = n / size;
    }
    // 1. Finds the edges by their ends. An edge is smooth if two facets use it in opposite directions and the angle
    //   between the facets is small.
    struct EdgeSide {
        std::uint32_t triangle, edge;
        bool forward;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<EdgeSide>> edges;
    for (std::uint32_t t = 0; t < count; ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = weld[triangles[t][k]], b = weld[triangles[t][(k + 1) % 3]];
            if (a != b) edges[std::minmax(a, b)].push_back({t, k, a < b});
        }
    // 2. Groups corners that share a normal, by joining them over smooth edges.
    std::vector<std::uint32_t> root(std::size_t{3} * count);
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&root](std::uint32_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    std::vector<std::pair<EdgeSide, EdgeSide>> smooth;
    for (const auto& [ends, sides] : edges) {
        if (sides.size() != 2 || sides[0].forward == sides[1].forward || sides[0].triangle == sides[1].triangle)
            continue;
        if (glm::dot(normals[sides[0].triangle], normals[sides[1].triangle]) < crease_cosine) continue;
        smooth.emplace_back(sides[0], sides[1]);
        const auto corner = [](const EdgeSide& side, std::uint32_t end) {
            return 3 * side.triangle + (side.edge + end) % 3;
        };
        root[find(corner(sides[0], 0))] = find(corner(sides[1], 1));
        root[find(corner(sides[0], 1))] = find(corner(sides[1], 0));
    }
    std::vector<Vec3> corner_normals(root.size(), Vec3(0.0));
    for (std::uint32_t t = 0; t < count; ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            corner_normals[find(3 * t + k)] += normals[t] * angle_between(corners[t][(k + 1) % 3] - corners[t][k],
                                                                          corners[t][(k + 2) % 3] - corners[t][k]);
    for (Vec3& n : corner_normals)
        if (const double size = glm::length(n); size > 0.0) n /= size;
    // 3. Computes the rises of the edges.
    for (const auto& [one, other] : smooth) {
        const std::uint32_t next = (one.edge + 1) % 3;
        const Vec3 way = corners[one.triangle][next] - corners[one.triangle][one.edge];
        const Vec3 turn =
            corner_normals[find(3 * one.triangle + next)] - corner_normals[find(3 * one.triangle + one.edge)];
        const double rise = 0.125 * glm::dot(turn, way);
        const float sagitta = std::abs(rise) > kFlat_m ? static_cast<float>(rise) : 0.0F;
        for (const auto& [side, opposite] : {std::pair(one, other), std::pair(other, one)}) {
            shading.facets[side.triangle].sagitta_m[side.edge] = sagitta;
            shading.facets[side.triangle].across[side.edge] = opposite.triangle;
        }
    }
    // 4. Flattens facets that would be too steep, together with the halves of their edges on the neighbouring facets.
    //   Flattening never makes another facet steeper than its own edges require, so a few passes are enough.
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t t = 0; t < count; ++t) {
            if (steepest(corners[t], shading.facets[t]) <= MeshShading::kSteepest) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                if (shading.facets[t].sagitta_m[k] == 0.0F) continue;
                shading.facets[t].sagitta_m[k] = 0.0F;
                changed = true;
                MeshShading::Facet& neighbour = shading.facets[shading.facets[t].across[k]];
                for (std::size_t j = 0; j < 3; ++j)
                    if (neighbour.across[j] == t) neighbour.sagitta_m[j] = 0.0F;
            }
        }
    }
    for (const MeshShading::Facet& facet : shading.facets)
        for (const float s : facet.sagitta_m)
            // The sum of the products l_i l_j is at most 1/3.
            shading.highest_m = std::max(shading.highest_m, 4.0 / 3.0 * std::abs(static_cast<double>(s)));
    return shading;
}

}  // namespace handrail::render
