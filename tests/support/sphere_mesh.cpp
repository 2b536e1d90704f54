#include "tests/support/sphere_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "tests/support/names.h"
#include "worlds/base/vec.h"

namespace handrail::test {
namespace {

constexpr Corners kIcosahedron[20] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

}  // namespace

TriangleMesh sphere_mesh(int frequency, double radius_m) {
    const double t = (1.0 + std::sqrt(5.0)) / 2.0;
    TriangleMesh mesh;
    mesh.points_m = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                     {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>
        edges;  // maps two corners, the lower index first, to the first of the points between them
    const auto n = static_cast<std::uint32_t>(frequency);
    const auto add = [&](const Vec3& p) { mesh.points_m.push_back(p); };
    // Returns the point k steps from corner a on the edge to corner b.
    const auto on_edge = [&](std::uint32_t a, std::uint32_t b, std::uint32_t k) {
        if (k == 0) return a;
        if (k == n) return b;
        const auto [low, high] = std::minmax(a, b);
        const auto [found, is_new] = edges.try_emplace({low, high}, static_cast<std::uint32_t>(mesh.points_m.size()));
        if (is_new)
            for (std::uint32_t i = 1; i < n; ++i)
                add((mesh.points_m[low] * static_cast<double>(n - i) + mesh.points_m[high] * static_cast<double>(i)) /
                    static_cast<double>(n));
        return found->second + (a == low ? k : n - k) - 1;
    };
    for (const auto& [a, b, c] : kIcosahedron) {
        // Rows of points, from corner a to the edge bc; row i has i + 1 points.
        std::vector<std::vector<std::uint32_t>> rows;
        for (std::uint32_t i = 0; i <= n; ++i) {
            std::vector<std::uint32_t>& row = rows.emplace_back();
            for (std::uint32_t k = 0; k <= i; ++k) {
                if (k == 0) row.push_back(on_edge(a, b, i));
                else if (k == i) row.push_back(on_edge(a, c, i));
                else if (i == n) row.push_back(on_edge(b, c, k));
                else {
                    row.push_back(static_cast<std::uint32_t>(mesh.points_m.size()));
                    add((mesh.points_m[a] * static_cast<double>(n - i) + mesh.points_m[b] * static_cast<double>(i - k) +
                         mesh.points_m[c] * static_cast<double>(k)) /
                        static_cast<double>(n));
                }
            }
        }
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t k = 0; k <= i; ++k) {
                mesh.triangles.push_back({rows[i][k], rows[i + 1][k], rows[i + 1][k + 1]});
                if (k < i) mesh.triangles.push_back({rows[i][k], rows[i + 1][k + 1], rows[i][k + 1]});
            }
    }
    for (Vec3& p : mesh.points_m) p *= radius_m / glm::length(p);
    mesh.points_m.shrink_to_fit();
    mesh.triangles.shrink_to_fit();
    return mesh;
}

TriangleMesh pole_mesh(int sectors, int rings, double ring_m, double sphere_radius_m) {
    TriangleMesh mesh;
    mesh.points_m.push_back({0.0, 0.0, sphere_radius_m});
    const auto at = [&](int ring, int sector) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors);
    };
    for (int ring = 1; ring <= rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            const double down = ring * ring_m / sphere_radius_m, round = 2.0 * kPi * sector / sectors;
            mesh.points_m.push_back(
                Vec3(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down)) *
                sphere_radius_m);
        }
    for (int sector = 0; sector < sectors; ++sector) {
        mesh.triangles.push_back({0, at(1, sector), at(1, sector + 1)});
        for (int ring = 1; ring < rings; ++ring) {
            mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1)});
            mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)});
        }
    }
    return mesh;
}

std::vector<Vec3> pole_slide(double sphere_radius_m, double proxy_radius_m, double speed_m_per_s, int ticks) {
    constexpr double kFar_m = 0.02, kAside_m = 1e-3, kDeep_m = 3e-3, kDown_m_per_tick = 2e-4;
    std::vector<Vec3> goals;
    double height = 0.02, phase = 0.0;
    for (int i = 0; i < ticks; ++i) {
        if (height > -kDeep_m + kDown_m_per_tick) {
            height -= kDown_m_per_tick;
        } else {
            height = -kDeep_m;
            phase += speed_m_per_s * 1e-3 / kFar_m;
        }
        const double along = kFar_m * std::cos(phase), aside = kAside_m * std::sin(0.37 * phase), turn = 0.11 * phase;
        const Vec3 place(along * std::cos(turn) - aside * std::sin(turn),
                         along * std::sin(turn) + aside * std::cos(turn), 0.0);
        goals.push_back(glm::normalize(place + Vec3(0.0, 0.0, sphere_radius_m)) *
                        (sphere_radius_m + proxy_radius_m + height));
    }
    return goals;
}

std::vector<Vec3> sphere_slide(double sphere_radius_m, double proxy_radius_m, double speed_m_per_s, int ticks) {
    constexpr double kDown_m_per_tick = 2e-4, kShallow_m = 2e-3, kDeep_m = 5e-3;
    std::vector<Vec3> goals;
    Vec3 out = glm::normalize(Vec3(0.3, -0.2, 0.93)), along = glm::normalize(glm::cross(Vec3(0.2, 1.0, 0.1), out));
    double height = 0.02;
    for (int i = 0; i < ticks; ++i) {
        const double wave = 0.5 - 0.5 * std::cos(2.0 * kPi * i / 700.0);
        const double wanted = -(kShallow_m + (kDeep_m - kShallow_m) * wave);
        if (height > wanted + kDown_m_per_tick) {
            height -= kDown_m_per_tick;
        } else {
            height = wanted;
            // The path follows a great circle that turns by a third of a radian per metre, so that its laps do not
            // coincide.
            const double angle = speed_m_per_s * 1e-3 / sphere_radius_m;
            out = glm::normalize(out + along * angle);
            along += glm::cross(out, along) * (speed_m_per_s * 1e-3 / 3.0);
            along = glm::normalize(along - out * glm::dot(out, along));
        }
        goals.push_back(out * (sphere_radius_m + proxy_radius_m + height));
    }
    return goals;
}

}  // namespace handrail::test
