// Computes which part of the storey around the walker is shown on the screen, and where. worlds/plan makes the plan
// itself, and draw_plan draws it with this layout. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/view.h"
#include "worlds/plan/plan_cut.h"

namespace handrail::window {

struct PixelBox {
    Vec2 min_px{0.0}, max_px{0.0};  // corners of a box on the screen; y grows downwards
};

// Maps the world's x and y to pixels.
struct PlanLayout {
    Vec2 centre_m{0.0};     // the point shown in the middle of the box
    double turn_rad = 0.0;  // the heading that points up on the screen
    double pixels_per_m = 1.0;
    PixelBox box;

    Vec2 to_pixels(const Vec2& world_m) const;
    Vec2 to_pixels(const Vec3& world_m) const { return to_pixels(Vec2(world_m.x, world_m.y)); }
};

// Least scale at which the whole world is shown, unless the person has chosen how much the plan shows; a wall of 0.2 m
// is then 3 pixels wide.
inline constexpr double kPlanFinest_px_per_m = 16.0;
// Limits the scale, so that one wall of a small room does not fill a large window.
inline constexpr double kPlanClosest_px_per_m = 100.0;
inline constexpr double kPlanDetail_m = 2.5;      // the scale Detail shows this far around the walker
inline constexpr double kPlanRoomMargin_m = 0.6;  // the scale Room shows this much around the room, for its walls

// What the plan shows: a box in the world, and the limits of the scale. If the box does not fit at `least_px_per_m`,
// the plan shows the part of the box around the walker.
struct PlanExtent {
    Aabb bounds_m;
    double least_px_per_m = kPlanFinest_px_per_m, most_px_per_m = kPlanClosest_px_per_m;
    // True: the bounds fill the plan along both axes, so part of the longer axis may be outside the plan.
    bool fills = false;
};
// Returns the extent for the scale that the person chose by the scale keys: the building, the storey, the room or the
// walker's surroundings. In a labyrinth, its table fills the plan; the scale Building shows the whole table.
PlanExtent plan_extent(const core::ViewState& view);
// Returns the rooms on the walker's storey, as indices into ViewState::rooms.
std::vector<std::size_t> rooms_of_storey(const core::ViewState& view);

// Lays out the extent in the box. With north up, the plan stays inside the extent; with the heading up, the feet are in
// the middle.
PlanLayout lay_out_plan(const PlanExtent& extent, const Vec3& feet_m, double heading_rad, bool north_up,
                        const PixelBox& box);

// A scale bar with a length of 1, 2 or 5 times a power of ten, which is at most `widest_px` wide on the screen. Its
// words are "5 metres" or "50 centimetres".
struct ScaleBar {
    double length_m = 1.0;
    std::string words;
};
ScaleBar scale_bar(double pixels_per_m, double widest_px);

}  // namespace handrail::window
