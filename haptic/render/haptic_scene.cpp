#include "haptic/render/haptic_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>

#include "worlds/base/overloaded.h"

namespace handrail {
namespace {

// Bounds of brushes come from computed corners; this much more makes sure that no rounding hides a solid from the hierarchy.
constexpr double kBoundsSlack = 1e-9;
// Below this distance from the world's zero neighbouring doubles are at most 2e-13 m apart, so nothing is gained by moving the origin.
constexpr double kNearZero_m = 1024.0;

// A liquid's surface looks up if its normal rises by more than 45 degrees.
constexpr double kLooksUp = 0.7071;
// Steepest slopes of the laws in liquids.cpp: the drag's spring; a film 4 mm thick and a buoyancy that sets in over 20 mm, for each newton.
constexpr double kDragStiffness_n_per_m = 400.0;
constexpr double kFilmStiffness_per_m = 583.0;
constexpr double kBuoyancyStiffness_per_m = 75.0;

void move_effect(EffectVolume& effect, const Vec3& by_m) {
    std::visit(Overloaded{[&](Aabb& box) {
                              box.min_m += by_m;
                              box.max_m += by_m;
                          },
                          [&](SphereRegion& sphere) { sphere.centre_m += by_m; },
                          [&](CapsuleRegion& capsule) {
                              capsule.a_m += by_m;
                              capsule.b_m += by_m;
                          },
                          [&](ConvexRegion& convex) {
                              for (Plane& plane : convex.planes) plane.offset_m += glm::dot(plane.normal, by_m);
                          }},
               effect.region);
    std::visit(Overloaded{[&](MagnetLaw& law) {
                              for (MagnetTarget& target : law.targets) target.centre_m += by_m;
                          },
                          [&](DetentLaw& law) { law.origin_m += by_m; }, [&](ButtonLaw& law) { law.origin_m += by_m; }, [](auto&) {}},
               effect.law);
}

Aabb grown(Aabb box) {
    const double largest = std::max(
        {1.0, std::abs(box.min_m.x), std::abs(box.min_m.y), std::abs(box.min_m.z), std::abs(box.max_m.x), std::abs(box.max_m.y), std::abs(box.max_m.z)});
    box.min_m -= Vec3(kBoundsSlack * largest);
    box.max_m += Vec3(kBoundsSlack * largest);
    return box;
}

// 0 to 5 for -x +x -y +y -z +z; -1 for a slanted plane.
int axis_side(const Vec3& normal) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) == 1.0 && normal[(axis + 1) % 3] == 0.0 && normal[(axis + 2) % 3] == 0.0) return 2 * axis + (normal[axis] > 0.0 ? 1 : 0);
    return -1;
}

}  // namespace

ClosestPoint HapticScene::closest(std::uint32_t obstacle, const Vec3& local_m) const noexcept {
    const Obstacle& o = obstacles[obstacle];
    switch (o.kind) {
        case ObstacleKind::Triangle:
            return closest_point(triangle(o), local_m);
        case ObstacleKind::Box:
            return closest_point(boxes[o.shape], local_m);
        case ObstacleKind::Brush:
            break;
    }
    return closest_point(std::span(planes).subspan(o.shape, o.planes), local_m);
}

const SurfaceLabel& HapticScene::surface(std::uint32_t obstacle, const Vec3& normal) const noexcept {
    const Obstacle& o = obstacles[obstacle];
    if (o.kind == ObstacleKind::Triangle) return labels[o.first_label];
    const std::uint32_t faces = o.kind == ObstacleKind::Box ? 6 : o.planes;
    std::uint32_t best = 0;
    double best_along = -std::numeric_limits<double>::infinity();
    for (std::uint32_t face = 0; face < faces; ++face) {
        double along =
            o.kind == ObstacleKind::Box ? (face % 2 == 1 ? 1.0 : -1.0) * normal[static_cast<int>(face / 2)] : glm::dot(planes[o.shape + face].normal, normal);
        if (labels[o.first_label + face].hidden) along -= 4.0;
        if (along > best_along) {
            best_along = along;
            best = face;
        }
    }
    return labels[o.first_label + best];
}

HapticSceneBuilder::HapticSceneBuilder(std::vector<HapticMaterial> materials) {
    scene_.materials = std::move(materials);
    if (scene_.materials.empty()) scene_.materials.emplace_back();
}

void HapticSceneBuilder::add_sheet(const Corners& corners, const SurfaceLabel& label) {
    const bool same = !scene_.obstacles.empty() && scene_.obstacles.back().kind == ObstacleKind::Triangle && scene_.labels.back() == label;
    if (!same) scene_.labels.push_back(label);
    scene_.obstacles.push_back(
        {ObstacleKind::Triangle, static_cast<std::uint32_t>(scene_.mesh.triangles.size()), 0, static_cast<std::uint32_t>(scene_.labels.size()) - 1});
    scene_.mesh.triangles.push_back(corners);
    Aabb bounds;
    for (const std::uint32_t corner : corners) bounds.include(scene_.mesh.points_m[corner]);
    obstacle_bounds_.push_back(bounds);
}

void HapticSceneBuilder::add_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const SurfaceLabel& label) {
    const auto first = static_cast<std::uint32_t>(scene_.mesh.points_m.size());
    scene_.mesh.points_m.insert(scene_.mesh.points_m.end(), {a_m, b_m, c_m});
    add_sheet({first, first + 1, first + 2}, label);
}

void HapticSceneBuilder::add_mesh(const TriangleMesh& mesh, std::span<const SurfaceLabel> labels) {
    const auto first = static_cast<std::uint32_t>(scene_.mesh.points_m.size());
    scene_.mesh.points_m.insert(scene_.mesh.points_m.end(), mesh.points_m.begin(), mesh.points_m.end());
    const std::size_t all = mesh.triangles.size();
    scene_.mesh.triangles.reserve(scene_.mesh.triangles.size() + all);
    scene_.obstacles.reserve(scene_.obstacles.size() + all);
    obstacle_bounds_.reserve(obstacle_bounds_.size() + all);
    for (std::size_t i = 0; i < all; ++i) {
        const Corners& t = mesh.triangles[i];
        add_sheet({first + t[0], first + t[1], first + t[2]}, labels[labels.size() == all ? i : 0]);
    }
}

void HapticSceneBuilder::add_box(const Aabb& box_m, std::span<const SurfaceLabel> labels) {
    const auto first_label = static_cast<std::uint32_t>(scene_.labels.size());
    for (std::size_t face = 0; face < 6; ++face) scene_.labels.push_back(labels[labels.size() == 6 ? face : 0]);
    scene_.obstacles.push_back({ObstacleKind::Box, static_cast<std::uint32_t>(scene_.boxes.size()), 0, first_label});
    scene_.boxes.push_back(box_m);
    obstacle_bounds_.push_back(box_m);
}

void HapticSceneBuilder::add_solid(std::span<const Plane> planes, const Aabb& bounds_m, std::span<const SurfaceLabel> labels) {
    const auto label_of = [&](std::size_t face) { return labels[labels.size() == planes.size() ? face : 0]; };
    if (planes.size() == 6) {
        std::array<bool, 6> seen{};
        std::array<SurfaceLabel, 6> sides;
        Aabb box;
        bool axis_aligned = true;
        for (std::size_t face = 0; face < 6 && axis_aligned; ++face) {
            const int side = axis_side(planes[face].normal);
            axis_aligned = side >= 0 && !seen[static_cast<std::size_t>(side)];
            if (!axis_aligned) break;
            seen[static_cast<std::size_t>(side)] = true;
            sides[static_cast<std::size_t>(side)] = label_of(face);
            (side % 2 == 1 ? box.max_m : box.min_m)[side / 2] = side % 2 == 1 ? planes[face].offset_m : -planes[face].offset_m;
        }
        if (axis_aligned) return add_box(box, sides);
    }
    const auto first_label = static_cast<std::uint32_t>(scene_.labels.size());
    for (std::size_t face = 0; face < planes.size(); ++face) scene_.labels.push_back(label_of(face));
    scene_.obstacles.push_back({ObstacleKind::Brush, static_cast<std::uint32_t>(scene_.planes.size()), static_cast<std::uint32_t>(planes.size()), first_label});
    scene_.planes.insert(scene_.planes.end(), planes.begin(), planes.end());
    obstacle_bounds_.push_back(grown(bounds_m));
}

void HapticSceneBuilder::add_liquid(LiquidVolume liquid, const Aabb& bounds_m) {
    scene_.liquids.push_back(std::move(liquid));
    liquid_bounds_.push_back(grown(bounds_m));
}

bool HapticSceneBuilder::add_body(FeatureId feature, std::shared_ptr<const HapticScene> shape, const Placement& start, bool present) {
    if (scene_.bodies.size() == HapticScene::kMostBodies) return false;
    Aabb all = shape->obstacle_bvh.bounds();
    double reach = 0.0;
    if (!all.empty()) {
        all.min_m += shape->origin_m;
        all.max_m += shape->origin_m;
        reach = glm::length(glm::max(glm::abs(all.min_m), glm::abs(all.max_m)));
    }
    scene_.bodies.push_back({feature, std::move(shape), start, present, reach});
    return true;
}

bool HapticSceneBuilder::add_effect(EffectVolume effect) {
    const bool hangs = effect.body != EffectVolume::kNoBody;
    if (!is_sound(effect) || (hangs && effect.body >= scene_.bodies.size())) return false;
    effect_bounds_.push_back(hangs ? Aabb{} : grown(bounds_of(effect.region)));
    if (hangs) scene_.hanging_effects.push_back(static_cast<std::uint32_t>(scene_.effects.size()));
    scene_.effects.push_back(std::move(effect));
    return true;
}

// What a tick would otherwise have to find out again and again. After the bounds are final.
void HapticSceneBuilder::prepare_effects() {
    // What hangs on a body, and so has no bounds here, may come anywhere.
    const auto overlap = [](const Aabb& a, const Aabb& b) {
        if (a.empty() || b.empty()) return true;
        return glm::all(glm::lessThanEqual(a.min_m, b.max_m)) && glm::all(glm::lessThanEqual(b.min_m, a.max_m));
    };
    for (LiquidVolume& liquid : scene_.liquids) {
        double highest = kLooksUp;
        for (std::size_t i = 0; i < liquid.planes.size(); ++i)
            if (!liquid.hidden[i] && liquid.planes[i].normal.z > highest) {
                highest = liquid.planes[i].normal.z;
                liquid.surface = static_cast<int>(i);
            }
        if (liquid.buoyancy_n > 0.0 || liquid.film_n > 0.0) {
            scene_.liquid_surfaces = true;
            liquid.inner_radius_m = inner_radius_m(ConvexRegion{liquid.planes});
        }
        liquid.crowd_stiffness_n_per_m = (liquid.viscosity_ns_per_m > 0.0 ? kDragStiffness_n_per_m : 0.0) + kFilmStiffness_per_m * liquid.film_n +
                                         kBuoyancyStiffness_per_m * liquid.buoyancy_n;
    }
    std::vector<double> liquid_own;
    for (const LiquidVolume& liquid : scene_.liquids) liquid_own.push_back(liquid.crowd_stiffness_n_per_m);
    for (std::size_t i = 0; i < scene_.effects.size(); ++i) {
        EffectVolume& effect = scene_.effects[i];
        effect.inner_radius_m = inner_radius_m(effect.region);
        effect.stiffness_n_per_m = effect.crowd_stiffness_n_per_m = stiffness_bound_n_per_m(effect.law);
    }
    for (std::size_t i = 0; i < scene_.effects.size(); ++i) {
        EffectVolume& effect = scene_.effects[i];
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(effect_bounds_[i], effect_bounds_[j])) {
                effect.crowd_stiffness_n_per_m += scene_.effects[j].stiffness_n_per_m;
                scene_.effects[j].crowd_stiffness_n_per_m += effect.stiffness_n_per_m;
            }
        double liquid_stiffness = 0.0;
        for (std::size_t k = 0; k < scene_.liquids.size(); ++k)
            if (overlap(effect_bounds_[i], liquid_bounds_[k])) {
                liquid_stiffness = std::max(liquid_stiffness, liquid_own[k]);  // neighbours share, they do not add up
                scene_.liquids[k].crowd_stiffness_n_per_m += effect.stiffness_n_per_m;
            }
        effect.crowd_stiffness_n_per_m += liquid_stiffness;
        const Aabb& box = effect_bounds_[i];
        effect.by_obstacle = box.empty() || !scene_.bodies.empty();
        if (!effect.by_obstacle)
            scene_.obstacle_bvh.within(box.centre_m(), 0.5 * glm::length(box.size_m()),
                                       [&](std::uint32_t item, double&) { effect.by_obstacle = effect.by_obstacle || overlap(box, obstacle_bounds_[item]); });
    }
}

std::shared_ptr<const HapticScene> HapticSceneBuilder::build(std::uint32_t world) {
    // The one number that must differ between scenes wherever they are built; nothing else is shared.
    static std::atomic<std::uint32_t> next_generation{1};
    Aabb all;
    for (const Aabb& box : obstacle_bounds_) all.include(box);
    for (const Aabb& box : liquid_bounds_) all.include(box);
    for (const Aabb& box : effect_bounds_) all.include(box);
    const auto far_from_zero = [](const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kNearZero_m; };
    if (!all.empty() && (far_from_zero(all.min_m) || far_from_zero(all.max_m))) scene_.origin_m = glm::round(all.centre_m());
    const Vec3 origin = scene_.origin_m;
    for (Vec3& p : scene_.mesh.points_m) p -= origin;
    const auto shift = [&origin](Aabb& box) {
        box.min_m -= origin;
        box.max_m -= origin;
    };
    const auto shift_plane = [&origin](Plane& plane) { plane.offset_m -= glm::dot(plane.normal, origin); };
    for (Aabb& box : scene_.boxes) shift(box);
    for (Plane& plane : scene_.planes) shift_plane(plane);
    for (LiquidVolume& liquid : scene_.liquids)
        for (Plane& plane : liquid.planes) shift_plane(plane);
    for (Aabb& box : obstacle_bounds_) shift(box);
    for (Aabb& box : liquid_bounds_) shift(box);
    for (Aabb& box : effect_bounds_) shift(box);
    for (EffectVolume& effect : scene_.effects)
        if (effect.body == EffectVolume::kNoBody) move_effect(effect, -origin);
    scene_.obstacle_bvh = Bvh(obstacle_bounds_);
    scene_.liquid_bvh = Bvh(liquid_bounds_);
    scene_.effect_bvh = Bvh(effect_bounds_);
    prepare_effects();
    scene_.generation = next_generation.fetch_add(1);
    scene_.world = world != 0 ? world : scene_.generation;
    return std::make_shared<const HapticScene>(std::move(scene_));
}

}  // namespace handrail
