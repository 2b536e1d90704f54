#include "tests/support/touch_worlds.h"
#include "tests/support/names.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace handrail::test {
namespace {

std::vector<Vec3> corners_of(const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    return corners;
}

std::vector<Plane> planes_of(const Vec3& low, const Vec3& high) {
    return {{{1, 0, 0}, high.x},  {{-1, 0, 0}, -low.x}, {{0, 1, 0}, high.y},
            {{0, -1, 0}, -low.y}, {{0, 0, 1}, high.z},  {{0, 0, -1}, -low.z}};
}

double between(std::mt19937& random, double low, double high) { return low + (high - low) * unit(random); }
Vec3 in_cube(std::mt19937& random, double half) {
    const double x = between(random, -half, half), y = between(random, -half, half), z = between(random, -half, half);
    return {x, y, z};
}
Vec3 direction(std::mt19937& random) {
    for (;;) {
        const Vec3 v = in_cube(random, 1.0);
        const double length = glm::length(v);
        if (length > 0.1 && length <= 1.0) return v / length;
    }
}

}  // namespace

Motion random_turn(std::mt19937& random) {
    const Vec3 x = direction(random);
    Vec3 y = direction(random);
    while (std::abs(glm::dot(x, y)) > 0.9) y = direction(random);
    y = glm::normalize(y - x * glm::dot(x, y));
    return {glm::dmat3(x, y, glm::cross(x, y)), Vec3(0.0)};
}

void TouchWorld::triangle(const Vec3& a, const Vec3& b, const Vec3& c, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Triangle, {a, b, c}, {}, feature});
}

void TouchWorld::sided_triangle(const Vec3& a, const Vec3& b, const Vec3& c, TouchSide side) {
    shapes_.push_back({ObstacleKind::Triangle, {a, b, c}, {}, kNoFeature, 0.0, side});
}

void TouchWorld::polygon(const std::vector<Vec3>& corners, TouchSide side, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Polygon, corners, {}, feature, 0.0, side});
}

void TouchWorld::sphere(const Vec3& centre, double radius, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Sphere, {centre}, {}, feature, radius});
}

void TouchWorld::capsule(const Vec3& start, const Vec3& end, double radius, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Capsule, {start, end}, {}, feature, radius});
}

void TouchWorld::cylinder(const Vec3& bottom, const Vec3& top, double radius, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Cylinder, {bottom, top}, {}, feature, radius});
}

void TouchWorld::cone(const Vec3& base, const Vec3& apex, double radius, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Cone, {base, apex}, {}, feature, radius});
}

void TouchWorld::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

void TouchWorld::box_of_triangles(const Vec3& low, const Vec3& high) {
    const std::vector<Vec3> v = corners_of(low, high);
    constexpr std::size_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : kFaces) quad(v[f[0]], v[f[1]], v[f[2]], v[f[3]]);
}

void TouchWorld::box(const Vec3& low, const Vec3& high, FeatureId feature) {
    solid(planes_of(low, high), corners_of(low, high), feature);
}

void TouchWorld::brush_box(const Vec3& low, const Vec3& high) {
    std::vector<Plane> planes = planes_of(low, high);
    const Vec3 normal = glm::normalize(Vec3(1.0));
    planes.push_back({normal, glm::dot(normal, high)});
    solid(planes, corners_of(low, high));
}

void TouchWorld::solid(const std::vector<Plane>& planes, const std::vector<Vec3>& corners, FeatureId feature) {
    shapes_.push_back({ObstacleKind::Brush, corners, planes, feature});
}

void TouchWorld::random_brush(std::mt19937& random, const Vec3& centre, double half_size, int cuts) {
    std::vector<Plane> planes = planes_of(centre - Vec3(half_size), centre + Vec3(half_size));
    for (int i = 0; i < cuts; ++i) {
        const Vec3 normal = direction(random);
        planes.push_back({normal, glm::dot(normal, centre) + half_size * between(random, 0.3, 1.2)});
    }
    solid(planes, corners_of(centre - Vec3(half_size), centre + Vec3(half_size)));
}

void TouchWorld::random_triangles(std::mt19937& random, int count, double spread, double edge) {
    for (int i = 0; i < count; ++i) {
        const Vec3 a = in_cube(random, spread), b = a + in_cube(random, edge), c = a + in_cube(random, edge);
        triangle(a, b, c);
    }
}

void TouchWorld::random_things(std::mt19937& random, int count, double spread, double size) {
    for (int i = 0; i < count; ++i) {
        const Vec3 at = in_cube(random, spread);
        const double length = between(random, 0.1 * size, size);
        const Vec3 along = direction(random) * length;
        const double radius = between(random, 0.1 * size, 0.5 * size);
        switch (i % 7) {
            case 0:
                sphere(at, radius);
                break;
            case 1:
                capsule(at, at + along, radius);
                break;
            case 2:
                cylinder(at, at + along, radius);
                break;
            case 3:
                cone(at, at + along, radius);
                break;
            case 4: {
                const Vec3 u = any_perpendicular(along), v = glm::cross(glm::normalize(along), u);
                std::vector<Vec3> corners;
                const int n = 3 + static_cast<int>(random() % 5);
                for (int k = 0; k < n; ++k)
                    corners.push_back(at + u * (radius * std::cos(2 * kPi * k / n)) +
                                      v * (2 * radius * std::sin(2 * kPi * k / n)));
                polygon(corners);
                break;
            }
            case 5:
                random_brush(random, at, radius, 2);
                break;
            default:
                triangle(at, at + along, at + direction(random) * size);
        }
    }
}

TouchWorld::Shape TouchWorld::moved(const Shape& shape, const Motion& motion) {
    Shape out = shape;
    for (Vec3& p : out.points) p = motion(p);
    for (Plane& plane : out.planes) {
        plane.normal = motion.turn * plane.normal;
        plane.offset_m += glm::dot(plane.normal, motion.shift_m);
    }
    return out;
}

std::shared_ptr<const HapticScene> TouchWorld::scene(const Motion& motion) const {
    HapticSceneBuilder builder;
    for (const Shape& shape : shapes_) {
        const Shape s = moved(shape, motion);
        const SurfaceLabel label{s.feature};
        const Vec3 from = s.points[0], way = s.points.size() > 1 ? s.points[1] - from : Vec3(0.0);
        const double length = glm::length(way);
        const Vec3 axis = length > 0.0 ? way / length : Vec3(0, 0, 1);
        switch (s.kind) {
            case ObstacleKind::Triangle:
                builder.add_triangle(s.points[0], s.points[1], s.points[2], label, s.side);
                break;
            case ObstacleKind::Polygon:
                builder.add_polygon(s.points, label, s.side);
                break;
            case ObstacleKind::Sphere:
                builder.add_sphere({from, s.radius}, label);
                break;
            case ObstacleKind::Capsule:
                builder.add_capsule({from, axis, length, s.radius}, label);
                break;
            case ObstacleKind::Cylinder:
                builder.add_cylinder({from, axis, length, s.radius}, label);
                break;
            case ObstacleKind::Cone:
                builder.add_cone(make_cone(from, axis, length, s.radius), label);
                break;
            case ObstacleKind::Custom:
                break;  // the worlds with these kinds build them in their own code
            case ObstacleKind::Box:
            case ObstacleKind::Brush: {
                Aabb bounds;
                for (const Vec3& p : s.points) bounds.include(p);
                builder.add_solid(s.planes, bounds, label);
            }
        }
    }
    return builder.build();
}

BruteForce TouchWorld::judge(const Motion& motion) const {
    BruteForce judge;
    for (const Shape& shape : shapes_) {
        const Shape s = moved(shape, motion);
        const LVec a(s.points[0]), b(s.points.size() > 1 ? s.points[1] : s.points[0]);
        const auto radius = static_cast<long double>(s.radius);
        switch (s.kind) {
            case ObstacleKind::Triangle:
                judge.add_triangle(s.points[0], s.points[1], s.points[2]);
                break;
            case ObstacleKind::Polygon: {
                std::vector<LVec> corners(s.points.begin(), s.points.end());
                judge.add([corners](const LVec& p) { return nearest_on_polygon(corners, p); }, s.points, 0.0);
                break;
            }
            case ObstacleKind::Sphere:
            case ObstacleKind::Capsule:
                judge.add([a, b, radius](const LVec& p) { return nearest_on_capsule(a, b, radius, p); }, s.points,
                          s.radius);
                break;
            case ObstacleKind::Cylinder:
                judge.add([a, b, radius](const LVec& p) { return nearest_on_cylinder(a, b, radius, p); }, s.points,
                          s.radius);
                break;
            case ObstacleKind::Cone:
                judge.add([a, b, radius](const LVec& p) { return nearest_on_cone(a, b, radius, p); }, s.points,
                          s.radius);
                break;
            case ObstacleKind::Custom:
                break;
            case ObstacleKind::Box:
            case ObstacleKind::Brush:
                judge.add_solid(s.planes, s.points);
        }
    }
    return judge;
}

TouchWorld TouchWorld::shuffled_and_doubled(std::mt19937& random) const {
    TouchWorld out = *this;
    out.shapes_.insert(out.shapes_.end(), shapes_.begin(), shapes_.end());
    for (std::size_t i = out.shapes_.size(); i > 1; --i) std::swap(out.shapes_[i - 1], out.shapes_[random() % i]);
    for (Shape& s : out.shapes_)
        if (s.kind == ObstacleKind::Triangle)
            std::rotate(s.points.begin(), s.points.begin() + static_cast<std::ptrdiff_t>(random() % 3), s.points.end());
    return out;
}

TouchWorld TouchWorld::with_triangles_split(std::mt19937& random) const {
    TouchWorld out;
    for (const Shape& s : shapes_) {
        if (s.kind != ObstacleKind::Triangle) {
            out.shapes_.push_back(s);
            continue;
        }
        const double u = between(random, 0.2, 0.6), v = (1.0 - u) * between(random, 0.2, 0.6);
        const Vec3 m = s.points[0] * (1.0 - u - v) + s.points[1] * u + s.points[2] * v;
        out.triangle(s.points[0], s.points[1], m);
        out.triangle(s.points[1], s.points[2], m);
        out.triangle(s.points[2], s.points[0], m);
    }
    return out;
}

std::vector<Vec3> hand_path(const std::vector<Vec3>& path_points_m, double speed_m_per_s) {
    std::vector<Vec3> goals{path_points_m.front()};
    for (std::size_t i = 1; i < path_points_m.size(); ++i) {
        const Vec3 from = path_points_m[i - 1], to = path_points_m[i];
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / (speed_m_per_s * 1e-3))));
        for (int k = 1; k <= steps; ++k) goals.push_back(from + (to - from) * (static_cast<double>(k) / steps));
    }
    return goals;
}

std::vector<TouchCase> hard_cases(double radius_m) {
    std::vector<TouchCase> cases;
    constexpr double b = 0.1;
    const auto add = [&](const char* name, bool concave, bool tidy = true) -> TouchCase& {
        cases.push_back({name, {}, {}, radius_m, concave, tidy});
        return cases.back();
    };
    const std::vector<Vec3> over_plane{
        {-.04, .003, .02}, {-.04, .003, -.01}, {.04, .007, -.01}, {-.04, .003, -.01}, {-.04, .003, .02}};
    const std::vector<Vec3> into_corner{{-.02, 0, .02},     {-.02, 0, -.008}, {.025, .001, -.008}, {.025, .03, -.008},
                                        {-.02, .03, -.008}, {-.02, 0, -.008}, {-.02, 0, .02}};
    {
        TouchCase& c = add("T1 plane with T-junctions", true);
        c.world.triangle({-b, -b, 0}, {0, -b, 0}, {0, b, 0});
        c.world.triangle({-b, -b, 0}, {0, b, 0}, {-b, b, 0});
        for (int i = 0; i < 4; ++i) {
            const double y0 = -b + i * b / 2, y1 = y0 + b / 2;
            c.world.quad({0, y0, 0}, {b, y0, 0}, {b, y1, 0}, {0, y1, 0});
        }
        c.goals_m = hand_path(over_plane, 0.2);
    }
    for (const auto& [name, w] : {std::pair{"T2a crack 0.01 mm", 1e-5},
                                  {"T2b crack 0.1 mm", 1e-4},
                                  {"T2c crack 0.5 mm", 5e-4},
                                  {"T2d crack 1 mm", 1e-3}}) {
        TouchCase& c = add(name, false);
        c.world.quad({-b, -b, 0}, {-w / 2, -b, 0}, {-w / 2, b, 0}, {-b, b, 0});
        c.world.quad({w / 2, -b, 0}, {b, -b, 0}, {b, b, 0}, {w / 2, b, 0});
        c.goals_m = hand_path(
            {{-.03, .003, .02}, {-.03, .003, -.01}, {.03, .005, -.01}, {-.03, .003, -.01}, {-.03, .003, .02}}, 0.2);
    }
    const auto three_boxes = [&](const char* name, void (TouchWorld::*put)(const Vec3&, const Vec3&), bool third) {
        TouchCase& c = add(name, third);
        (c.world.*put)({-.05, -.05, -.1}, {.05, .05, 0});
        (c.world.*put)({.01, -.06, -.05}, {.06, .06, .05});
        if (third) (c.world.*put)({-.06, .02, -.05}, {.06, .06, .05});
        c.goals_m = hand_path(third ? into_corner
                                    : std::vector<Vec3>{{-.02, 0, .02},
                                                        {-.02, 0, -.008},
                                                        {.025, .001, -.008},
                                                        {.025, .03, -.008},
                                                        {.025, .03, .06},
                                                        {-.02, .03, .06},
                                                        {-.02, 0, .02}},
                              0.2);
    };
    three_boxes("T3 two overlapping boxes of triangles", &TouchWorld::box_of_triangles, false);
    three_boxes("T4a three boxes of triangles", &TouchWorld::box_of_triangles, true);
    three_boxes("T4c three boxes as brushes", &TouchWorld::brush_box, true);
    {
        TouchCase& c = add("T4b three boxes as boxes", true);
        c.world.box({-.05, -.05, -.1}, {.05, .05, 0});
        c.world.box({.01, -.06, -.05}, {.06, .06, .05});
        c.world.box({-.06, .02, -.05}, {.06, .06, .05});
        c.goals_m = hand_path(into_corner, 0.2);
    }
    for (const auto& [name, degrees] : {std::pair{"T5a crevice 10 degrees", 10.0},
                                        {"T5b crevice 2 degrees", 2.0},
                                        {"T5c crevice 0.5 degrees", 0.5}}) {
        TouchCase& c = add(name, true);
        const double half = radians_from_degrees(degrees) / 2, d = 0.3, x = std::tan(half) * d;
        c.world.quad({0, -b, 0}, {-x, -b, d}, {-x, b, d}, {0, b, 0});
        c.world.quad({0, -b, 0}, {x, -b, d}, {x, b, d}, {0, b, 0});
        c.radius_m = std::min(radius_m, 0.45 * d * std::sin(half));
        const double z = c.radius_m / std::sin(half) + .02;
        c.goals_m =
            hand_path({{0, 0, z}, {.0005, 0, z - .06}, {-.004, .01, z - .06}, {.004, .005, z - .05}, {0, 0, z}}, 0.2);
    }
    const std::vector<Vec3> over_edge{{.03, 0, .02},      {.03, 0, -.003},   {.06, .001, -.003},
                                      {.047, .001, -.02}, {.06, .001, -.02}, {.03, 0, .02}};
    {
        TouchCase& c = add("T6 box edge, triangles", false);
        c.world.box_of_triangles({-.05, -.05, -.1}, {.05, .05, 0});
        c.goals_m = hand_path(over_edge, 0.2);
        TouchCase& solid = add("T6 box edge, solid", false);
        solid.world.box({-.05, -.05, -.1}, {.05, .05, 0});
        solid.goals_m = cases[cases.size() - 2].goals_m;
    }
    {
        TouchCase& c = add("T7 spike", false, false);
        const double q = .1 * std::tan(radians_from_degrees(15.0));
        const Vec3 v[4] = {{-q, -q, -.1}, {q, -q, -.1}, {q, q, -.1}, {-q, q, -.1}};
        for (int i = 0; i < 4; ++i) c.world.triangle({0, 0, 0}, v[i], v[(i + 1) % 4]);
        c.goals_m = hand_path({{.001, .0004, .02},
                               {.0005, .0004, .002},
                               {-.0005, .0004, .002},
                               {.003, .0004, -.001},
                               {.02, .001, -.02},
                               {.003, .0004, -.02},
                               {.02, .001, -.02},
                               {.02, .001, .02},
                               {.001, .0004, .02}},
                              0.1);
    }
    {
        TouchCase& c = add("T8 duplicates and overlaps", true);
        for (int k = 0; k < 4; ++k) c.world.quad({-b, -b, 0}, {b, -b, 0}, {b, b, 0}, {-b, b, 0});
        c.world.quad({-.02, -b, 0}, {.03, -b, 0}, {.03, b, 0}, {-.02, b, 0});
        for (int k = 0; k < 3; ++k) c.world.quad({.02, -b, 0}, {.02, b, 0}, {.02, b, b}, {.02, -b, b});
        c.goals_m = hand_path(over_plane, 0.2);
    }
    for (const auto& [name, aspect] :
         {std::pair{"T9a slivers 1e3", 1e3}, {"T9b slivers 1e5", 1e5}, {"T9c slivers 1e7", 1e7}}) {
        TouchCase& c = add(name, false, false);
        const double h = 0.2 / aspect;
        constexpr int kStrips = 24;
        double y = -kStrips * h / 2;
        for (int i = 0; i < kStrips; ++i, y += h) c.world.quad({-b, y, 0}, {b, y, 0}, {b, y + h, 0}, {-b, y + h, 0});
        c.world.quad({-b, -b, 0}, {b, -b, 0}, {b, -kStrips * h / 2, 0}, {-b, -kStrips * h / 2, 0});
        c.world.quad({-b, kStrips * h / 2, 0}, {b, kStrips * h / 2, 0}, {b, b, 0}, {-b, b, 0});
        c.goals_m = hand_path({{-.04, -.02, .02},
                               {-.04, -.02, -.01},
                               {.04, .02, -.01},
                               {.0, -.002, -.01},
                               {.0, .002, -.01},
                               {-.04, -.02, .02}},
                              0.1);
    }
    {
        TouchCase& c = add("T10 triangles of no area", true);
        c.world.quad({-b, -b, 0}, {b, -b, 0}, {b, b, 0}, {-b, b, 0});
        c.world.triangle({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
        c.world.triangle({-.05, .001, 0}, {.05, .001, 0}, {0, .001, 0});
        c.world.triangle({.01, 0, 0}, {.01, 0, 0}, {.01, .01, 0});
        c.world.triangle({-.01, -b, 0}, {-.01, b, 0}, {-.01, .02, 1e-12});
        c.goals_m = hand_path(over_plane, 0.2);
    }
    const std::vector<Vec3> through{{-.05, 0, 0}, {.05, .001, .001}, {.05, .03, .03}, {-.05, 0, 0}};
    for (const auto& [name, speed] : {std::pair{"T11a thin wall at 2 m/s", 2.0}, {"T11b thin wall at 5 m/s", 5.0}}) {
        TouchCase& c = add(name, true);
        c.world.box({-5e-5, -b, -b}, {5e-5, b, b});
        c.goals_m = hand_path(through, speed);
    }
    {
        TouchCase& c = add("T12 two-sided sheet at 5 m/s", true);
        c.world.quad({0, -b, -b}, {0, b, -b}, {0, b, b}, {0, -b, b});
        c.goals_m = hand_path(through, 5.0);
    }
    for (const auto& [name, keep] : {std::pair{"T13a stalls of 10 ms", 10}, {"T13b stalls of 50 ms", 50}}) {
        TouchCase& c = add(name, false);
        c.world.box({-.05, -.05, -.1}, {.05, .05, 0});
        c.world.box({.01, -.06, -.05}, {.06, .06, .05});
        const std::vector<Vec3> all = hand_path(
            {{-.02, 0, .02}, {-.02, 0, -.04}, {.04, .01, -.04}, {.04, .03, -.04}, {.1, .03, -.04}, {-.02, 0, .02}},
            2.0);
        for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(keep)) c.goals_m.push_back(all[i]);
    }
    {
        TouchCase& c = add("T14 noise and quantum in a corner", true);
        c.world.box({-.05, -.05, -.1}, {.05, .05, 0});
        c.world.box({.01, -.06, -.05}, {.06, .06, .05});
        c.goals_m = hand_path({{-.02, 0, .02},
                               {-.02, 0, -.008},
                               {.025, .001, -.008},
                               {.025, .03, -.008},
                               {-.02, .03, -.008},
                               {-.02, 0, .02}},
                              0.1);
        std::mt19937 random(1);
        constexpr double kQuantum = 6e-5;
        for (Vec3& g : c.goals_m) {
            // The sum of four uniform numbers approximates normal noise of 20 um well enough.
            Vec3 noise(0.0);
            for (int i = 0; i < 4; ++i) noise += in_cube(random, 1.7e-5);
            g = glm::round((g + noise) / kQuantum) * kQuantum;
        }
    }
    {
        TouchCase& c = add("T15 sphere, capsule and cylinder on a slab", false);
        c.world.sphere({0, 0, -.03}, .03);
        c.world.capsule({.03, -.05, -.02}, {.03, .05, -.02}, .01);
        c.world.cylinder({-.03, 0, -.05}, {-.03, 0, .01}, .01);
        c.world.box({-.1, -.1, -.06}, {.1, .1, -.03});
        c.goals_m = hand_path({{.06, .001, .02},
                               {.06, .001, -.04},
                               {.02, .001, -.02},
                               {-.02, .004, -.01},
                               {-.05, .002, -.03},
                               {-.05, .002, .03},
                               {.06, .001, .02}},
                              0.1);
    }
    {
        TouchCase& c = add("T15b heap of every kind", false, false);
        std::mt19937 random(15);
        c.world.random_things(random, 35, .04, .03);
        std::vector<Vec3> way{{0, 0, .1}};
        for (int i = 0; i < 25; ++i) way.push_back(in_cube(random, .06));
        way.emplace_back(0, 0, .1);
        c.goals_m = hand_path(way, 0.5);
    }
    for (const auto& [name, count, radius] : {std::tuple{"T16a soup of 120", 120, 0.002},
                                              {"T16b soup of 30", 30, 0.005},
                                              {"T16c soup of 400, point", 400, 1e-5}}) {
        TouchCase& c = add(name, false, false);
        std::mt19937 random(7);
        c.world.random_triangles(random, count, .03, .015);
        std::vector<Vec3> way{{0, 0, .06}};
        for (int i = 0; i < 30; ++i) way.push_back(in_cube(random, .05));
        way.emplace_back(0, 0, .06);
        c.radius_m = radius;
        c.goals_m = hand_path(way, 0.5);
    }
    {
        TouchCase& c = add("T16d heap of random brushes", false, false);
        std::mt19937 random(11);
        for (int i = 0; i < 25; ++i) {
            const double half_size = between(random, .005, .02);
            c.world.random_brush(random, in_cube(random, .04), half_size, 4);
        }
        std::vector<Vec3> way{{0, 0, .09}};
        for (int i = 0; i < 30; ++i) way.push_back(in_cube(random, .06));
        way.emplace_back(0, 0, .09);
        c.goals_m = hand_path(way, 0.5);
    }
    return cases;
}

}  // namespace handrail::test
