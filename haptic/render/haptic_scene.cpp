#include "haptic/render/haptic_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>

#include "worlds/base/overloaded.h"

namespace handrail::render {
namespace {

// The bounds of brushes are computed from corners that have rounding errors. The bounds are enlarged by kBoundsSlack,
// so that no solid extends beyond its bounds.
constexpr double kBoundsSlack = 1e-9;
// Below this distance from the origin, neighbouring doubles are at most 2e-13 m apart, so moving the origin gains
// nothing.
constexpr double kNearZero_m = 1024.0;

// Least vertical component of the normal of a liquid's open surface, which must be less than 45 degrees from vertical.
constexpr double kLooksUp = 0.7071;
// Steepest slopes of the laws in liquids.cpp. kDragStiffness_n_per_m is the stiffness of the drag's spring. The others
// are per newton, for a film 4 mm thick and a buoyancy that rises over 20 mm.
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
                          [&](DetentLaw& law) { law.origin_m += by_m; }, [&](ButtonLaw& law) { law.origin_m += by_m; },
                          [](auto&) {}},
               effect.law);
}

Aabb grown(Aabb box) {
    const double largest = std::max({1.0, std::abs(box.min_m.x), std::abs(box.min_m.y), std::abs(box.min_m.z),
                                     std::abs(box.max_m.x), std::abs(box.max_m.y), std::abs(box.max_m.z)});
    box.min_m -= Vec3(kBoundsSlack * largest);
    box.max_m += Vec3(kBoundsSlack * largest);
    return box;
}

// Returns 0 to 5 for the directions -x +x -y +y -z +z, and -1 for a slanted plane.
int axis_side(const Vec3& normal) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) == 1.0 && normal[(axis + 1) % 3] == 0.0 && normal[(axis + 2) % 3] == 0.0)
            return 2 * axis + (normal[axis] > 0.0 ? 1 : 0);
    return -1;
}

}  // namespace

ClosestPoint HapticScene::closest_but_triangle(const Obstacle& o, const Vec3& local_m) const noexcept {
    switch (o.kind) {
        case ObstacleKind::Polygon: {
            const PolygonRange& range = polygons[o.shape];
            return closest_point(
                PolygonShape{range.normal, std::span(polygon_corners).subspan(range.first_corner, range.corners)},
                local_m);
        }
        case ObstacleKind::Box:
            if (o.rounding != 0) return closest_point(boxes[o.shape], rounding_m(o), local_m);
            return closest_point(boxes[o.shape], local_m);
        case ObstacleKind::Sphere:
            return closest_point(spheres[o.shape], local_m);
        case ObstacleKind::Capsule:
            return closest_point(capsules[o.shape], local_m);
        case ObstacleKind::Cylinder:
            return closest_point(cylinders[o.shape], local_m);
        case ObstacleKind::Cone:
            return closest_point(cones[o.shape], local_m);
        case ObstacleKind::Custom: {
            const CustomObstacle& custom = customs[o.shape];
            ClosestPoint found = custom.closest(local_m - custom.position_m, custom.data.get());
            found.point_m += custom.position_m;
            return found;
        }
        case ObstacleKind::Brush:
        case ObstacleKind::Triangle:
            break;
    }
    const std::span solid = std::span(planes).subspan(o.shape, o.planes);
    return o.rounding != 0 ? closest_point(solid, rounding_m(o), local_m) : closest_point(solid, local_m);
}

double HapticScene::in_front_m(std::uint32_t obstacle, const Vec3& local_m) const noexcept {
    const Obstacle& o = obstacles[obstacle];
    double height = 0.0;
    if (o.kind == ObstacleKind::Triangle) {
        const TriangleShape shape = triangle(o);
        height = glm::dot(shape.normal, local_m - shape.a_m);
    } else {
        const PolygonRange& range = polygons[o.shape];
        height = glm::dot(range.normal, local_m - polygon_corners[range.first_corner].at_m);
    }
    return o.side == TouchSide::Back ? -height : height;
}

bool HapticScene::smooth_between(std::uint32_t obstacle, const Vec3& normal_a, const Vec3& normal_b) const noexcept {
    constexpr double kSame = 1e-12;  // tolerance for the component of a normal along the axis
    const Obstacle& o = obstacles[obstacle];
    const auto both = [&](const Vec3& axis, double along) {
        return std::abs(glm::dot(axis, normal_a) - along) <= kSame &&
               std::abs(glm::dot(axis, normal_b) - along) <= kSame;
    };
    switch (o.kind) {
        case ObstacleKind::Sphere:
        case ObstacleKind::Capsule:
            return true;
        case ObstacleKind::Cylinder:
            return both(cylinders[o.shape].axis, 0.0);
        case ObstacleKind::Cone:
            return both(cones[o.shape].axis, cones[o.shape].slant_up);
        default:
            return false;
    }
}

std::uint32_t HapticScene::face(std::uint32_t obstacle, const Vec3& normal) const noexcept {
    const Obstacle& o = obstacles[obstacle];
    switch (o.kind) {
        case ObstacleKind::Triangle:
        case ObstacleKind::Sphere:
        case ObstacleKind::Capsule:
        case ObstacleKind::Custom:
            return 0;
        case ObstacleKind::Polygon:
            return glm::dot(polygons[o.shape].normal, normal) < 0.0 ? 1 : 0;
        case ObstacleKind::Cylinder:
            return static_cast<std::uint32_t>(face_towards(cylinders[o.shape], normal));
        case ObstacleKind::Cone:
            return static_cast<std::uint32_t>(face_towards(cones[o.shape], normal));
        case ObstacleKind::Box:
        case ObstacleKind::Brush:
            break;
    }
    const SurfaceLabel* const label = &labels[o.first_label];
    std::uint32_t best = 0;
    double best_along = -std::numeric_limits<double>::infinity();
    const auto look = [&](std::uint32_t face, double along) noexcept {
        if (label[face].hidden) along -= 4.0;
        if (!(along > best_along)) return;
        best_along = along;
        best = face;
    };
    if (o.kind == ObstacleKind::Box) {
        look(0, -normal.x);
        look(1, normal.x);
        look(2, -normal.y);
        look(3, normal.y);
        look(4, -normal.z);
        look(5, normal.z);
    } else {
        for (std::uint32_t face = 0; face < o.planes; ++face)
            look(face, glm::dot(planes[o.shape + face].normal, normal));
    }
    return best;
}

std::array<std::size_t, kObstacleKinds> HapticScene::obstacle_counts() const noexcept {
    std::array<std::size_t, kObstacleKinds> counts{};
    for (const Obstacle& o : obstacles) ++counts[static_cast<std::size_t>(o.kind)];
    return counts;
}

HapticSceneBuilder::HapticSceneBuilder(std::vector<HapticMaterial> materials) {
    scene_.materials = std::move(materials);
    if (scene_.materials.empty()) scene_.materials.emplace_back();
}

void HapticSceneBuilder::add_obstacle(ObstacleKind kind, std::size_t shape, std::size_t faces,
                                      std::span<const SurfaceLabel> labels, const Aabb& bounds_m) {
    Obstacle obstacle;
    obstacle.kind = kind;
    obstacle.shape = static_cast<std::uint32_t>(shape);
    obstacle.planes = kind == ObstacleKind::Brush ? static_cast<std::uint32_t>(faces) : 0;
    obstacle.first_label = static_cast<std::uint32_t>(scene_.labels.size());
    for (std::size_t face = 0; face < faces; ++face) scene_.labels.push_back(labels[labels.size() == faces ? face : 0]);
    scene_.obstacles.push_back(obstacle);
    obstacle_bounds_.push_back(bounds_m);
}

void HapticSceneBuilder::add_sheet(const Corners& corners, const SurfaceLabel& label, TouchSide side) {
    const bool same = !scene_.obstacles.empty() && scene_.obstacles.back().kind == ObstacleKind::Triangle &&
                      scene_.labels.back() == label;
    if (!same) scene_.labels.push_back(label);
    scene_.obstacles.push_back({ObstacleKind::Triangle, side, 0,
                                static_cast<std::uint32_t>(scene_.mesh.triangles.size()), 0,
                                static_cast<std::uint32_t>(scene_.labels.size()) - 1});
    scene_.mesh.triangles.push_back(corners);
    Aabb bounds;
    for (const std::uint32_t corner : corners) bounds.include(scene_.mesh.points_m[corner]);
    obstacle_bounds_.push_back(bounds);
}

void HapticSceneBuilder::add_polygon(std::span<const Vec3> points_m, std::span<const SurfaceLabel> labels,
                                     TouchSide side) {
    Aabb bounds;
    for (const Vec3& p : points_m) bounds.include(p);
    add_obstacle(ObstacleKind::Polygon, scene_.polygons.size(), 2, labels, bounds);
    scene_.obstacles.back().side = side;
    scene_.polygons.push_back({Vec3(0.0), static_cast<std::uint32_t>(scene_.polygon_corners.size()),
                               static_cast<std::uint32_t>(points_m.size())});
    for (const Vec3& p : points_m) scene_.polygon_corners.push_back({p, Vec3(0.0)});
}

void HapticSceneBuilder::add_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const SurfaceLabel& label,
                                      TouchSide side) {
    const auto first = static_cast<std::uint32_t>(scene_.mesh.points_m.size());
    scene_.mesh.points_m.insert(scene_.mesh.points_m.end(), {a_m, b_m, c_m});
    add_sheet({first, first + 1, first + 2}, label, side);
}

void HapticSceneBuilder::add_mesh(const TriangleMesh& mesh, std::span<const SurfaceLabel> labels, TouchSide side) {
    const auto first = static_cast<std::uint32_t>(scene_.mesh.points_m.size());
    scene_.mesh.points_m.insert(scene_.mesh.points_m.end(), mesh.points_m.begin(), mesh.points_m.end());
    const std::size_t all = mesh.triangles.size();
    scene_.mesh.triangles.reserve(scene_.mesh.triangles.size() + all);
    scene_.obstacles.reserve(scene_.obstacles.size() + all);
    obstacle_bounds_.reserve(obstacle_bounds_.size() + all);
    for (std::size_t i = 0; i < all; ++i) {
        const Corners& t = mesh.triangles[i];
        add_sheet({first + t[0], first + t[1], first + t[2]}, labels[labels.size() == all ? i : 0], side);
    }
}

void HapticSceneBuilder::add_box(const Aabb& box_m, std::span<const SurfaceLabel> labels) {
    add_obstacle(ObstacleKind::Box, scene_.boxes.size(), 6, labels, box_m);
    scene_.boxes.push_back(box_m);
}

void HapticSceneBuilder::add_sphere(const SphereShape& sphere, const SurfaceLabel& label) {
    add_obstacle(ObstacleKind::Sphere, scene_.spheres.size(), 1, std::span(&label, 1), grown(bounds_of(sphere)));
    scene_.spheres.push_back(sphere);
}

void HapticSceneBuilder::add_capsule(const CapsuleShape& capsule, const SurfaceLabel& label) {
    add_obstacle(ObstacleKind::Capsule, scene_.capsules.size(), 1, std::span(&label, 1), grown(bounds_of(capsule)));
    scene_.capsules.push_back(capsule);
}

void HapticSceneBuilder::add_cylinder(const CylinderShape& cylinder, std::span<const SurfaceLabel> labels) {
    add_obstacle(ObstacleKind::Cylinder, scene_.cylinders.size(), 3, labels, grown(bounds_of(cylinder)));
    scene_.cylinders.push_back(cylinder);
}

void HapticSceneBuilder::add_cone(const ConeShape& cone, std::span<const SurfaceLabel> labels) {
    add_obstacle(ObstacleKind::Cone, scene_.cones.size(), 2, labels, grown(bounds_of(cone)));
    scene_.cones.push_back(cone);
}

bool is_sound(const CustomObstacle& obstacle) {
    const Aabb& box = obstacle.bounds_m;
    const Vec3 size = box.size_m();
    if (!obstacle.closest || box.empty() || !is_finite(size) || !is_finite(obstacle.position_m) ||
        !(std::min({size.x, size.y, size.z}) > 0.0))
        return false;
    // Samples positions around the solid: a grid of 7 x 7 x 7 points without its inner ones, on two boxes of different
    // size.
    constexpr int kSteps = 6;
    const double slack = 1e-9 * glm::length(size);
    std::vector<ClosestPoint> found;
    for (const double wide : {1.2, 3.0})
        for (int i = 0; i < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++i) {
            const std::array<int, 3> step{i % (kSteps + 1), i / (kSteps + 1) % (kSteps + 1),
                                          i / ((kSteps + 1) * (kSteps + 1))};
            if (std::none_of(step.begin(), step.end(), [](int k) { return k == 0 || k == kSteps; })) continue;
            const Vec3 at =
                box.centre_m() + size * (Vec3(step[0], step[1], step[2]) / (0.5 * kSteps) - 1.0) * (0.5 * wide);
            const ClosestPoint one = obstacle.closest(at, obstacle.data.get());
            if (!is_finite(one.point_m) || !is_finite(one.normal) || !(std::abs(glm::length(one.normal) - 1.0) < 1e-9))
                return false;
            if (!(std::abs(glm::dot(one.normal, at - one.point_m) - one.distance_m) < slack) || !(one.distance_m > 0.0))
                return false;
            if (distance_squared(box, one.point_m) > slack * slack) return false;
            found.push_back(one);
        }
    return std::all_of(found.begin(), found.end(), [&](const ClosestPoint& plane) {
        return std::all_of(found.begin(), found.end(), [&](const ClosestPoint& other) {
            return glm::dot(plane.normal, other.point_m - plane.point_m) <= slack;
        });
    });
}

bool HapticSceneBuilder::add_custom(CustomObstacle obstacle, const SurfaceLabel& label) {
    if (!is_sound(obstacle)) return false;
    const Aabb bounds{obstacle.bounds_m.min_m + obstacle.position_m, obstacle.bounds_m.max_m + obstacle.position_m};
    add_obstacle(ObstacleKind::Custom, scene_.customs.size(), 1, std::span(&label, 1), grown(bounds));
    scene_.customs.push_back(std::move(obstacle));
    return true;
}

void HapticSceneBuilder::add_solid(std::span<const Plane> planes, const Aabb& bounds_m,
                                   std::span<const SurfaceLabel> labels, double rounding_m) {
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
            (side % 2 == 1 ? box.max_m : box.min_m)[side / 2] =
                side % 2 == 1 ? planes[face].offset_m : -planes[face].offset_m;
        }
        if (axis_aligned) {
            add_box(box, sides);
            scene_.obstacles.back().rounding = rounding(rounding_m);
            return;
        }
    }
    add_obstacle(ObstacleKind::Brush, scene_.planes.size(), planes.size(), labels, grown(bounds_m));
    scene_.obstacles.back().rounding = rounding(rounding_m);
    scene_.planes.insert(scene_.planes.end(), planes.begin(), planes.end());
}

// Returns the index of a rounding radius in roundings_m. A world has few different radii; once the table is full, the
// next smaller radius is used.
std::uint16_t HapticSceneBuilder::rounding(double rounding_m) {
    if (!(rounding_m > 0.0)) return 0;
    std::vector<double>& known = scene_.roundings_m;
    const auto at = std::find(known.begin(), known.end(), rounding_m);
    if (at != known.end()) return static_cast<std::uint16_t>(at - known.begin());
    if (known.size() <= 0xFFFF) {
        known.push_back(rounding_m);
        return static_cast<std::uint16_t>(known.size() - 1);
    }
    std::size_t best = 0;
    for (std::size_t i = 0; i < known.size(); ++i)
        if (known[i] < rounding_m && known[i] > known[best]) best = i;
    return static_cast<std::uint16_t>(best);
}

void HapticSceneBuilder::add_liquid(LiquidVolume liquid, const Aabb& bounds_m) {
    scene_.liquids.push_back(std::move(liquid));
    liquid_bounds_.push_back(grown(bounds_m));
}

void HapticSceneBuilder::set_reliefs(std::vector<Relief> reliefs, std::vector<std::uint8_t> mesh_axis) {
    scene_.reliefs = std::move(reliefs);
    scene_.relief_axis = std::move(mesh_axis);
}

bool HapticSceneBuilder::add_body(FeatureId feature, std::shared_ptr<const HapticScene> shape, const Placement& start,
                                  bool present) {
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

std::optional<std::pair<std::uint32_t, Placement>> HapticSceneBuilder::body_of(FeatureId feature) const {
    for (std::uint32_t i = 0; i < scene_.bodies.size(); ++i)
        if (scene_.bodies[i].feature == feature) return std::pair(i, scene_.bodies[i].start);
    return std::nullopt;
}

bool HapticSceneBuilder::add_soft(SoftPatch patch) {
    if (!is_sound(patch) || scene_.soft_patches.size() == kMostSoftPatches) return false;
    scene_.soft_patches.push_back(std::move(patch));
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

// Precomputes what each tick needs to know about the effects, such as overlaps. Needs the final bounds.
void HapticSceneBuilder::prepare_effects() {
    // An effect attached to a body has no bounds here, because the body may go anywhere.
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
        liquid.crowd_stiffness_n_per_m = (liquid.viscosity_ns_per_m > 0.0 ? kDragStiffness_n_per_m : 0.0) +
                                         kFilmStiffness_per_m * liquid.film_n +
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
                // Overlapping liquids share their weight, so the stiffnesses of their drag do not add up.
                liquid_stiffness = std::max(liquid_stiffness, liquid_own[k]);
                scene_.liquids[k].crowd_stiffness_n_per_m += effect.stiffness_n_per_m;
            }
        effect.crowd_stiffness_n_per_m += liquid_stiffness;
        const Aabb& box = effect_bounds_[i];
        effect.by_obstacle = box.empty() || !scene_.bodies.empty();
        if (!effect.by_obstacle)
            scene_.obstacle_bvh.within(
                box.centre_m(), 0.5 * glm::length(box.size_m()), [&](std::uint32_t item, double&) {
                    effect.by_obstacle = effect.by_obstacle || overlap(box, obstacle_bounds_[item]);
                });
    }
}

// Chooses the scene's origin: a rounded position near the middle if coordinates would otherwise be large, else zero.
void HapticSceneBuilder::choose_origin() {
    Aabb all;
    for (const std::vector<Aabb>* boxes : {&obstacle_bounds_, &liquid_bounds_, &effect_bounds_})
        for (const Aabb& box : *boxes) all.include(box);
    for (const SoftPatch& patch : scene_.soft_patches) all.include(patch.corner_m);
    const auto far_from_zero = [](const Vec3& p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kNearZero_m;
    };
    if (!all.empty() && (far_from_zero(all.min_m) || far_from_zero(all.max_m)))
        scene_.origin_m = glm::round(all.centre_m());
}

// Converts the corners of polygons to coordinates relative to the origin. Also computes the normals and edges that the
// solver needs.
void HapticSceneBuilder::make_polygons() {
    std::vector<PolygonCorner> corners;
    std::vector<Vec3> points;
    for (PolygonRange& range : scene_.polygons) {
        points.clear();
        for (std::uint32_t i = 0; i < range.corners; ++i)
            points.push_back(scene_.polygon_corners[range.first_corner + i].at_m - scene_.origin_m);
        range.first_corner = static_cast<std::uint32_t>(corners.size());
        range.normal = make_polygon(points, corners);
        range.corners = static_cast<std::uint32_t>(corners.size()) - range.first_corner;
    }
    scene_.polygon_corners = std::move(corners);
}

// Makes surfaces without area touchable from both sides, because they have no front.
void HapticSceneBuilder::settle_sides() {
    for (Obstacle& o : scene_.obstacles) {
        if (o.side == TouchSide::Both) continue;
        const bool no_area = o.kind == ObstacleKind::Triangle ? scene_.triangle(o).degenerate
                                                              : scene_.polygons[o.shape].normal == Vec3(0.0);
        if (no_area) o.side = TouchSide::Both;
        else scene_.one_sided_sheets = true;
    }
}

// Converts shapes, volumes and bounds to coordinates relative to the origin. The points of meshes and polygons have
// been converted already.
void HapticSceneBuilder::move_to_origin() {
    const Vec3 origin = scene_.origin_m;
    for (SphereShape& sphere : scene_.spheres) sphere.centre_m -= origin;
    for (CapsuleShape& capsule : scene_.capsules) capsule.start_m -= origin;
    for (CylinderShape& cylinder : scene_.cylinders) cylinder.bottom_m -= origin;
    for (ConeShape& cone : scene_.cones) cone.base_m -= origin;
    for (CustomObstacle& custom : scene_.customs) custom.position_m -= origin;
    for (Relief& relief : scene_.reliefs) {
        relief.low_m -= origin;
        relief.high_m -= origin;
    }
    for (SoftPatch& patch : scene_.soft_patches) {
        patch.corner_m -= origin;
        for (Vec3& corner : patch.outline_m) corner -= origin;
    }
    for (EffectVolume& effect : scene_.effects)
        if (effect.body == EffectVolume::kNoBody) move_effect(effect, -origin);
    const auto shift_plane = [&origin](Plane& plane) { plane.offset_m -= glm::dot(plane.normal, origin); };
    for (Plane& plane : scene_.planes) shift_plane(plane);
    for (LiquidVolume& liquid : scene_.liquids)
        for (Plane& plane : liquid.planes) shift_plane(plane);
    for (std::vector<Aabb>* boxes : {&scene_.boxes, &obstacle_bounds_, &liquid_bounds_, &effect_bounds_})
        for (Aabb& box : *boxes) {
            box.min_m -= origin;
            box.max_m -= origin;
        }
}

std::shared_ptr<const HapticScene> HapticSceneBuilder::build(std::uint32_t world) {
    // Source of the generation numbers, which are unique in the process. Scenes share nothing else.
    static std::atomic<std::uint32_t> next_generation{1};
    choose_origin();
    for (Vec3& p : scene_.mesh.points_m) p -= scene_.origin_m;
    make_polygons();
    settle_sides();
    move_to_origin();
    if (shades_ && !scene_.mesh.triangles.empty()) {
        scene_.shading = shade_mesh(scene_.mesh.points_m, scene_.mesh.triangles);
        if (scene_.shading.highest_m <= 0.0) scene_.shading = {};  // no facet of this mesh is part of a curve
    }
    scene_.fields = !scene_.reliefs.empty() || !scene_.shading.facets.empty();
    for (const HapticBody& body : scene_.bodies) scene_.fields = scene_.fields || body.shape->fields;
    scene_.obstacle_bvh = Bvh(obstacle_bounds_);
    scene_.liquid_bvh = Bvh(liquid_bounds_);
    scene_.effect_bvh = Bvh(effect_bounds_);
    prepare_effects();
    lay_grids(scene_.soft_patches);
    scene_.media = !scene_.liquids.empty() || !scene_.effects.empty() || !scene_.soft_patches.empty();
    const bool plain = !scene_.one_sided_sheets && !scene_.fields && scene_.effects.empty() &&
                       scene_.soft_patches.empty() && !scene_.liquid_surfaces;
    scene_.plain = plain && scene_.bodies.empty();
    scene_.plain_afar = plain && !scene_.bodies.empty();
    scene_.generation = next_generation.fetch_add(1);
    scene_.world = world != 0 ? world : scene_.generation;
    return std::make_shared<const HapticScene>(std::move(scene_));
}

}  // namespace handrail::render
