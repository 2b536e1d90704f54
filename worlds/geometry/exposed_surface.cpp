#include "worlds/geometry/exposed_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace handrail {
namespace {

// Does face `a` keep what it shares with the coinciding face `b`? Asked both ways round exactly one answer is yes.
struct FaceClaim {
    int rank;
    double area_m2;
    Vec3 middle_m;
    std::uint32_t solid;

    bool beats(const FaceClaim& other, double tolerance_m2) const {
        if (rank != other.rank) return rank > other.rank;
        if (std::abs(area_m2 - other.area_m2) > tolerance_m2) return area_m2 > other.area_m2;
        for (int axis = 0; axis < 3; ++axis)
            if (middle_m[axis] != other.middle_m[axis]) return middle_m[axis] < other.middle_m[axis];
        return solid < other.solid;
    }
};

FaceClaim claim_of(const SurfaceSolid& solid, std::uint32_t index, std::size_t face) {
    const Polygon& polygon = solid.shape->faces[face];
    return {solid.rank, area_m2(polygon), bounds_of(polygon).centre_m(), index};
}

// Cuts polygons into what a convex solid leaves of them.
class Cutter {
public:
    explicit Cutter(const CutTolerance& tolerance) : tolerance_(tolerance) {}

    // Appends the parts of `points` outside `solid` to `left`; the whole when nothing is covered.
    void subtract(const std::vector<Vec3>& points, const SurfaceSolid& solid, std::uint32_t solid_index, const SurfaceSolid& own, std::uint32_t own_index,
                  std::uint32_t own_face, std::vector<std::vector<Vec3>>& left) {
        const Vec3& normal = own.shape->planes[own_face].normal;
        const std::size_t before = left.size();
        rest_ = points;
        for (std::size_t p = 0; p < solid.shape->planes.size(); ++p) {
            const Plane& plane = solid.shape->planes[p];
            const Side side = side_of(rest_, plane, tolerance_.cut_m);
            if (side == Side::Back) continue;
            if (side == Side::On) {
                // Lying in the solid's own face: covered from outside when that looks the other way, else one of the two stays.
                if (glm::dot(plane.normal, normal) < 0.0 || !own.covers) continue;
                if (claim_of(solid, solid_index, p).beats(claim_of(own, own_index, own_face), tolerance_.cut_m * tolerance_.cut_m)) continue;
                return keep_whole(points, left, before);
            }
            if (side == Side::Front) return keep_whole(points, left, before);
            split(rest_, plane, tolerance_.cut_m, back_, front_);
            tidy(front_, tolerance_.merge_m);
            if (!front_.empty()) left.push_back(front_);
            tidy(back_, tolerance_.merge_m);
            if (back_.empty()) return keep_whole(points, left, before);
            rest_.swap(back_);
        }
    }

private:
    static void keep_whole(const std::vector<Vec3>& points, std::vector<std::vector<Vec3>>& left, std::size_t before) {
        left.resize(before);
        left.push_back(points);
    }

    CutTolerance tolerance_;
    std::vector<Vec3> rest_, back_, front_;
};

// Do two edges run along each other, in opposite directions, for longer than a gap?
bool edges_touch(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1, double gap_m) {
    const Vec3 along = a1 - a0;
    const double length = glm::length(along);
    if (length <= gap_m || glm::dot(along, b1 - b0) >= 0.0) return false;
    const Vec3 unit = along / length;
    const auto distance = [&](const Vec3& p) { return glm::length(p - a0 - unit * glm::dot(unit, p - a0)); };
    // Only the common part must be near: two long edges that drift apart still touch where they run together, so measure at its ends.
    const double s0 = glm::dot(unit, b1 - a0), s1 = glm::dot(unit, b0 - a0);
    const double from = std::max(0.0, s0), to = std::min(length, s1);
    if (to - from <= 10.0 * gap_m) return false;
    const auto at = [&](double s) { return b1 + (b0 - b1) * ((s - s0) / (s1 - s0)); };
    return distance(at(from)) <= gap_m && distance(at(to)) <= gap_m;
}

bool polygons_touch(const Polygon& a, const Polygon& b, double gap_m) {
    const std::size_t na = a.points_m.size(), nb = b.points_m.size();
    for (std::size_t i = 0; i < na; ++i)
        for (std::size_t j = 0; j < nb; ++j)
            if (edges_touch(a.points_m[i], a.points_m[(i + 1) % na], b.points_m[j], b.points_m[(j + 1) % nb], gap_m)) return true;
    return false;
}

bool same_plane(const FlatPiece& a, const FlatPiece& b, double gap_m) {
    if (glm::dot(a.plane.normal, b.plane.normal) < 1.0 - 1e-8) return false;
    return std::all_of(b.polygon->points_m.begin(), b.polygon->points_m.end(), [&](const Vec3& p) { return std::abs(signed_distance(a.plane, p)) <= gap_m; });
}

}  // namespace

DisjointSets::DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

std::uint32_t DisjointSets::find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
}

void DisjointSets::join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

std::vector<ExposedPiece> exposed_surface(std::span<const SurfaceSolid> solids, const BoxIndex& index, const CutTolerance& tolerance) {
    std::vector<ExposedPiece> pieces;
    Cutter cutter(tolerance);
    std::vector<std::uint32_t> near;
    std::vector<std::vector<Vec3>> now, next;
    for (std::uint32_t s = 0; s < solids.size(); ++s) {
        const SurfaceSolid& own = solids[s];
        for (std::uint32_t f = 0; f < own.shape->faces.size(); ++f) {
            now.assign(1, own.shape->faces[f].points_m);
            const Aabb around = grown(bounds_of(own.shape->faces[f]), tolerance.cut_m);
            index.find(around, near);
            for (const std::uint32_t other : near) {
                if (other == s || !solids[other].covers || solids[other].group != own.group) continue;
                next.clear();
                for (const std::vector<Vec3>& points : now) cutter.subtract(points, solids[other], other, own, s, f, next);
                now.swap(next);
                if (now.empty()) break;
            }
            for (std::vector<Vec3>& points : now) pieces.push_back({s, f, Polygon{std::move(points)}});
        }
    }
    return pieces;
}

std::vector<std::uint32_t> joined_surfaces(std::span<const FlatPiece> pieces, double gap_m) {
    DisjointSets sets(pieces.size());
    std::unordered_map<std::uint64_t, std::uint32_t> first_of_face;
    std::vector<Aabb> boxes;
    boxes.reserve(pieces.size());
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        boxes.push_back(bounds_of(*pieces[i].polygon));
        sets.join(i, first_of_face.try_emplace(pieces[i].face, i).first->second);
    }
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        index.find(grown(boxes[i], gap_m), near);
        for (const std::uint32_t j : near) {
            if (j <= i || pieces[i].look != pieces[j].look || sets.find(i) == sets.find(j) || !same_plane(pieces[i], pieces[j], gap_m)) continue;
            if (polygons_touch(*pieces[i].polygon, *pieces[j].polygon, gap_m)) sets.join(i, j);
        }
    }
    std::vector<std::uint32_t> number(pieces.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        const std::uint32_t root = sets.find(i);
        number[i] = root == i ? count++ : number[root];
    }
    return number;
}

}  // namespace handrail
