// Makes a horizontal section of a building, seen from above, as plain values in world metres. The window, the report
// and the exports draw it. Pure functions; any thread may call them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::plan {

// Height of the section above the feet. It is the height of a hand, and at this height the section cuts walls and
// doors.
inline constexpr double kPlanCutAboveFeet_m = 1.0;
// A solid whose top is between this height and the cut is drawn as low.
inline constexpr double kPlanLowAboveFeet_m = 0.1;

// Floors and pools down to this far below the feet are shown on the storey's plan.
inline constexpr double kPlanDeep_m = 1.0;

// The kinds in drawing order: a thing that is in or above another one is drawn after it.
enum class PlanKind { Floor, Low, Wall, Object, Liquid, Door, Mover };

// A convex outline with at least 3 corners, counter-clockwise seen from above.
using PlanOutline = std::vector<Vec2>;

struct PlanShape {
    PlanKind kind = PlanKind::Wall;
    PlanOutline outline_m;
};

struct PlanCut {
    double feet_height_m = 0.0;
    std::vector<PlanShape> shapes;              // sections of solids, sorted by kind
    std::vector<std::array<Vec2, 2>> sheets_m;  // sections of mesh triangles at the same height
};

// Returns where the object with that index in Scene::placed is now; empty if it must not be drawn.
using SeenAt = std::function<std::optional<Placement>(std::size_t thing)>;

// Makes the section, in about 1 ms for 1,000 solids. If seen_at is empty, all objects are where the scene has them.
PlanCut cut_plan(const Scene& scene, double feet_height_m, const SeenAt& seen_at = {});
// Makes the section of the placed objects only, sorted by kind.
std::vector<PlanShape> cut_things(const Scene& scene, double feet_height_m, const SeenAt& seen_at);

// Returns the section of a convex solid at a height, seen from above. Empty if the solid does not reach that height.
std::vector<Vec2> section_at(const ConvexSolid& solid, double height_m);

// Returns the smallest convex outline around points. Empty if the points are on one line. Source: A. M. Andrew, Another
// efficient algorithm for convex hulls in two dimensions, 1979.
PlanOutline convex_hull(std::vector<Vec2> points);

// Returns the cross product of two vectors. It is positive if b is counter-clockwise of a.
inline double cross_of(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

}  // namespace handrail::plan
