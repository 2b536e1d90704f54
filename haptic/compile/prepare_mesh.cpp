#include "haptic/compile/prepare_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "haptic/compile/simplify_mesh.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::compile {
namespace {

constexpr std::uint32_t kNoPoint = 0xFFFFFFFFU;
// A triangle whose height over its longest edge is less than this feels like that edge.
constexpr double kLowest_m = 1e-7;

// Finds points by a key of three integers. It is a hash table with open addressing, which stores indices of points.
class PointTable {
public:
    using Key = std::array<std::int64_t, 3>;

    explicit PointTable(std::size_t most) : slots_(std::bit_ceil(2 * most + 2), kNoPoint) { keys_.reserve(most); }

    // Calls visit(point) for the points with this key.
    template <class Visit>
    void each(const Key& key, Visit&& visit) const {
        for (std::size_t i = hash(key);; ++i) {
            const std::uint32_t point = slots_[i & (slots_.size() - 1)];
            if (point == kNoPoint) return;
            if (keys_[point] == key) visit(point);
        }
    }
    // Adds the next point with its key. Call it for points in rising order from 0.
    void add(const Key& key) {
        std::size_t i = hash(key);
        while (slots_[i & (slots_.size() - 1)] != kNoPoint) ++i;
        slots_[i & (slots_.size() - 1)] = static_cast<std::uint32_t>(keys_.size());
        keys_.push_back(key);
    }

private:
    static std::size_t hash(const Key& key) {
        std::uint64_t h = 0;
        for (const std::int64_t part : key) {
            h = (h ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15ULL;
            h ^= h >> 32;
        }
        return static_cast<std::size_t>(h);
    }
    std::vector<std::uint32_t> slots_;
    std::vector<Key> keys_;
};

using Sorted = std::array<std::uint32_t, 3>;
Sorted sorted(const Corners& t) {
    Sorted s = t;
    std::sort(s.begin(), s.end());
    return s;
}

// Returns the corners of a triangle's longest edge, the lower index first. Both are equal if the triangle is only a
// point.
std::pair<std::uint32_t, std::uint32_t> longest_edge(const TriangleMesh& mesh, const Corners& t) {
    double longest = -1.0;
    std::pair<std::uint32_t, std::uint32_t> edge{t[0], t[0]};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        const double length = glm::length(mesh.points_m[b] - mesh.points_m[a]);
        if (length > longest) {
            longest = length;
            edge = std::minmax(a, b);
        }
    }
    return edge;
}

bool has_area(const TriangleMesh& mesh, const Corners& t) {
    const Vec3 a = mesh.points_m[t[0]], b = mesh.points_m[t[1]], c = mesh.points_m[t[2]];
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    return longest > 0.0 && glm::length(glm::cross(b - a, c - a)) > kLowest_m * longest;
}

void keep(TriangleMesh& mesh, std::vector<std::uint32_t>& surfaces, const std::vector<bool>& dropped) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (dropped[t]) continue;
        mesh.triangles[kept] = mesh.triangles[t];
        surfaces[kept++] = surfaces[t];
    }
    mesh.triangles.resize(kept);
    surfaces.resize(kept);
}

// Drops degenerate triangles without area, but only if their longest edge is also an edge of a triangle with area, so
// that no edge disappears. A triangle that is only a point is dropped if the point is a corner of a triangle with area.
// Of several triangles with the same corners and surface, only the first stays.
void tidy_triangles(TriangleMesh& mesh, std::vector<std::uint32_t>& surfaces, MeshReport& report) {
    std::vector<bool> dropped(mesh.triangles.size(), false), flat(mesh.triangles.size(), false),
        used(mesh.points_m.size(), false);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Corners& c = mesh.triangles[t];
        flat[t] = !has_area(mesh, c);
        for (std::size_t k = 0; k < 3 && !flat[t]; ++k) {
            edges.push_back(std::minmax(c[k], c[(k + 1) % 3]));
            used[c[k]] = true;
        }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!flat[t]) continue;
        const auto edge = longest_edge(mesh, mesh.triangles[t]);
        dropped[t] =
            edge.first == edge.second ? used[edge.first] : std::binary_search(edges.begin(), edges.end(), edge);
        report.without_area += dropped[t];
    }
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t t) { return std::pair(sorted(mesh.triangles[t]), surfaces[t]); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto ka = key(a), kb = key(b);
        return ka != kb ? ka < kb : a < b;
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (key(order[i]) != key(order[i - 1]) || dropped[order[i]]) continue;
        dropped[order[i]] = true;
        ++report.repeated;
    }
    keep(mesh, surfaces, dropped);
}

// Returns for each surface the indices of its triangles.
std::vector<std::vector<std::uint32_t>> by_surface(std::span<const std::uint32_t> surfaces) {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (std::uint32_t t = 0; t < surfaces.size(); ++t) {
        if (surfaces[t] >= triangles.size()) triangles.resize(surfaces[t] + std::size_t{1});
        triangles[surfaces[t]].push_back(t);
    }
    return triangles;
}

// The mesh of one surface alone. Points on its borders with other surfaces are fixed.
struct SurfaceAlone {
    TriangleMesh mesh;
    std::vector<std::uint32_t> point_of;  // for each point, its index in the whole mesh
    std::vector<bool> fixed;
};
SurfaceAlone surface_alone(const TriangleMesh& whole, std::span<const std::uint32_t> triangles,
                           const std::vector<bool>& at_border) {
    SurfaceAlone alone;
    std::vector<std::uint32_t> place(whole.points_m.size(), kNoPoint);
    for (const std::uint32_t t : triangles) {
        Corners corners = whole.triangles[t];
        for (std::uint32_t& corner : corners) {
            if (place[corner] == kNoPoint) {
                place[corner] = static_cast<std::uint32_t>(alone.point_of.size());
                alone.point_of.push_back(corner);
                alone.mesh.points_m.push_back(whole.points_m[corner]);
                alone.fixed.push_back(at_border[corner]);
            }
            corner = place[corner];
        }
        alone.mesh.triangles.push_back(corners);
    }
    return alone;
}

// Simplifies each dense surface. In the resulting mesh, the triangles of the other surfaces come first, in their old
// order.
void simplify_surfaces(TriangleMesh& mesh, std::vector<std::uint32_t>& surfaces, const MeshOptions& options,
                       const std::stop_token& stop, const SurfaceBegins& begins, PreparedMesh& out) {
    MeshReport& report = out.report;
    report.simplify_bound_m = options.simplify_m;
    std::vector<std::uint32_t> surface_of(mesh.points_m.size(), kNoPoint);
    std::vector<bool> at_border(mesh.points_m.size(), false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t corner : mesh.triangles[t]) {
            if (surface_of[corner] == kNoPoint) surface_of[corner] = surfaces[t];
            else if (surface_of[corner] != surfaces[t]) at_border[corner] = true;
        }
    std::vector<bool> dropped(mesh.triangles.size(), false);
    std::vector<Corners> coarser;
    std::vector<std::uint32_t> coarser_surfaces;
    const auto triangles_of = by_surface(surfaces);
    for (std::uint32_t surface = 0; surface < triangles_of.size(); ++surface) {
        const std::vector<std::uint32_t>& triangles = triangles_of[surface];
        if (triangles.empty() || triangles.size() < options.simplify_from) continue;
        if (stop.stop_requested()) break;
        if (begins) begins(surface, triangles.size());
        const SurfaceAlone alone = surface_alone(mesh, triangles, at_border);
        const SimplifiedMesh coarse = simplify_mesh(alone.mesh, alone.fixed, options.simplify_m, stop);
        report.simplify_spacing_m = std::max(report.simplify_spacing_m, coarse.spacing_m);
        const std::size_t after = coarse.mesh.triangles.size();
        if (after == triangles.size()) continue;
        report.simplify_measured_m = std::max(report.simplify_measured_m, coarse.measured_m);
        report.simplified += triangles.size() - after;
        out.coarser.push_back({surface, triangles.size(), after, coarse.measured_m});
        for (const std::uint32_t t : triangles) dropped[t] = true;
        for (Corners corners : coarse.mesh.triangles) {
            for (std::uint32_t& corner : corners) corner = alone.point_of[corner];
            coarser.push_back(corners);
            coarser_surfaces.push_back(surface);
        }
    }
    keep(mesh, surfaces, dropped);
    mesh.triangles.insert(mesh.triangles.end(), coarser.begin(), coarser.end());
    surfaces.insert(surfaces.end(), coarser_surfaces.begin(), coarser_surfaces.end());
}

// Leaves out points that no triangle uses.
void compact(TriangleMesh& mesh) {
    std::vector<std::uint32_t> place(mesh.points_m.size(), kNoPoint);
    std::vector<Vec3> points;
    for (Corners& t : mesh.triangles)
        for (std::uint32_t& corner : t) {
            if (place[corner] == kNoPoint) {
                place[corner] = static_cast<std::uint32_t>(points.size());
                points.push_back(mesh.points_m[corner]);
            }
            corner = place[corner];
        }
    mesh.points_m = std::move(points);
    mesh.points_m.shrink_to_fit();
}

// Converts to millimetres and rounds values below a millimetre to two digits. Values below a millionth of a millimetre
// become 0.
double in_millimetres(double m) {
    if (m < 1e-9) return 0.0;
    if (m >= 1e-3) return 1e3 * m;
    const double digits = std::pow(10.0, 1.0 - std::floor(std::log10(1e3 * m)));
    return std::round(1e3 * m * digits) / digits;
}

}  // namespace

TriangleMesh weld_corners(std::span<const Vec3> corners_m, double tolerance_m, MeshReport& report) {
    contract_pre(corners_m.size() % 3 == 0);
    contract_pre(tolerance_m >= 0.0);
    TriangleMesh mesh;
    mesh.triangles.resize(corners_m.size() / 3);
    PointTable table(corners_m.size());
    // The distinct positions seen before, and for each position the welded point that replaces it.
    std::vector<Vec3> distinct;
    std::vector<std::uint32_t> stands_for;
    const auto bits = [](double v) { return std::bit_cast<std::int64_t>(v == 0.0 ? 0.0 : v); };
    PointTable cells(tolerance_m > 0.0 ? corners_m.size() : 0);
    const auto cell = [&](double v) {
        return static_cast<std::int64_t>(std::floor(std::clamp(v / tolerance_m, -9e17, 9e17)));
    };
    for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i) {
        const Vec3& p = corners_m[i];
        const PointTable::Key exact{bits(p.x), bits(p.y), bits(p.z)};
        std::uint32_t met = kNoPoint;
        table.each(exact, [&](std::uint32_t point) { met = point; });
        if (met == kNoPoint) {
            std::uint32_t one = kNoPoint;
            double nearest = tolerance_m;
            if (tolerance_m > 0.0)
                for (int dx = -1; dx <= 1; ++dx)
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dz = -1; dz <= 1; ++dz)
                            cells.each({cell(p.x) + dx, cell(p.y) + dy, cell(p.z) + dz}, [&](std::uint32_t point) {
                                const double distance = glm::length(mesh.points_m[point] - p);
                                if (distance > nearest || (distance == nearest && one < point)) return;
                                nearest = distance;
                                one = point;
                            });
            if (one == kNoPoint) {
                one = static_cast<std::uint32_t>(mesh.points_m.size());
                mesh.points_m.push_back(p);
                if (tolerance_m > 0.0) cells.add({cell(p.x), cell(p.y), cell(p.z)});
            } else {
                ++report.points_welded;
                report.farthest_weld_m = std::max(report.farthest_weld_m, nearest);
            }
            met = static_cast<std::uint32_t>(stands_for.size());
            table.add(exact);
            stands_for.push_back(one);
        }
        mesh.triangles[i / 3][i % 3] = stands_for[met];
    }
    return mesh;
}

PreparedMesh prepare_mesh(std::span<const Vec3> corners_m, std::span<const std::uint32_t> surfaces,
                          const MeshOptions& options, const std::stop_token& stop, const SurfaceBegins& begins) {
    contract_pre(corners_m.size() == 3 * surfaces.size());
    contract_pre(options.simplify_m >= 0.0);
    PreparedMesh out;
    MeshReport& report = out.report;
    report.triangles = surfaces.size();
    TriangleMesh mesh = weld_corners(corners_m, options.weld_m, report);
    std::vector<std::uint32_t> own(surfaces.begin(), surfaces.end());
    if (options.tidy) tidy_triangles(mesh, own, report);
    if (options.simplify_m > 0.0) simplify_surfaces(mesh, own, options, stop, begins, out);
    if (options.merge) {
        FlatMerge flat = merge_flat(mesh, own, options.flat_m, options.keep_curves);
        report.flat_bound_m = options.flat_m;
        report.flat_measured_m = flat.farthest_m;
        report.polygons = flat.polygons.size();
        std::vector<bool> dropped(mesh.triangles.size(), false);
        for (FlatPolygon& polygon : flat.polygons) {
            report.merged += polygon.triangles.size();
            out.polygon_surfaces.push_back(own[polygon.triangles.front()]);
            for (const std::uint32_t t : polygon.triangles) dropped[t] = true;
            polygon.triangles.clear();
            polygon.triangles.shrink_to_fit();
        }
        out.polygons = std::move(flat.polygons);
        keep(mesh, own, dropped);
    }
    compact(mesh);
    out.mesh = std::move(mesh);
    out.surfaces = std::move(own);
    return out;
}

MeshReport& MeshReport::operator+=(const MeshReport& other) {
    for (const auto count :
         {&MeshReport::triangles, &MeshReport::points_welded, &MeshReport::without_area, &MeshReport::repeated,
          &MeshReport::simplified, &MeshReport::merged, &MeshReport::polygons})
        this->*count += other.*count;
    for (const auto length :
         {&MeshReport::farthest_weld_m, &MeshReport::simplify_bound_m, &MeshReport::simplify_measured_m,
          &MeshReport::simplify_spacing_m, &MeshReport::flat_bound_m, &MeshReport::flat_measured_m})
        this->*length = std::max(this->*length, other.*length);
    return *this;
}

std::vector<std::string> MeshReport::sentences() const {
    std::vector<std::string> said;
    if (points_welded > 0)
        said.push_back(phrase("compile.welded", {{"n", points_welded}, {"far", in_millimetres(farthest_weld_m)}}));
    if (without_area > 0) said.push_back(phrase("compile.without_area", {{"n", without_area}}));
    if (repeated > 0) said.push_back(phrase("compile.repeated", {{"n", repeated}}));
    if (simplified > 0)
        said.push_back(phrase("compile.simplified", {{"n", simplified},
                                                     {"far", in_millimetres(simplify_measured_m)},
                                                     {"bound", in_millimetres(simplify_bound_m)},
                                                     {"spacing", in_millimetres(simplify_spacing_m)}}));
    if (merged > 0)
        said.push_back(phrase("compile.merged", {{"n", merged},
                                                 {"polygons", polygons},
                                                 {"far", in_millimetres(flat_measured_m)},
                                                 {"bound", in_millimetres(flat_bound_m)}}));
    return said;
}

}  // namespace handrail::compile
