// Implements the free-cell proxy in single precision, with the same projection and the same lazy renewal of cuts from
// one place ahead as in Handrail's renderer. All coordinates, closest points and cuts have 32 bits, relative to the
// scene's origin, as meshes for drawing have. The arc step around edges of solids is left out. The closest point of a
// triangle is found by three plane tests and clamped edges, that of a solid by projection. Round solids are queried in
// double precision, and the results are rounded.
#include <array>

#include "tests/bench/compare/contestant.h"
#include "tests/bench/compare/nearby.h"
#include "tests/support/names.h"
#include "worlds/geometry/half_space_projection.h"

namespace handrail::bench {
namespace {

using F3 = glm::vec<3, float>;
using Cut = BasicHalfSpace<float>;

struct Closest {
    F3 point{0.0F}, normal{0.0F, 0.0F, 1.0F};
    float distance = 0.0F;
};

Closest from(const F3& point, const F3& at, const F3& sideless) {
    const F3 away = at - point;
    const float distance = glm::length(away);
    return {point, distance > 1e-12F ? away / distance : sideless, distance};
}

struct Shape {
    enum class Kind { Triangle, Solid, Other } kind = Kind::Other;
    std::uint32_t obstacle = 0;
    F3 a{0.0F}, b{0.0F}, c{0.0F}, normal{0.0F};
    std::vector<Cut> planes;  // normals that point out of the solid, and offsets along them
};

class SinglePrecision {
public:
    SinglePrecision(const BenchWorld& world, double)
        : world_(world), scene_(*world.scene), radius_(static_cast<float>(world.radius_m)) {}

    TickOutcome tick(const Vec3& goal_m) {
        const F3 goal(goal_m - scene_.origin_m);
        if (!placed_) {
            proxy_ = goal;
            placed_ = true;
        }
        const float reach = static_cast<float>(world_.radius_m) + glm::length(goal - proxy_);
        if (!(glm::length(proxy_ - centre_) + reach <= known_)) {
            gather(reach + margin_);
            if (cuts_.size() > Nearby::kComfortable)
                margin_ = std::max(static_cast<float>(Nearby::kLeastMargin_m), 0.5F * margin_);
            if (cuts_.size() < Nearby::kComfortable / 3)
                margin_ = std::min(static_cast<float>(Nearby::kMargin_m), 2.0F * margin_);
        }
        ++tick_;
        int rounds = 0;
        while (rounds < 64) {
            ++rounds;
            const bool solved = project_on_half_spaces(
                goal - proxy_, static_cast<int>(cuts_.size()),
                [&](int i) {
                    const Cut& cut = cuts_[static_cast<std::size_t>(i)];
                    return Cut{cut.normal, cut.offset_m + radius_ - glm::dot(cut.normal, proxy_)};
                },
                basis_);
            F3 way = basis_.point_m;
            if (!solved) way *= part_inside(way);
            proxy_ += way;
            if (basis_.count == 0 || !renew(goal)) break;
        }
        return {basis_.count == 0 && proxy_ == goal ? goal_m : scene_.origin_m + Vec3(proxy_), rounds};
    }

private:
    static constexpr float kTouching = 1e-6F;

    void gather(float reach) {
        shapes_.clear();
        cuts_.clear();
        looked_ahead_.clear();
        basis_.count = 0;
        const Vec3 at(proxy_);
        scene_.obstacle_bvh.within(at, reach, [&](std::uint32_t item, double&) {
            if (scene_.closest(item, at).distance_m > reach) return;
            shapes_.push_back(shape_of(item));
            const Closest closest = nearest(shapes_.back(), proxy_);
            cuts_.push_back({closest.normal, glm::dot(closest.normal, closest.point)});
            looked_ahead_.push_back(0);
        });
        centre_ = proxy_;
        known_ = reach;
    }

    Shape shape_of(std::uint32_t obstacle) const {
        Shape shape;
        shape.obstacle = obstacle;
        const test::BruteForce::Thing* thing = world_.thing(obstacle);
        const auto local = [&](const test::LVec& p) { return F3(Vec3(p) - scene_.origin_m); };
        if (thing && !thing->planes.empty()) {
            shape.kind = Shape::Kind::Solid;
            for (const Plane& plane : thing->planes)
                shape.planes.push_back(
                    {F3(plane.normal), static_cast<float>(plane.offset_m - glm::dot(plane.normal, scene_.origin_m))});
        } else if (thing && !thing->solid && scene_.obstacles[obstacle].kind == ObstacleKind::Triangle) {
            shape.kind = Shape::Kind::Triangle;
            shape.a = local(thing->a), shape.b = local(thing->b), shape.c = local(thing->c);
            const F3 area = glm::cross(shape.b - shape.a, shape.c - shape.a);
            const float twice = glm::length(area);
            if (twice > 1e-12F) shape.normal = area / twice;
        }
        return shape;
    }

    Closest nearest(const Shape& s, const F3& p) const {
        switch (s.kind) {
            case Shape::Kind::Triangle: {
                const F3 edges[3][2] = {{s.a, s.b}, {s.b, s.c}, {s.c, s.a}};
                const bool flat = s.normal == F3(0.0F);
                bool inside = !flat;
                for (const auto& [from_corner, to_corner] : edges)
                    inside = inside && glm::dot(p - from_corner, glm::cross(to_corner - from_corner, s.normal)) <= 0.0F;
                if (inside) {
                    const float height = glm::dot(p - s.a, s.normal);
                    return {p - s.normal * height, height < 0.0F ? -s.normal : s.normal, std::abs(height)};
                }
                Closest best;
                best.distance = std::numeric_limits<float>::infinity();
                for (const auto& [from_corner, to_corner] : edges) {
                    if (!flat && glm::dot(p - from_corner, glm::cross(to_corner - from_corner, s.normal)) <= 0.0F)
                        continue;
                    const F3 edge = to_corner - from_corner;
                    const float length2 = glm::dot(edge, edge);
                    const float t =
                        length2 > 0.0F ? std::clamp(glm::dot(p - from_corner, edge) / length2, 0.0F, 1.0F) : 0.0F;
                    const Closest one = from(from_corner + edge * t, p, flat ? F3(0.0F, 0.0F, 1.0F) : s.normal);
                    if (one.distance < best.distance) best = one;
                }
                return best;
            }
            case Shape::Kind::Solid: {
                float deepest = -std::numeric_limits<float>::infinity();
                const Cut* face = nullptr;
                for (const Cut& plane : s.planes)
                    if (const float out = glm::dot(plane.normal, p) - plane.offset_m; out > deepest) {
                        deepest = out;
                        face = &plane;
                    }
                const Closest on_face{p - face->normal * deepest, face->normal, deepest};
                if (deepest <= 1e-12F) return on_face;
                BasicProjectionBasis<float> basis;
                const bool solved = project_on_half_spaces(
                    F3(0.0F), static_cast<int>(s.planes.size()),
                    [&](int i) {
                        const Cut& plane = s.planes[static_cast<std::size_t>(i)];
                        return Cut{-plane.normal, glm::dot(plane.normal, p) - plane.offset_m};
                    },
                    basis);
                if (!solved || basis.count < 2) return on_face;
                return from(p + basis.point_m, p, face->normal);
            }
            case Shape::Kind::Other:
                break;
        }
        const ClosestPoint closest = scene_.closest(s.obstacle, Vec3(p));
        return {F3(closest.point_m), F3(closest.normal), static_cast<float>(closest.distance_m)};
    }

    float part_inside(const F3& way) const {
        float part = 1.0F;
        for (const Cut& cut : cuts_) {
            const float towards = -glm::dot(cut.normal, way);
            if (towards <= 0.0F) continue;
            const float gap = std::max(0.0F, glm::dot(cut.normal, proxy_) - cut.offset_m - radius_);
            if (gap < part * towards) part = gap / towards;
        }
        return part;
    }

    bool renew(const F3& goal) {
        const BasicProjectionBasis<float> held = basis_;
        const std::vector<Cut>& cuts = cuts_;
        const auto wall = [&](int k) {
            const Cut& cut = cuts[static_cast<std::size_t>(held.index[static_cast<std::size_t>(k)])];
            return Cut{cut.normal, cut.offset_m + radius_};
        };
        std::array<F3, 3> ahead{goal, goal, goal};
        for (int k = 0; k < held.count && held.count > 1; ++k) {
            BasicProjectionBasis<float> rest;
            project_on_half_spaces(
                goal, held.count - 1, [&](int i) { return wall((k + 1 + i) % held.count); }, rest);
            ahead[static_cast<std::size_t>(k)] = rest.point_m;
        }
        const F3 pull = goal - proxy_;
        bool stale = false;
        for (int k = 0; k < held.count; ++k) {
            const auto i = static_cast<std::size_t>(held.index[static_cast<std::size_t>(k)]);
            const F3 old = cuts_[i].normal;
            Closest closest = nearest(shapes_[i], proxy_);
            cuts_[i] = {closest.normal, glm::dot(closest.normal, closest.point)};
            const bool apart = closest.distance - radius_ > kTouching;
            if (apart && looked_ahead_[i] != tick_) {
                looked_ahead_[i] = tick_;
                closest = nearest(shapes_[i], ahead[static_cast<std::size_t>(k)]);
                const Cut further{closest.normal, glm::dot(closest.normal, closest.point)};
                if (closest.distance > 1e-12F &&
                    glm::dot(further.normal, proxy_) - further.offset_m >= radius_ - kProjectionToleranceOf<float>)
                    cuts_[i] = further;
            }
            const F3 turn = cuts_[i].normal - old;
            stale = stale || apart || glm::dot(turn, turn) * glm::dot(pull, pull) > kTouching * kTouching;
        }
        return stale;
    }

    const BenchWorld& world_;
    const HapticScene& scene_;
    float radius_;
    bool placed_ = false;
    F3 proxy_{0.0F}, centre_{0.0F};
    float known_ = -1.0F;
    float margin_ = static_cast<float>(Nearby::kMargin_m);
    std::uint64_t tick_ = 0;
    std::vector<Shape> shapes_;
    std::vector<Cut> cuts_;
    std::vector<std::uint64_t> looked_ahead_;
    BasicProjectionBasis<float> basis_;
};

}  // namespace

Contestant single_precision() {
    return contestant<SinglePrecision>("single_precision", "Handrail's solver in single precision");
}

}  // namespace handrail::bench
