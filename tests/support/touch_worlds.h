// Defines small worlds that are hard to touch, with a path of the hand through each. All parts of the touch renderer
// are judged by these cases. The renderer and the brute-force judge get the same world, which tests may rotate and
// shift.
#pragma once

#include <functional>
#include <glm/mat3x3.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "tests/support/brute_force.h"
#include "tests/support/names.h"

namespace handrail::test {

// A rotation about the origin, then a translation.
struct Motion {
    glm::dmat3 turn{1.0};
    Vec3 shift_m{0.0};
    Vec3 operator()(const Vec3& p) const { return turn * p + shift_m; }
    Vec3 back(const Vec3& p) const { return glm::transpose(turn) * (p - shift_m); }
};
// Returns a number in [0, 1) that is the same with every standard library.
inline double unit(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }
Motion random_turn(std::mt19937& random);

class TouchWorld {
public:
    void triangle(const Vec3& a, const Vec3& b, const Vec3& c, FeatureId feature = kNoFeature);
    void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
    void box_of_triangles(const Vec3& low, const Vec3& high);
    void box(const Vec3& low, const Vec3& high, FeatureId feature = kNoFeature);
    // Adds the same shape as box(), but with a seventh plane that touches one corner, so that it stays a brush.
    void brush_box(const Vec3& low, const Vec3& high);
    // Adds a bounded solid, given by its planes, and by points whose convex hull contains it.
    void solid(const std::vector<Plane>& planes, const std::vector<Vec3>& corners, FeatureId feature = kNoFeature);
    // Adds a cube with half size `half_size`, cut by `cuts` random planes.
    void random_brush(std::mt19937& random, const Vec3& centre, double half_size, int cuts);
    // Add sheets that can be touched from this side, and round solids. A cylinder, cone or capsule is given by the
    // centres of both ends.
    void polygon(const std::vector<Vec3>& corners, TouchSide side = TouchSide::Both, FeatureId feature = kNoFeature);
    void sided_triangle(const Vec3& a, const Vec3& b, const Vec3& c, TouchSide side);
    void sphere(const Vec3& centre, double radius, FeatureId feature = kNoFeature);
    void capsule(const Vec3& start, const Vec3& end, double radius, FeatureId feature = kNoFeature);
    void cylinder(const Vec3& bottom, const Vec3& top, double radius, FeatureId feature = kNoFeature);
    void cone(const Vec3& base, const Vec3& apex, double radius, FeatureId feature = kNoFeature);
    // Adds things of all kinds in turn, with random position, direction and size up to `size`.
    void random_things(std::mt19937& random, int count, double spread, double size);
    void random_triangles(std::mt19937& random, int count, double spread, double edge);

    std::shared_ptr<const HapticScene> scene(const Motion& motion = {}) const;
    BruteForce judge(const Motion& motion = {}) const;
    TouchWorld shuffled_and_doubled(std::mt19937& random) const;
    TouchWorld with_triangles_split(std::mt19937& random) const;

private:
    struct Shape {
        ObstacleKind kind = ObstacleKind::Brush;  // kind; a box is a brush here until the builder recognises it
        std::vector<Vec3> points;                 // corners; or the centre of a sphere; or the centres of both ends
        std::vector<Plane> planes;
        FeatureId feature;
        double radius = 0.0;
        TouchSide side = TouchSide::Both;
    };
    static Shape moved(const Shape& shape, const Motion& motion);
    std::vector<Shape> shapes_;
};

// Returns goals at 1 kHz along the way-points.
std::vector<Vec3> hand_path(const std::vector<Vec3>& path_points_m, double speed_m_per_s);

struct TouchCase {
    std::string name;
    TouchWorld world;
    std::vector<Vec3> goals_m;
    double radius_m = 0.005;
    bool concave = false;  // free space is locally convex along the path, so a step of the hand is not amplified
    bool tidy = true;      // the answer is unique and continuous, which excludes soups, raw slivers and spikes
};
std::vector<TouchCase> hard_cases(double radius_m = 0.005);

}  // namespace handrail::test
