#include "worlds/geometry/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "worlds/base/contract.h"
#include "worlds/geometry/clip.h"
#include "worlds/geometry/exposed_surface.h"
#include "worlds/geometry/mass_properties.h"

namespace handrail {
namespace {

// Fraction of the mesh's size; a point whose distance from a plane is less than this is treated as in the plane.
constexpr double kMeshFlat = 1e-5;
// Two faces are in one plane only if the dot product of their normals is at least this. Their corners must be in that
// plane too.
constexpr double kMeshSameTurn = 1.0 - 1e-4;
constexpr double kThinnest_m = 1e-4;  // a mesh thinner than this is degenerate and has no inside
constexpr std::size_t kMostFragments = 200'000;
constexpr std::size_t kPlanesTried = 16;  // number of planes that are compared to choose each cut
constexpr std::size_t kFewFaces = 8;      // a convex part with at most this many faces is not halved further

// Returns a number for each point. Points at exactly the same position get the same number.
std::vector<std::uint32_t> joined_points(std::span<const Vec3> points_m) {
    std::vector<std::uint32_t> order(points_m.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        for (int axis = 0; axis < 3; ++axis)
            if (points_m[a][axis] != points_m[b][axis]) return points_m[a][axis] < points_m[b][axis];
        return false;
    };
    std::stable_sort(order.begin(), order.end(), less);
    std::vector<std::uint32_t> number(points_m.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        number[order[i]] = i > 0 && !less(order[i - 1], order[i]) ? number[order[i - 1]] : order[i];
    return number;
}

bool edges_close(std::span<const MeshCorners> triangles, std::span<const std::uint32_t> which,
                 std::span<const std::uint32_t> joined) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * which.size());
    for (const std::uint32_t t : which)
        for (std::size_t k = 0; k < 3; ++k)
            edges.emplace_back(joined[triangles[t][k]], joined[triangles[t][(k + 1) % 3]]);
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return edge.first != edge.second &&
               std::binary_search(edges.begin(), edges.end(), std::pair{edge.second, edge.first});
    });
}

double volume_within_m3(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles,
                        std::span<const std::uint32_t> which) {
    double six = 0.0;
    const Vec3 from = points_m[triangles[which[0]][0]];
    for (const std::uint32_t t : which) {
        const auto& [a, b, c] = triangles[t];
        six += glm::dot(points_m[a] - from, glm::cross(points_m[b] - from, points_m[c] - from));
    }
    return six / 6.0;
}

// Fills closed shells with convex solids. It cuts space by the planes of faces until each part is convex.
class SolidFiller {
public:
    SolidFiller(const FillLimits& limits, const Aabb& box, const std::stop_token& stop)
        : limits_(limits), box_(box), flat_m_(kMeshFlat * longest(box)), stop_(stop) {}

    bool take(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles,
              std::span<const std::uint32_t> which) {
        struct Sized {
            double area_m2;
            std::uint32_t triangle;
        };
        std::vector<Sized> by_size;
        for (const std::uint32_t t : which) {
            const auto& [a, b, c] = triangles[t];
            by_size.push_back({0.5 * glm::length(glm::cross(points_m[b] - points_m[a], points_m[c] - points_m[a])), t});
            area_m2_ += by_size.back().area_m2;
        }
        // The largest faces come first, because their planes are the most accurate.
        std::stable_sort(by_size.begin(), by_size.end(),
                         [](const Sized& a, const Sized& b) { return a.area_m2 > b.area_m2; });
        for (const auto& [size_m2, t] : by_size) {
            if (stop_.stop_requested()) return false;
            const std::array<Vec3, 3> p{points_m[triangles[t][0]], points_m[triangles[t][1]],
                                        points_m[triangles[t][2]]};
            Plane plane;  // corners are reversed below, because plane_from_clockwise expects clockwise order
            if (!(size_m2 > 1e-12) || !plane_from_clockwise(p[2], p[1], p[0], plane)) continue;
            if (!look(planes_.size())) return false;
            std::uint32_t number = 0;
            while (number < planes_.size() && !is_in(planes_[number], plane.normal, p)) ++number;
            if (number == planes_.size()) {
                if (planes_.size() == limits_.most_planes) return false;
                planes_.push_back(plane);
            }
            whole_.facets.push_back({{p.begin(), p.end()}, number});
        }
        if (whole_.facets.size() < 4) return false;
        whole_.convex = is_convex(points_m, triangles, which);
        const Vec3 room = Vec3(0.01 * longest(box_));
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 out(0.0);
            out[axis] = 1.0;
            whole_.planes.push_back({out, box_.max_m[axis] + room[axis]});
            whole_.planes.push_back({-out, -(box_.min_m[axis] - room[axis])});
        }
        return true;
    }

    // Returns false if a limit was reached or the caller requested a stop.
    bool fill() {
        std::vector<Cell> open;
        open.push_back(std::move(whole_));
        std::size_t fragments = open.front().facets.size();
        while (!open.empty()) {
            if (stop_.stop_requested() || solids_.size() > limits_.most_solids || open.size() > 4 * limits_.most_solids)
                return false;
            Cell cell = std::move(open.back());
            open.pop_back();
            const std::vector<std::uint32_t> own = planes_of(cell);
            std::vector<std::uint32_t> beyond;  // planes of faces that have other faces of the cell in front of them
            if (!cell.convex && !look(own.size() * cell.facets.size())) return false;
            for (const std::uint32_t number : own)
                if (!cell.convex && std::any_of(cell.facets.begin(), cell.facets.end(), [&](const Facet& facet) {
                        return farthest(planes_[number], facet) > flat_m_;
                    }))
                    beyond.push_back(number);
            if (beyond.empty()) {
                // No plane has faces of the cell in front of it, so the cell is convex: the solid is the space behind
                // all of its faces. A cell with many faces is halved first.
                if (own.size() > kFewFaces && own.size() + cell.planes.size() > limits_.most_faces) {
                    if (!halve(cell, own, open, fragments)) return false;
                    continue;
                }
                std::vector<Plane> planes = cell.planes;
                for (const std::uint32_t number : own) planes.push_back(planes_[number]);
                add(planes);
                continue;
            }
            if (!look(std::min(beyond.size(), kPlanesTried) * cell.facets.size())) return false;
            const std::uint32_t number = best_cut(cell, beyond);
            Cell front, back;
            for (Facet& facet : cell.facets) {
                if (facet.plane == number) continue;
                const Side side = side_of(facet.points_m, planes_[number], flat_m_);
                if (side == Side::Front) front.facets.push_back(std::move(facet));
                else if (side == Side::Back) back.facets.push_back(std::move(facet));
                else if (side == Side::Across) {
                    if (++fragments > kMostFragments) return false;
                    Facet before{{}, facet.plane}, behind{{}, facet.plane};
                    split(facet.points_m, planes_[number], 0.0, behind.points_m, before.points_m);
                    tidy(before.points_m, kMerge_m);
                    tidy(behind.points_m, kMerge_m);
                    if (!before.points_m.empty()) front.facets.push_back(std::move(before));
                    if (!behind.points_m.empty()) back.facets.push_back(std::move(behind));
                }
            }
            const Plane& plane = planes_[number];
            // If a part has no faces, it is outside if it is in front of the cutting face, and inside if it is behind
            // that face.
            if (!front.facets.empty() && narrow(cell.planes, turned(plane), front.planes))
                open.push_back(std::move(front));
            if (narrow(cell.planes, plane, back.planes)) {
                if (back.facets.empty()) add(back.planes);
                else open.push_back(std::move(back));
            }
        }
        return true;
    }

    std::vector<ConvexSolid> take_solids() { return std::move(solids_); }
    // Returns the allowed difference between the volume of the solids and that of the shells. Corners are only accurate
    // to a tolerance.
    double slack_m3(double volume_m3) const { return 2.0 * flat_m_ * area_m2_ + 1e-6 * volume_m3; }

private:
    static constexpr double kMerge_m = 1e-7;
    struct Facet {
        std::vector<Vec3> points_m;
        std::uint32_t plane = 0;
    };
    struct Cell {
        std::vector<Facet> facets;
        std::vector<Plane> planes;
        bool convex = false;  // true if the cell is known to be convex
    };

    static double longest(const Aabb& box) {
        const Vec3 size = box.size_m();
        return std::max({size.x, size.y, size.z});
    }
    static Plane turned(const Plane& plane) { return {-plane.normal, -plane.offset_m}; }
    static double farthest(const Plane& plane, const Facet& facet) {
        double most = -1e300;
        for (const Vec3& p : facet.points_m) most = std::max(most, signed_distance(plane, p));
        return most;
    }

    bool look(std::size_t times) {
        if (!limits_.looks_left) return true;
        const bool enough = *limits_.looks_left >= times;
        *limits_.looks_left -= enough ? times : *limits_.looks_left;
        return enough;
    }

    // True if no corner is in front of any plane. Tests the shared points, because there are fewer of them than corners
    // of faces.
    bool is_convex(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles,
                   std::span<const std::uint32_t> which) {
        std::vector<Vec3> corners;
        for (const std::uint32_t t : which)
            for (const std::uint32_t corner : triangles[t]) corners.push_back(points_m[corner]);
        std::sort(corners.begin(), corners.end(),
                  [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        return std::all_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
            return look(corners.size() / 3 + 1) && std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) {
                       return signed_distance(plane, p) <= flat_m_;
                   });
        });
    }

    bool is_in(const Plane& plane, const Vec3& normal, std::span<const Vec3> points_m) const {
        return glm::dot(plane.normal, normal) > kMeshSameTurn &&
               std::all_of(points_m.begin(), points_m.end(),
                           [&](const Vec3& p) { return std::abs(signed_distance(plane, p)) <= flat_m_; });
    }

    std::vector<std::uint32_t> planes_of(const Cell& cell) const {
        std::vector<std::uint32_t> own;
        for (const Facet& facet : cell.facets) own.push_back(facet.plane);
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        return own;
    }

    // Chooses among up to kPlanesTried planes. Returns the plane that cuts the fewest faces and divides the others most
    // evenly.
    std::uint32_t best_cut(const Cell& cell, const std::vector<std::uint32_t>& beyond) const {
        std::uint32_t best = beyond.front();
        double least = 1e300;
        const std::size_t step = 1 + (beyond.size() - 1) / kPlanesTried;
        for (std::size_t i = 0; i < beyond.size(); i += step) {
            double cut = 0.0, front = 0.0, back = 0.0;
            for (const Facet& facet : cell.facets) {
                const Side side = side_of(facet.points_m, planes_[beyond[i]], flat_m_);
                (side == Side::Across ? cut : side == Side::Front ? front : back) += 1.0;
            }
            if (const double cost = 8.0 * cut + std::abs(front - back); cost < least) {
                least = cost;
                best = beyond[i];
            }
        }
        return best;
    }

    // Cuts a part with the plane `by`. `left` receives the planes of what remains behind `by`. Returns false if nothing
    // remains.
    bool narrow(const std::vector<Plane>& planes, const Plane& by, std::vector<Plane>& left,
                Vec3* middle_m = nullptr) const {
        std::vector<Plane> all = planes;
        all.push_back(by);
        BuiltSolid built = solid_from_planes(all, box_.centre_m(), 4.0 * glm::length(box_.size_m()) + 1.0);
        if (built.fault != SolidFault::None || built.was_inside_out) return false;
        if (middle_m) {
            *middle_m = Vec3(0.0);
            for (const Polygon& face : built.solid.faces)
                *middle_m += centre_of(face) / static_cast<double>(built.solid.faces.size());
        }
        left = std::move(built.solid.planes);
        return true;
    }

    void add(const std::vector<Plane>& planes) {
        BuiltSolid built = solid_from_planes(planes, box_.centre_m(), 4.0 * glm::length(box_.size_m()) + 1.0);
        if (built.fault == SolidFault::None && !built.was_inside_out) solids_.push_back(std::move(built.solid));
    }

    // Halves the cell at the middle of the box around its faces.
    bool halve(const Cell& cell, const std::vector<std::uint32_t>& own, std::vector<Cell>& open,
               std::size_t& fragments) {
        Aabb box;
        for (const Facet& facet : cell.facets)
            for (const Vec3& p : facet.points_m) box.include(p);
        const Vec3 size = box.size_m();
        Vec3 out(0.0);
        out[size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2] = 1.0;
        const Plane middle{out, glm::dot(out, box.centre_m())};
        for (const Plane& half : {middle, turned(middle)}) {
            Cell part;
            part.convex = true;
            for (const Facet& facet : cell.facets) {
                Facet kept{facet.points_m, facet.plane};
                std::vector<Vec3> scratch;
                keep_back(kept.points_m, half, 0.0, scratch);
                tidy(kept.points_m, kMerge_m);
                if (kept.points_m.empty()) continue;
                part.facets.push_back(std::move(kept));
                if (++fragments > kMostFragments) return false;
            }
            Vec3 within(0.0);
            if (!narrow(cell.planes, half, part.planes, &within)) continue;
            if (!part.facets.empty()) open.push_back(std::move(part));
            else if (std::all_of(own.begin(), own.end(),
                                 [&](std::uint32_t number) { return signed_distance(planes_[number], within) <= 0.0; }))
                add(part.planes);
        }
        return true;
    }

    const FillLimits& limits_;
    Aabb box_;
    double flat_m_, area_m2_ = 0.0;
    std::stop_token stop_;
    std::vector<Plane> planes_;
    Cell whole_;
    std::vector<ConvexSolid> solids_;
};

}  // namespace

std::vector<MeshShell> shells_of(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles) {
    const std::vector<std::uint32_t> joined = joined_points(points_m);
    // The triangles are joined along edges, not at corners, because separate things that stand on each other may share
    // corners. Each entry is one edge of a triangle: its lower corner, its higher corner, and the triangle.
    std::vector<std::array<std::uint32_t, 3>> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            contract_pre(triangles[t][k] < points_m.size());
            const auto [low, high] = std::minmax(joined[triangles[t][k]], joined[triangles[t][(k + 1) % 3]]);
            edges.push_back({low, high, t});
        }
    std::sort(edges.begin(), edges.end());
    DisjointSets pieces(triangles.size());
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i][0] == edges[i - 1][0] && edges[i][1] == edges[i - 1][1]) pieces.join(edges[i][2], edges[i - 1][2]);
    constexpr std::uint32_t kNew = 0xffffffffU;
    // Index of the shell for each triangle that represents a connected piece.
    std::vector<std::uint32_t> shell_of(triangles.size(), kNew);
    std::vector<MeshShell> shells;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        std::uint32_t& shell = shell_of[pieces.find(t)];
        if (shell == kNew) {
            shell = static_cast<std::uint32_t>(shells.size());
            shells.emplace_back();
        }
        shells[shell].triangles.push_back(t);
        for (const std::uint32_t corner : triangles[t]) shells[shell].box.include(points_m[corner]);
    }
    for (MeshShell& shell : shells) {
        shell.closed = edges_close(triangles, shell.triangles, joined);
        if (shell.closed) shell.volume_m3 = volume_within_m3(points_m, triangles, shell.triangles);
    }
    return shells;
}

int times_around(std::span<const Vec3> points_m, std::span<const MeshCorners> triangles,
                 std::span<const std::uint32_t> which, const Vec3& at_m) {
    double half = 0.0;
    for (const std::uint32_t t : which) {
        const Vec3 a = points_m[triangles[t][0]] - at_m, b = points_m[triangles[t][1]] - at_m,
                   c = points_m[triangles[t][2]] - at_m;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        half += std::atan2(glm::dot(a, glm::cross(b, c)),
                           la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(half / (2.0 * kPi)));
}

std::optional<std::vector<ConvexSolid>> solids_within(std::span<const Vec3> points_m,
                                                      std::span<const MeshCorners> triangles,
                                                      std::span<const std::uint32_t> which, const FillLimits& limits,
                                                      const std::stop_token& stop) {
    if (which.size() < 4 || which.size() > limits.most_triangles) return std::nullopt;
    Aabb box;
    for (const std::uint32_t t : which)
        for (const std::uint32_t corner : triangles[t]) box.include(points_m[corner]);
    const Vec3 size = box.size_m();
    const double volume_m3 = volume_within_m3(points_m, triangles, which);
    if (std::min({size.x, size.y, size.z}) < kThinnest_m || !(volume_m3 > 0.0)) return std::nullopt;
    SolidFiller filler(limits, box, stop);
    if (!filler.take(points_m, triangles, which) || !filler.fill()) return std::nullopt;
    std::vector<ConvexSolid> solids = filler.take_solids();
    double filled_m3 = 0.0;
    for (const ConvexSolid& solid : solids) filled_m3 += mass_properties(solid).volume_m3;
    if (solids.empty() || stop.stop_requested() || solids.size() > limits.most_solids ||
        std::abs(filled_m3 - volume_m3) > filler.slack_m3(volume_m3))
        return std::nullopt;
    return solids;
}

}  // namespace handrail
