#include "app/window/plan.h"

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail {
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

// Convex hull, counter-clockwise: A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979.
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

// Where the polygon's border crosses a height.
void append_crossings(const std::vector<Vec3>& points, double height_m, std::vector<Vec2>& out) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& a = points[i];
        const Vec3& b = points[(i + 1) % points.size()];
        if ((a.z > height_m) == (b.z > height_m)) continue;
        const double t = (height_m - a.z) / (b.z - a.z);
        out.emplace_back(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
    }
}

// Its faces alone, where the thing stands: what a section asks for.
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

std::vector<Vec2> section_at(const ConvexSolid& solid, double height_m) {
    std::vector<Vec2> points;
    for (const Polygon& face : solid.faces) append_crossings(face.points_m, height_m, points);
    return convex_hull(std::move(points));
}

PlanCut cut_plan(const Scene& scene, double feet_height_m) {
    PlanCut cut{feet_height_m, {}, {}};
    const double cut_m = feet_height_m + kPlanCutAboveFeet_m;
    const double deepest_m = feet_height_m - kPlanDeep_m;
    const double low_m = feet_height_m + kPlanLowAboveFeet_m;
    const auto add = [&](PlanKind kind, const Solid& solid, double height_m) {
        PlanShape shape{kind, section_at(solid.shape, height_m)};
        if (!shape.outline_m.empty()) cut.shapes.push_back(std::move(shape));
    };
    const auto cut_solid = [&](const Solid& solid) {
        if (solid.role == SolidRole::BodyClip || solid.role == SolidRole::Trigger) return;
        const double bottom_m = solid.shape.bounds_m.min_m.z, top_m = solid.shape.bounds_m.max_m.z;
        if (bottom_m > cut_m || top_m <= deepest_m) return;
        const double below_top_m = 0.5 * (std::max(bottom_m, deepest_m) + top_m);
        if (top_m > cut_m) add(kind_of(scene, solid), solid, cut_m);
        else if (solid.role == SolidRole::Liquid) add(PlanKind::Liquid, solid, below_top_m);
        else add(top_m > low_m ? PlanKind::Low : PlanKind::Floor, solid, below_top_m);
    };
    for (const Solid& solid : scene.solids) cut_solid(solid);
    // Doors, lifts and what is free to move, where they are.
    for (const PlacedModel& thing : scene.placed)
        for (const Solid& own : thing.model->solids) cut_solid(placed_solid(own, thing));
    std::stable_sort(cut.shapes.begin(), cut.shapes.end(),
                     [](const PlanShape& a, const PlanShape& b) { return a.kind < b.kind; });

    std::vector<Vec2> points;
    for (const MeshTriangle& triangle : scene.triangles) {
        points.clear();
        append_crossings({triangle.a_m, triangle.b_m, triangle.c_m}, cut_m, points);
        if (points.size() == 2) cut.sheets_m.push_back({points[0], points[1]});
    }
    return cut;
}

Vec2 PlanLayout::to_pixels(const Vec2& world_m) const {
    const Vec2 from_centre = world_m - centre_m;
    const Vec3 up = forward_of_heading(turn_rad), right = right_of_heading(turn_rad);
    const double x = from_centre.x * right.x + from_centre.y * right.y;
    const double y = from_centre.x * up.x + from_centre.y * up.y;
    const Vec2 middle = 0.5 * (box.min_px + box.max_px);
    return {middle.x + x * pixels_per_m, middle.y - y * pixels_per_m};
}

PlanLayout lay_out_plan(const Aabb& bounds_m, const Vec3& feet_m, double heading_rad, bool north_up,
                        const PixelBox& box) {
    PlanLayout layout;
    layout.box = box;
    layout.centre_m = Vec2(feet_m.x, feet_m.y);
    const Vec2 size_px = box.max_px - box.min_px;
    const Vec3 world = bounds_m.empty() ? Vec3(1.0) : glm::max(bounds_m.size_m(), Vec3(1e-3));
    const double whole = 0.94 * std::min(size_px.x / world.x, size_px.y / world.y);
    layout.pixels_per_m = std::clamp(whole, kPlanFinest_px_per_m, kPlanClosest_px_per_m);
    if (!north_up) {
        layout.turn_rad = heading_rad;
        return layout;
    }
    if (bounds_m.empty()) return layout;
    const Vec2 half_m = 0.5 * size_px / layout.pixels_per_m;
    for (const int axis : {0, 1}) {
        const double from = bounds_m.min_m[axis] + half_m[axis], to = bounds_m.max_m[axis] - half_m[axis];
        layout.centre_m[axis] = from < to ? std::clamp(layout.centre_m[axis], from, to) : bounds_m.centre_m()[axis];
    }
    return layout;
}

ScaleBar scale_bar(double pixels_per_m, double widest_px) {
    contract_pre(pixels_per_m > 0.0);
    const double widest_m = widest_px / pixels_per_m;
    const double decade = std::pow(10.0, std::floor(std::log10(widest_m)));
    const double digit = widest_m / decade;
    ScaleBar bar;
    bar.length_m = decade * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
    if (bar.length_m >= 0.999) {
        const long metres = std::lround(bar.length_m);
        bar.words = phrase("window.metres", {{"length", metres}});
    } else {
        const long centimetres = std::lround(100.0 * bar.length_m);
        bar.words = phrase("window.centimetres", {{"length", centimetres}});
    }
    return bar;
}

}  // namespace handrail
