#include "worlds/plan/plan_cut.h"

#include <algorithm>

namespace handrail::plan {
namespace {

PlanKind kind_of(const Scene& scene, const Solid& solid) {
    if (solid.role == SolidRole::Liquid) return PlanKind::Liquid;
    const Feature* feature = scene.find(solid.feature);
    const FeatureKind kind = feature ? feature->kind : FeatureKind::Wall;
    if (kind == FeatureKind::Door) return PlanKind::Door;
    if (solid.role == SolidRole::Mover || kind == FeatureKind::Lift || kind == FeatureKind::Mover ||
        kind == FeatureKind::Button)
        return PlanKind::Mover;
    return kind == FeatureKind::Object ? PlanKind::Object : PlanKind::Wall;
}

// Appends the points where the polygon's border crosses a height.
void append_crossings(const std::vector<Vec3>& points, double height_m, std::vector<Vec2>& out) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& a = points[i];
        const Vec3& b = points[(i + 1) % points.size()];
        if ((a.z > height_m) == (b.z > height_m)) continue;
        const double t = (height_m - a.z) / (b.z - a.z);
        out.emplace_back(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
    }
}

// Returns only the placed faces of the solid, because a section needs nothing else.
Solid placed_solid(const Solid& own, const PlacedModel& thing) {
    const PlacedFrame frame(thing.at);
    Solid solid;
    solid.role = own.role;
    solid.feature = thing.feature;
    solid.shape.faces = own.shape.faces;
    for (Polygon& face : solid.shape.faces)
        for (Vec3& p : face.points_m) solid.shape.bounds_m.include(p = frame.to_world(p));
    return solid;
}

}  // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec2> hull;
    const auto left_turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 1e-9;
    };
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= start + 2 && !left_turn(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
            hull.push_back(p);
        }
        if (!hull.empty()) hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    if (hull.size() < 3) hull.clear();
    return hull;
}

std::vector<Vec2> section_at(const ConvexSolid& solid, double height_m) {
    std::vector<Vec2> points;
    for (const Polygon& face : solid.faces) append_crossings(face.points_m, height_m, points);
    return convex_hull(std::move(points));
}

namespace {

void add_solid(const Scene& scene, const Solid& solid, double feet_height_m, std::vector<PlanShape>& shapes) {
    if (solid.role == SolidRole::BodyClip || solid.role == SolidRole::Trigger) return;
    const double cut_m = feet_height_m + kPlanCutAboveFeet_m, deepest_m = feet_height_m - kPlanDeep_m,
                 low_m = feet_height_m + kPlanLowAboveFeet_m;
    const double bottom_m = solid.shape.bounds_m.min_m.z, top_m = solid.shape.bounds_m.max_m.z;
    if (bottom_m > cut_m || top_m <= deepest_m) return;
    const auto add = [&](PlanKind kind, double height_m) {
        PlanShape shape{kind, section_at(solid.shape, height_m)};
        if (!shape.outline_m.empty()) shapes.push_back(std::move(shape));
    };
    const double below_top_m = 0.5 * (std::max(bottom_m, deepest_m) + top_m);
    if (top_m > cut_m) add(kind_of(scene, solid), cut_m);
    else if (solid.role == SolidRole::Liquid) add(PlanKind::Liquid, below_top_m);
    else add(top_m > low_m ? PlanKind::Low : PlanKind::Floor, below_top_m);
}

// Adds doors, lifts and free bodies at their current positions.
void add_things(const Scene& scene, double feet_height_m, const SeenAt& seen_at, std::vector<PlanShape>& shapes) {
    for (std::size_t i = 0; i < scene.placed.size(); ++i) {
        const std::optional<Placement> at = seen_at ? seen_at(i) : scene.placed[i].at;
        if (!at) continue;
        PlacedModel thing = scene.placed[i];
        thing.at = *at;
        for (const Solid& own : thing.model->solids) add_solid(scene, placed_solid(own, thing), feet_height_m, shapes);
    }
}

void sort_by_kind(std::vector<PlanShape>& shapes) {
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const PlanShape& a, const PlanShape& b) { return a.kind < b.kind; });
}

}  // namespace

std::vector<PlanShape> cut_things(const Scene& scene, double feet_height_m, const SeenAt& seen_at) {
    std::vector<PlanShape> shapes;
    add_things(scene, feet_height_m, seen_at, shapes);
    sort_by_kind(shapes);
    return shapes;
}

PlanCut cut_plan(const Scene& scene, double feet_height_m, const SeenAt& seen_at) {
    PlanCut cut{feet_height_m, {}, {}};
    for (const Solid& solid : scene.solids) add_solid(scene, solid, feet_height_m, cut.shapes);
    add_things(scene, feet_height_m, seen_at, cut.shapes);
    sort_by_kind(cut.shapes);
    const double cut_m = feet_height_m + kPlanCutAboveFeet_m;
    std::vector<Vec2> points;
    for (const MeshTriangle& triangle : scene.triangles) {
        points.clear();
        append_crossings({triangle.a_m, triangle.b_m, triangle.c_m}, cut_m, points);
        if (points.size() == 2) cut.sheets_m.push_back({points[0], points[1]});
    }
    return cut;
}

}  // namespace handrail::plan
