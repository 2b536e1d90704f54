// A horizontal section of a building, seen from above, as plain values. The window, the report and the exports draw it.
// Pure functions; any thread. World metres.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::plan {

inline constexpr double kPlanCutAboveFeet_m = 1.0;  // height of a hand; walls and doors are cut here
inline constexpr double kPlanLowAboveFeet_m = 0.1;  // a solid that ends above this but below the cut is drawn as low

inline constexpr double kPlanDeep_m = 1.0;  // floors and pools down to this far below the feet belong to the storey

// In drawing order: a thing in or above another one comes after it.
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
    std::vector<std::array<Vec2, 2>> sheets_m;  // mesh triangles, cut at the same height
};

// Returns where a thing of Scene::placed is now; empty if it must not be drawn.
using SeenAt = std::function<std::optional<Placement>(std::size_t thing)>;

// Takes about 1 ms for 1,000 solids. If seen_at is empty, all things are where the scene has them.
PlanCut cut_plan(const Scene& scene, double feet_height_m, const SeenAt& seen_at = {});
// Only the placed things, sorted by kind.
std::vector<PlanShape> cut_things(const Scene& scene, double feet_height_m, const SeenAt& seen_at);

// The section of a convex solid at a height, seen from above; empty if the solid does not reach that height.
std::vector<Vec2> section_at(const ConvexSolid& solid, double height_m);

// The smallest convex outline around points. Source: A. M. Andrew, Another efficient algorithm for convex hulls in two
// dimensions, 1979. Empty if the points are on one line.
PlanOutline convex_hull(std::vector<Vec2> points);

// Positive if b is counter-clockwise of a.
inline double cross_of(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

}  // namespace handrail::plan
