#include "worlds/geometry/exposed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <unordered_map>

#include "worlds/base/contract.h"

namespace handrail {
namespace {

// If a face overlaps or touches more solids than this, the face is divided into a grid.
constexpr std::size_t kFewSolids = 48;

// Chooses which of several coinciding faces keeps the area that they share. The order is total, so exactly one face
// keeps it. If ranks are equal, the face that is farther out along its normal wins, because it covers the others
// wherever it is farther out by more than the tolerance. Heights and areas are counted in steps of the tolerance, so
// that rounding errors do not decide.
struct FaceClaim {
    int rank;
    double height_steps, area_steps;
    Vec3 middle_m;
    std::uint32_t solid;

    bool beats(const FaceClaim& other) const {
        if (rank != other.rank) return rank > other.rank;
        if (height_steps != other.height_steps) return height_steps > other.height_steps;
        if (area_steps != other.area_steps) return area_steps > other.area_steps;
        for (int axis = 0; axis < 3; ++axis)
            if (middle_m[axis] != other.middle_m[axis]) return middle_m[axis] < other.middle_m[axis];
        return solid < other.solid;
    }
};

FaceClaim claim_of(const SurfaceSolid& solid, std::uint32_t index, std::size_t face, double cut_m) {
    const Polygon& polygon = solid.shape->faces[face];
    return {solid.rank, std::round(solid.shape->planes[face].offset_m / cut_m),
            std::round(area_m2(polygon) / (cut_m * cut_m)), bounds_of(polygon).centre_m(), index};
}

// Removes from polygons the parts that a convex solid covers.
class Cutter {
public:
    explicit Cutter(const CutTolerance& tolerance) : tolerance_(tolerance) {}

    // Appends to `left` the parts of `points` outside `solid`; appends all of `points` if `solid` covers nothing of
    // them.
    void subtract(const std::vector<Vec3>& points, const SurfaceSolid& solid, std::uint32_t solid_index,
                  const SurfaceSolid& own, std::uint32_t own_index, std::uint32_t own_face,
                  std::vector<std::vector<Vec3>>& left) {
        const Vec3& normal = own.shape->planes[own_face].normal;
        const std::size_t before = left.size();
        rest_ = points;
        for (std::size_t p = 0; p < solid.shape->planes.size(); ++p) {
            const Plane& plane = solid.shape->planes[p];
            const Side side = side_of(rest_, plane, tolerance_.cut_m);
            if (side == Side::Back) continue;
            if (side == Side::On) {
                // The polygon is in the plane of a face of the solid. If that face has the opposite direction, it
                // covers the polygon from outside. Otherwise FaceClaim selects which of the two faces keeps the common
                // part.
                if (glm::dot(plane.normal, normal) < 0.0 || !own.covers) continue;
                if (claim_of(solid, solid_index, p, tolerance_.cut_m)
                        .beats(claim_of(own, own_index, own_face, tolerance_.cut_m)))
                    continue;
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

// The parts of a face that many solids overlap, arranged in a grid, so that each solid is tested only against the parts
// near it. The resulting parts and their order are the same as if each solid had been tested against all parts.
class FaceParts {
public:
    FaceParts(const Polygon& face, const Aabb& box, std::size_t solids, double cut_m) : box_(box), cut_m_(cut_m) {
        const Vec3 size = box.size_m();
        const int thin = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
        axes_ = {thin == 0 ? 1 : 0, thin == 2 ? 1 : 2};
        side_ = std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(solids))), std::size_t{1},
                           std::size_t{64});
        cells_.resize(side_ * side_);
        add(face.points_m);
    }

    bool all_gone() const { return left_in_all_ == 0; }

    // Removes the area that a solid covers. `solid` is the solid's box; cut(points, left) must append the uncovered
    // rest of the polygon `points` to `left`.
    template <class Cut>
    void subtract(const Aabb& solid, Cut&& cut) {
        const Aabb reach = grown(solid, 16.0 * cut_m_);
        met_.clear();
        in_cells(reach, [&](std::vector<std::uint32_t>& cell) {
            std::erase_if(cell, [&](std::uint32_t i) { return parts_[i].gone; });
            for (const std::uint32_t i : cell)
                if (overlap(parts_[i].box, reach)) met_.push_back(i);
        });
        std::sort(met_.begin(), met_.end());
        met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
        for (const std::uint32_t i : met_) {
            left_.clear();
            cut(parts_[i].points, left_);
            if (left_.size() == 1 && left_.front() == parts_[i].points) continue;
            parts_[i].gone = true;
            --left_in_all_;
            std::uint32_t last = i;
            for (std::vector<Vec3>& points : left_) {
                const std::uint32_t next = parts_[last].next, made = add(std::move(points));
                parts_[last].next = made;
                parts_[made].next = next;
                last = made;
            }
        }
    }

    template <class Take>
    void take(Take&& take_one) {
        for (std::uint32_t i = 0; i != kEnd; i = parts_[i].next)
            if (!parts_[i].gone) take_one(std::move(parts_[i].points));
    }

private:
    static constexpr std::uint32_t kEnd = 0xFFFFFFFFU;
    struct Part {
        std::vector<Vec3> points;
        Aabb box;
        std::uint32_t next = kEnd;
        bool gone = false;
    };

    std::uint32_t add(std::vector<Vec3> points) {
        const auto number = static_cast<std::uint32_t>(parts_.size());
        parts_.push_back({std::move(points), {}, kEnd, false});
        ++left_in_all_;
        for (const Vec3& p : parts_.back().points) parts_.back().box.include(p);
        in_cells(parts_.back().box, [&](std::vector<std::uint32_t>& cell) { cell.push_back(number); });
        return number;
    }

    template <class Visit>
    void in_cells(const Aabb& box, Visit&& visit) {
        std::array<std::array<std::size_t, 2>, 2> range;
        for (std::size_t a = 0; a < 2; ++a) {
            const int axis = axes_[a];
            const double from = box_.min_m[axis], size = std::max(box_.max_m[axis] - from, 1e-9),
                         cells = static_cast<double>(side_);
            const auto cell = [&](double at) {
                return static_cast<std::size_t>(std::clamp((at - from) / size * cells, 0.0, cells - 1.0));
            };
            range[a] = {cell(box.min_m[axis]), cell(box.max_m[axis])};
        }
        for (std::size_t u = range[0][0]; u <= range[0][1]; ++u)
            for (std::size_t v = range[1][0]; v <= range[1][1]; ++v) visit(cells_[u * side_ + v]);
    }

    Aabb box_;
    double cut_m_;
    std::array<int, 2> axes_{};
    std::size_t side_ = 1, left_in_all_ = 0;
    std::vector<Part> parts_;  // linked lists, connected by Part::next
    std::vector<std::vector<std::uint32_t>> cells_;
    std::vector<std::uint32_t> met_;
    std::vector<std::vector<Vec3>> left_;
};

// Returns the data of a solid as bytes. Two solids with equal bytes have the same effect on the surface.
std::string sameness(const SurfaceSolid& solid) {
    std::string bytes;
    const auto put = [&bytes](const auto& value) {
        const std::size_t at = bytes.size();
        bytes.resize(at + sizeof value);
        std::memcpy(bytes.data() + at, &value, sizeof value);
    };
    put(solid.group);
    put(solid.rank);
    for (const Plane& plane : solid.shape->planes) {
        put(plane.normal.x);
        put(plane.normal.y);
        put(plane.normal.z);
        put(plane.offset_m);
    }
    return bytes;
}

// Marks each solid that equals an earlier one. The earlier one covers all faces of the later one, and everything that
// the later one covers.
std::vector<bool> repetitions(std::span<const SurfaceSolid> solids) {
    std::vector<bool> again(solids.size(), false);
    std::unordered_map<std::string, std::uint32_t> first;
    for (std::uint32_t s = 0; s < solids.size(); ++s)
        if (solids[s].covers) again[s] = !first.try_emplace(sameness(solids[s]), s).second;
    return again;
}

// True if two edges run along each other in opposite directions for a length of more than gap_m.
bool edges_touch(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1, double gap_m) {
    const Vec3 along = a1 - a0;
    const double length = glm::length(along);
    if (length <= gap_m || glm::dot(along, b1 - b0) >= 0.0) return false;
    const Vec3 unit = along / length;
    const auto distance = [&](const Vec3& p) { return glm::length(p - a0 - unit * glm::dot(unit, p - a0)); };
    // Two long edges may drift apart and still touch along the part that they have in common, so the distance is
    // measured only at the ends of that part.
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
            if (edges_touch(a.points_m[i], a.points_m[(i + 1) % na], b.points_m[j], b.points_m[(j + 1) % nb], gap_m))
                return true;
    return false;
}

bool same_plane(const FlatPiece& a, const FlatPiece& b, double gap_m) {
    if (glm::dot(a.plane.normal, b.plane.normal) < 1.0 - 1e-8) return false;
    return std::all_of(b.polygon->points_m.begin(), b.polygon->points_m.end(),
                       [&](const Vec3& p) { return std::abs(signed_distance(a.plane, p)) <= gap_m; });
}

}  // namespace

DisjointSets::DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

std::uint32_t DisjointSets::find(std::uint32_t i) {
    contract_pre(i < parent_.size());
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
}

void DisjointSets::join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

std::vector<ExposedPiece> exposed_surface(std::span<const SurfaceSolid> solids, const BoxIndex& index,
                                          const CutTolerance& tolerance, const std::stop_token& stop) {
    contract_pre(
        std::all_of(solids.begin(), solids.end(), [](const SurfaceSolid& solid) { return solid.shape != nullptr; }));
    contract_pre(tolerance.cut_m > 0.0);
    std::vector<ExposedPiece> pieces;
    Cutter cutter(tolerance);
    std::vector<std::uint32_t> near;
    std::vector<std::vector<Vec3>> now, next;
    const std::vector<bool> again = repetitions(solids);
    for (std::uint32_t s = 0; s < solids.size(); ++s) {
        if (again[s]) continue;
        const SurfaceSolid& own = solids[s];
        for (std::uint32_t f = 0; f < own.shape->faces.size(); ++f) {
            if (stop.stop_requested()) return pieces;
            const Aabb box = bounds_of(own.shape->faces[f]);
            index.find(grown(box, tolerance.cut_m), near);
            std::erase_if(near, [&](std::uint32_t other) {
                return other == s || again[other] || !solids[other].covers || solids[other].group != own.group;
            });
            if (near.size() > kFewSolids) {
                FaceParts parts(own.shape->faces[f], box, near.size(), tolerance.cut_m);
                for (const std::uint32_t other : near) {
                    if (parts.all_gone()) break;
                    parts.subtract(solids[other].shape->bounds_m,
                                   [&](const std::vector<Vec3>& points, std::vector<std::vector<Vec3>>& left) {
                                       cutter.subtract(points, solids[other], other, own, s, f, left);
                                   });
                }
                parts.take([&](std::vector<Vec3>&& points) { pieces.push_back({s, f, Polygon{std::move(points)}}); });
                continue;
            }
            now.assign(1, own.shape->faces[f].points_m);
            for (const std::uint32_t other : near) {
                next.clear();
                for (const std::vector<Vec3>& points : now)
                    cutter.subtract(points, solids[other], other, own, s, f, next);
                now.swap(next);
                if (now.empty()) break;
            }
            for (std::vector<Vec3>& points : now) pieces.push_back({s, f, Polygon{std::move(points)}});
        }
    }
    return pieces;
}

std::vector<std::uint32_t> joined_surfaces(std::span<const FlatPiece> pieces, double gap_m,
                                           const std::stop_token& stop) {
    contract_pre(gap_m >= 0.0);
    contract_pre(
        std::all_of(pieces.begin(), pieces.end(), [](const FlatPiece& piece) { return piece.polygon != nullptr; }));
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
    for (std::uint32_t i = 0; i < pieces.size() && !stop.stop_requested(); ++i) {
        index.find(grown(boxes[i], gap_m), near);
        for (const std::uint32_t j : near) {
            if (j <= i || pieces[i].look != pieces[j].look || sets.find(i) == sets.find(j) ||
                !same_plane(pieces[i], pieces[j], gap_m))
                continue;
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
