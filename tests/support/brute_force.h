// Judges the touch renderer independently, in long double, without hierarchy, cache or projection routine. The judge is
// slow on purpose and finds the closest points
// - of solids by trying every face, pair and triple of planes;
// - of triangles by barycentric coordinates and three segments;
// - of polygons by the triangles of a fan;
// - of round solids by clamping, or in the plane through axis and point.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "tests/support/names.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail::test {

using LVec = glm::vec<3, long double>;

struct Nearest {
    LVec point{0.0L};
    long double distance = 0.0L;  // signed distance, negative inside a solid
};

Nearest nearest_on_segment(const LVec& a, const LVec& b, const LVec& p);
Nearest nearest_on_triangle(const LVec& a, const LVec& b, const LVec& c, const LVec& p);
// Returns the nearest point of a convex polygon, whose corners are in order.
Nearest nearest_on_polygon(const std::vector<LVec>& corners, const LVec& p);
// Return the nearest point of a round solid. `a` and `b` are the centres of both ends. A capsule's round ends extend
// beyond them; a cone has its base at a and its apex at b.
Nearest nearest_on_capsule(const LVec& a, const LVec& b, long double radius, const LVec& p);
Nearest nearest_on_cylinder(const LVec& a, const LVec& b, long double radius, const LVec& p);
Nearest nearest_on_cone(const LVec& a, const LVec& b, long double radius, const LVec& p);
// Returns the nearest point of a solid by trying every face, edge and corner. For a point inside, returns the nearest
// point of the nearest plane.
Nearest nearest_on_solid(const std::vector<Plane>& planes, const LVec& p);

// Finds the point nearest to `goal` that satisfies dot(n, x) >= b for each half-space, by trying every subset of at
// most three. Returns nothing if there is no such point.
struct LHalfSpace {
    LVec normal;
    long double offset;
};
std::optional<LVec> project_by_enumeration(const std::vector<LHalfSpace>& walls, const LVec& goal,
                                           long double tolerance = 1e-13L);

class BruteForce {
public:
    struct Thing {
        bool solid = false;
        LVec a{0.0L}, b{0.0L}, c{0.0L};  // corners of a triangle
        std::vector<Plane> planes;       // planes of a solid
        // If set, the thing has another shape, given by a function for its nearest point.
        std::function<Nearest(const LVec&)> other;
        LVec centre{0.0L};  // centre of a sphere around the thing, by which distant things are skipped
        long double reach = 0.0L;
    };
    void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c);
    void add_solid(const std::vector<Plane>& planes, const std::vector<Vec3>& corners);

    // Adds a thing of another shape, given by a function for its nearest point. The convex hull of `corners`, grown by
    // `more`, must contain the thing.
    void add(std::function<Nearest(const LVec&)> nearest, const std::vector<Vec3>& corners, double more);

    const std::vector<Thing>& things() const { return things_; }
    Nearest nearest(const Thing& thing, const LVec& p) const;
    // Returns the distance to the nearest thing, or `far` if no thing is nearer than that.
    long double distance(const Vec3& p, long double far = 1.0L) const;
    // Returns true if the segment is nowhere nearer than `clearance` to any thing. The function checks `samples` points
    // and takes account of their spacing.
    bool clear(const Vec3& from, const Vec3& to, long double clearance, int samples = 8) const;
    // Returns how far the first-order contact problem at c would still move the proxy towards the goal. It is 0 at a
    // true local optimum (KKT).
    long double residual(const Vec3& c, const Vec3& goal, long double radius) const;

private:
    std::vector<Thing> things_;
};

}  // namespace handrail::test
