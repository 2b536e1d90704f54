#include "app/window/plan.h"

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/building_bounds.h"

namespace handrail::window {

Vec2 PlanLayout::to_pixels(const Vec2& world_m) const {
    const Vec2 from_centre = world_m - centre_m;
    const Vec3 up = forward_of_heading(turn_rad), right = right_of_heading(turn_rad);
    const double x = from_centre.x * right.x + from_centre.y * right.y;
    const double y = from_centre.x * up.x + from_centre.y * up.y;
    const Vec2 middle = 0.5 * (box.min_px + box.max_px);
    return {middle.x + x * pixels_per_m, middle.y - y * pixels_per_m};
}

std::vector<std::size_t> rooms_of_storey(const core::ViewState& view) {
    std::vector<std::size_t> rooms;
    if (!view.rooms) return rooms;
    for (std::size_t r = 0; r < view.rooms->size(); ++r)
        if (const core::DrawnRoom& room = (*view.rooms)[r];
            r == view.room || (room.outline.lowest_m < view.feet_m.z + plan::kPlanCutAboveFeet_m &&
                               room.outline.highest_m > view.feet_m.z - plan::kPlanDeep_m))
            rooms.push_back(r);
    return rooms;
}

PlanExtent plan_extent(const core::ViewState& view) {
    PlanExtent extent{view.scene->bounds_m};
    if (view.scene->labyrinth.there()) {
        const bool all = view.plan_scale == core::NamedScale::Building;
        return {labyrinth_table_m(*view.scene), 0.0, 1e4, !all};
    }
    if (!view.plan_scale) return extent;
    extent.least_px_per_m = 0.0;
    const auto include = [&](Aabb& bounds, std::size_t r) {
        for (const std::vector<Vec2>& loop : (*view.rooms)[r].outline.loops_m)
            for (const Vec2& corner : loop) bounds.include(Vec3(corner, view.feet_m.z));
    };
    const auto around = [&](double margin_m) {
        return Aabb{view.feet_m - Vec3(margin_m), view.feet_m + Vec3(margin_m)};
    };
    Aabb shown;
    switch (*view.plan_scale) {
        case core::NamedScale::Building:
            return extent;
        case core::NamedScale::Floor:
            for (const std::size_t r : rooms_of_storey(view)) include(shown, r);
            break;
        case core::NamedScale::Room:
            if (view.rooms && view.room < view.rooms->size()) include(shown, view.room);
            else shown = around(2.0 * kPlanDetail_m);
            break;
        case core::NamedScale::Detail:
            shown = around(kPlanDetail_m);
            extent.most_px_per_m = 4.0 * kPlanClosest_px_per_m;
            break;
    }
    if (shown.empty()) return extent;
    extent.bounds_m = {shown.min_m - Vec3(kPlanRoomMargin_m), shown.max_m + Vec3(kPlanRoomMargin_m)};
    return extent;
}

PlanLayout lay_out_plan(const PlanExtent& extent, const Vec3& feet_m, double heading_rad, bool north_up,
                        const PixelBox& box) {
    const Aabb& bounds_m = extent.bounds_m;
    PlanLayout layout;
    layout.box = box;
    layout.centre_m = Vec2(feet_m.x, feet_m.y);
    const Vec2 size_px = box.max_px - box.min_px;
    const Vec3 world = bounds_m.empty() ? Vec3(1.0) : glm::max(bounds_m.size_m(), Vec3(1e-3));
    const Vec2 ratio(size_px.x / world.x, size_px.y / world.y);
    const double whole = 0.94 * (extent.fills ? std::max(ratio.x, ratio.y) : std::min(ratio.x, ratio.y));
    layout.pixels_per_m = std::clamp(whole, std::max(extent.least_px_per_m, 1e-3), extent.most_px_per_m);
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

}  // namespace handrail::window
