// A building cut level, seen from above, as plain values: what window, report and exports draw. Pure functions; any
// thread. World metres.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

inline constexpr double kPlanCutAboveFeet_m = 1.0;  // where a hand is; walls and doors are cut here
inline constexpr double kPlanLowAboveFeet_m = 0.1;  // anything that reaches higher, but not to the cut, is shown as low

inline constexpr double kPlanDeep_m = 1.0;  // floors and pools this far below the feet belong to the storey

// In the order in which they are drawn: what stands in or over something comes after it.
enum class PlanKind { Floor, Low, Wall, Object, Liquid, Door, Mover };

// Convex, counter-clockwise seen from above, at least 3 corners.
using PlanOutline = std::vector<Vec2>;

struct PlanShape {
    PlanKind kind = PlanKind::Wall;
    PlanOutline outline_m;
};

struct PlanCut {
    double feet_height_m = 0.0;
    std::vector<PlanShape> shapes;              // by kind
    std::vector<std::array<Vec2, 2>> sheets_m;  // mesh triangles at the cut's height
};

// Where a thing of Scene::placed is seen; none: it is not.
using SeenAt = std::function<std::optional<Placement>(std::size_t thing)>;

// About 1 ms for 1,000 solids. seen_at: empty, and all things are where the scene has them.
PlanCut cut_plan(const Scene& scene, double feet_height_m, const SeenAt& seen_at = {});
// Of placed things alone, by kind.
std::vector<PlanShape> cut_things(const Scene& scene, double feet_height_m, const SeenAt& seen_at);

// The part of a convex solid at a height, seen from above; empty where the solid is not met.
std::vector<Vec2> section_at(const ConvexSolid& solid, double height_m);

// The smallest convex outline around points, by A. M. Andrew, Another efficient algorithm for convex hulls in two
// dimensions, 1979. Empty where they lie on one line.
PlanOutline convex_hull(std::vector<Vec2> points);

// Positive where b lies counter-clockwise of a.
inline double cross_of(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

}  // namespace handrail
