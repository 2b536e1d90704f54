#include "haptic/compile/merge_flat.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "worlds/base/contract.h"

namespace handrail::compile {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;
// Tolerance for points on one line, seen along the patch's normal. Corners may be off the patch's plane by this divided
// by a thousand.
constexpr double kRim_m = 1e-9;
constexpr double kLowestSeed_m = 1e-7;  // a triangle of less height than this does not define a plane

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

class Merger {
public:
    Merger(const TriangleMesh& mesh, std::span<const std::uint32_t> groups, double bound_m)
        : mesh_(mesh), groups_(groups), bound_m_(bound_m), count_(static_cast<std::uint32_t>(mesh.triangles.size())) {}

    FlatMerge run(bool keep_curves) {
        find_twins();
        patch_of_.assign(count_, kNone);
        flat_.resize(mesh_.points_m.size());
        next_.resize(3 * std::size_t{count_});
        prev_.resize(next_.size());
        std::vector<double> areas(count_);
        std::vector<std::uint32_t> order(count_);
        std::iota(order.begin(), order.end(), 0U);
        for (std::uint32_t t = 0; t < count_; ++t) areas[t] = glm::length(twice_area(t));
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
        for (const std::uint32_t seed : order) {
            if (patch_of_[seed] != kNone || !(areas[seed] > kLowestSeed_m * longest(seed))) continue;
            find_patch(seed);
            if (patch_.size() < 2 || (keep_curves && on_curve())) continue;
            if (!take_whole()) take_parts();
        }
        std::vector<bool> taken(count_, false);
        for (const FlatPolygon& polygon : result_.polygons)
            for (const std::uint32_t t : polygon.triangles) taken[t] = true;
        for (std::uint32_t t = 0; t < count_; ++t)
            if (!taken[t]) result_.single.push_back(t);
        return std::move(result_);
    }

private:
    // Half-edge 3 t + k goes from corner k of triangle t to the triangle's next corner.
    std::uint32_t origin(std::uint32_t h) const { return mesh_.triangles[h / 3][h % 3]; }
    std::uint32_t target(std::uint32_t h) const { return mesh_.triangles[h / 3][(h % 3 + 1) % 3]; }
    const Vec3& corner(std::uint32_t t, std::size_t k) const { return mesh_.points_m[mesh_.triangles[t][k]]; }
    Vec3 twice_area(std::uint32_t t) const {
        return glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0));
    }
    double longest(std::uint32_t t) const {
        double length = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            length = std::max(length, glm::length(corner(t, (k + 1) % 3) - corner(t, k)));
        return length;
    }

    void find_twins() {
        struct Edge {
            std::uint32_t low, high, half_edge;
        };
        std::vector<Edge> edges;
        edges.reserve(3 * std::size_t{count_});
        for (std::uint32_t h = 0; h < 3 * count_; ++h) {
            const std::uint32_t a = origin(h), b = target(h);
            if (a != b) edges.push_back({std::min(a, b), std::max(a, b), h});
        }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
        });
        twin_.assign(3 * std::size_t{count_}, kNone);
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i + 1;
            while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
            const std::uint32_t a = edges[i].half_edge, b = edges[end - 1].half_edge;
            if (end - i == 2 && origin(a) == target(b) && a / 3 != b / 3) {
                twin_[a] = b;
                twin_[b] = a;
            }
            i = end;
        }
    }

    // Finds the triangles of a patch, and its plane. A small seed triangle gives a poor estimate of a large patch's
    // plane. The search is therefore repeated with the mean plane of the patch while it finds more triangles.
    void find_patch(std::uint32_t seed) {
        constexpr int kRounds = 8;
        std::size_t found = 0;
        Vec3 normal = glm::normalize(twice_area(seed)), base = corner(seed, 0);
        for (int round = 0; round < kRounds; ++round) {
            const bool met_more = grow_patch(seed, normal, base);
            if (!met_more || patch_.size() <= found || round + 1 == kRounds) break;
            found = patch_.size();
            Vec3 sum(0.0), moment(0.0);
            double weight = 0.0;
            for (const std::uint32_t t : patch_) {
                const Vec3 twice = twice_area(t);
                const double area = glm::length(twice);
                sum += twice;
                moment += (corner(t, 0) + corner(t, 1) + corner(t, 2) - 3.0 * base_) * (area / 3.0);
                weight += area;
            }
            normal = glm::normalize(sum);
            base = base_ + moment / weight;
            for (const std::uint32_t t : patch_) patch_of_[t] = kNone;
            if (!fits(seed, normal, base)) {
                normal = glm::normalize(twice_area(seed));
                base = corner(seed, 0);
                round = kRounds - 2;
            }
        }
    }

    bool fits(std::uint32_t t, const Vec3& normal, const Vec3& base) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (!(std::abs(glm::dot(corner(t, k) - base, normal)) <= bound_m_)) return false;
        return true;
    }

    // Collects all triangles that are connected to the seed, face the same way and are within the bound of the plane
    // through `base` with this normal. Returns true if some connected triangles were left out because they are too far
    // off that plane.
    bool grow_patch(std::uint32_t seed, const Vec3& normal, const Vec3& base) {
        normal_ = normal;
        base_ = base;
        bool met_more = false;
        const Vec3 axis = std::abs(normal_.x) <= std::abs(normal_.y) && std::abs(normal_.x) <= std::abs(normal_.z)
                              ? Vec3(1, 0, 0)
                          : std::abs(normal_.y) <= std::abs(normal_.z) ? Vec3(0, 1, 0)
                                                                       : Vec3(0, 0, 1);
        across_ = glm::normalize(glm::cross(axis, normal_));
        along_ = glm::cross(normal_, across_);
        patch_.assign(1, seed);
        patch_of_[seed] = seed;
        size_m_ = 0.0;
        for (std::size_t i = 0; i < patch_.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 p = corner(patch_[i], k) - base_;
                Vec2& flat = flat_[mesh_.triangles[patch_[i]][k]];
                flat = {glm::dot(p, across_), glm::dot(p, along_)};
                size_m_ = std::max({size_m_, std::abs(flat.x), std::abs(flat.y)});
            }
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t twin = twin_[3 * patch_[i] + k];
                if (twin == kNone) continue;
                const std::uint32_t t = twin / 3;
                if (patch_of_[t] != kNone || groups_[t] != groups_[seed]) continue;
                if (!fits(t, normal_, base_)) {
                    met_more = true;
                    continue;
                }
                if (glm::dot(twice_area(t), normal_) < -kRim_m * longest(t)) continue;
                patch_of_[t] = seed;
                patch_.push_back(t);
            }
        }
        rim_m_ = std::max(kRim_m, 1e-3 * bound_m_) + 1e-13 * size_m_;
        return met_more;
    }

    double height(std::uint32_t t, std::size_t k) const { return glm::dot(corner(t, k) - base_, normal_); }
    double flat_area(std::uint32_t t) const { return 0.5 * glm::dot(twice_area(t), normal_); }

    // Returns the convex hull of points, given as indices of the mesh, counter-clockwise and without points on its
    // edges. Uses Andrew's monotone chain.
    std::vector<std::uint32_t> hull_of(std::vector<std::uint32_t> points) const {
        std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Vec2 p = flat_[a], q = flat_[b];
            return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
        });
        points.erase(std::unique(points.begin(), points.end()), points.end());
        if (points.size() < 3) return {};
        std::vector<std::uint32_t> hull;
        const auto half = [&](auto begin, auto end) {
            const std::size_t first = hull.size();
            for (auto it = begin; it != end; ++it) {
                while (hull.size() >= first + 2 && cross(flat_[hull.back()] - flat_[hull[hull.size() - 2]],
                                                         flat_[*it] - flat_[hull[hull.size() - 2]]) <= 0.0)
                    hull.pop_back();
                hull.push_back(*it);
            }
            hull.pop_back();
        };
        half(points.begin(), points.end());
        half(points.rbegin(), points.rend());
        return hull;
    }

    double area_of(const std::vector<std::uint32_t>& ring) const {
        double twice = 0.0;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i)
            twice += cross(flat_[ring[i]] - flat_[ring[0]], flat_[ring[i + 1]] - flat_[ring[0]]);
        return 0.5 * twice;
    }

    bool on_rim(const std::vector<std::uint32_t>& hull, std::uint32_t point) const {
        const Vec2 p = flat_[point];
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Vec2 a = flat_[hull[i]], edge = flat_[hull[(i + 1) % hull.size()]] - a;
            if (cross(edge, p - a) <= rim_m_ * glm::length(edge)) return true;
        }
        return false;
    }

    // Makes one polygon of the triangles in `triangles`, if their union is convex. The half-edges in `border` are the
    // border of the union. The union is convex if the whole border is on the convex hull and the hull has the same
    // area. Returns true on success.
    bool take(const std::vector<std::uint32_t>& border, const std::vector<std::uint32_t>& triangles, double area) {
        std::vector<std::uint32_t> points;
        points.reserve(border.size());
        for (const std::uint32_t h : border) points.push_back(origin(h));
        const std::vector<std::uint32_t> hull = hull_of(std::move(points));
        if (hull.size() < 3) return false;
        double around = 0.0;
        for (std::size_t i = 0; i < hull.size(); ++i)
            around += glm::length(flat_[hull[(i + 1) % hull.size()]] - flat_[hull[i]]);
        if (std::abs(area_of(hull) - area) > rim_m_ * around) return false;
        for (const std::uint32_t h : border)
            if (!on_rim(hull, origin(h))) return false;
        FlatPolygon polygon;
        for (const std::uint32_t p : hull) {
            const double off = glm::dot(mesh_.points_m[p] - base_, normal_);
            polygon.points_m.push_back(mesh_.points_m[p] - normal_ * off);
        }
        for (const std::uint32_t t : triangles)
            for (std::size_t k = 0; k < 3; ++k)
                result_.farthest_m = std::max(result_.farthest_m, std::abs(height(t, k)));
        polygon.triangles = triangles;
        std::sort(polygon.triangles.begin(), polygon.triangles.end());
        result_.polygons.push_back(std::move(polygon));
        return true;
    }

    // Returns true if the patch continues into a neighbouring triangle without a crease.
    bool on_curve() const {
        // Cosine of 30 degrees, the crease angle that shading uses too.
        constexpr double kCreaseCosine = 0.8660254037844386;
        for (const std::uint32_t t : patch_)
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
                if (twin_[h] == kNone) continue;
                const std::uint32_t beside = twin_[h] / 3;
                if (patch_of_[beside] == patch_of_[t] || groups_[beside] != groups_[t] || fits(beside, normal_, base_))
                    continue;
                const Vec3 turned = twice_area(beside);
                if (glm::dot(turned, normal_) > kCreaseCosine * glm::length(turned)) return true;
            }
        return false;
    }

    bool take_whole() {
        std::vector<std::uint32_t> border;
        double area = 0.0;
        for (const std::uint32_t t : patch_) {
            area += flat_area(t);
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
                if (twin_[h] == kNone || patch_of_[twin_[h] / 3] != patch_of_[t]) border.push_back(h);
        }
        return take(border, patch_, area);
    }

    // Returns the polygon of half-edge `h`. The polygons of the patch are rings of half-edges; ring_ finds the polygon
    // of a triangle by union-find over triangles.
    std::uint32_t ring_of(std::uint32_t h) {
        std::uint32_t t = h / 3;
        while (ring_[t] != t) t = ring_[t] = ring_[ring_[t]];
        return t;
    }

    // Joins the polygons on both sides of half-edge `h` if the result is convex. Removes all consecutive edges that the
    // two polygons share. Returns true if the polygons were joined.
    bool join(std::uint32_t h) {
        const std::uint32_t here = ring_of(h), there = ring_of(twin_[h]);
        if (here == there) return false;
        std::uint32_t first = h, last = h;
        while (next_[last] != first && twin_[next_[last]] != kNone && twin_[next_[last]] == prev_[twin_[last]])
            last = next_[last];
        while (prev_[first] != last && twin_[prev_[first]] != kNone && twin_[prev_[first]] == next_[twin_[first]])
            first = prev_[first];
        const std::uint32_t before = prev_[first], after = next_[last], there_after = next_[twin_[first]],
                            there_before = prev_[twin_[last]];
        // One of the polygons consists only of shared edges.
        if (before == last || there_before == twin_[first]) return false;
        const auto convex = [&](std::uint32_t in, std::uint32_t out) {
            const Vec2 a = flat_[target(in)] - flat_[origin(in)], b = flat_[target(out)] - flat_[origin(out)];
            const double longer = std::max(glm::length(a), glm::length(b));
            return cross(a, b) >= -0.25 * rim_m_ * longer && !(glm::dot(a, b) < 0.0 && cross(a, b) <= rim_m_ * longer);
        };
        if (!convex(before, there_after) || !convex(there_before, after)) return false;
        next_[before] = there_after;
        prev_[there_after] = before;
        next_[there_before] = after;
        prev_[after] = there_before;
        ring_[std::max(here, there)] = std::min(here, there);
        return true;
    }

    void take_parts() {
        ring_.resize(count_);
        std::vector<std::uint32_t> inner;
        for (const std::uint32_t t : patch_) {
            ring_[t] = t;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t h = 3 * t + k;
                next_[h] = 3 * t + (k + 1) % 3;
                prev_[h] = 3 * t + (k + 2) % 3;
                if (twin_[h] != kNone && patch_of_[twin_[h] / 3] != patch_of_[t]) outside_.push_back(h);
                else if (twin_[h] != kNone && h < twin_[h]) inner.push_back(h);
            }
        }
        // An edge to a triangle outside the patch is part of the border. Such half-edges lose their twins here and get
        // them back below.
        std::vector<std::uint32_t> cut_off;
        for (const std::uint32_t h : outside_) cut_off.push_back(std::exchange(twin_[h], kNone));
        const auto length2 = [&](std::uint32_t h) {
            const Vec2 d = flat_[target(h)] - flat_[origin(h)];
            return d.x * d.x + d.y * d.y;
        };
        std::sort(inner.begin(), inner.end(), [&](std::uint32_t a, std::uint32_t b) {
            return length2(a) != length2(b) ? length2(a) > length2(b) : a < b;
        });
        for (bool more = true; more;) {
            more = false;
            for (const std::uint32_t h : inner) more = join(h) || more;
            std::erase_if(inner, [&](std::uint32_t h) { return ring_of(h) == ring_of(twin_[h]); });
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> members;  // pairs of a polygon and one of its triangles
        for (const std::uint32_t t : patch_) members.emplace_back(ring_of(3 * t), t);
        std::sort(members.begin(), members.end());
        for (std::size_t i = 0; i < members.size();) {
            std::vector<std::uint32_t> triangles;
            double area = 0.0;
            const std::uint32_t ring = members[i].first;
            for (; i < members.size() && members[i].first == ring; ++i) {
                triangles.push_back(members[i].second);
                area += flat_area(members[i].second);
            }
            if (triangles.size() < 2) continue;
            std::vector<std::uint32_t> border;
            for (const std::uint32_t t : triangles)
                for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
                    if (twin_[h] == kNone || ring_of(twin_[h]) != ring) border.push_back(h);
            take(border, triangles, area);
        }
        for (std::size_t i = 0; i < outside_.size(); ++i) twin_[outside_[i]] = cut_off[i];
        outside_.clear();
    }

    const TriangleMesh& mesh_;
    std::span<const std::uint32_t> groups_;
    const double bound_m_;
    const std::uint32_t count_;
    std::vector<std::uint32_t> twin_, next_, prev_, ring_;
    std::vector<std::uint32_t> patch_of_;  // for each triangle, the seed triangle of its patch
    std::vector<Vec2> flat_;               // mesh points projected to the plane of the current patch
    FlatMerge result_;

    // The current patch: its triangles, its neighbours outside, and the frame of its plane.
    std::vector<std::uint32_t> patch_, outside_;
    Vec3 normal_{0.0}, base_{0.0}, across_{0.0}, along_{0.0};
    double size_m_ = 0.0, rim_m_ = 0.0;
};

}  // namespace

FlatMerge merge_flat(const TriangleMesh& mesh, std::span<const std::uint32_t> groups, double bound_m,
                     bool keep_curves) {
    contract_pre(groups.size() == mesh.triangles.size());
    contract_pre(bound_m >= 0.0);
    return Merger(mesh, groups, bound_m).run(keep_curves);
}

}  // namespace handrail::compile
