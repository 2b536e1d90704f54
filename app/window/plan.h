// Where on the screen the plan of the storey around the body is shown (worlds/plan has the plan itself). Pure
// functions; the renderer turns plan and layout into lines and fills.
#pragma once

#include <string>

#include "worlds/plan/plan_cut.h"

namespace handrail {

struct PixelBox {
    Vec2 min_px{0.0}, max_px{0.0};  // y grows downwards
};

// From the world's x, y to pixels.
struct PlanLayout {
    Vec2 centre_m{0.0};     // shown in the middle of the box
    double turn_rad = 0.0;  // this heading is up
    double pixels_per_m = 1.0;
    PixelBox box;

    Vec2 to_pixels(const Vec2& world_m) const;
    Vec2 to_pixels(const Vec3& world_m) const { return to_pixels(Vec2(world_m.x, world_m.y)); }
};

// North up: the whole world when at least kPlanFinest_px_per_m remain, else the part around the feet, kept within the
// world's bounds. Heading up: the feet in the middle.
inline constexpr double kPlanFinest_px_per_m = 16.0;    // a wall of 0.2 m is 3 pixels wide
inline constexpr double kPlanClosest_px_per_m = 100.0;  // a small room does not fill a large window with one wall
PlanLayout lay_out_plan(const Aabb& bounds_m, const Vec3& feet_m, double heading_rad, bool north_up,
                        const PixelBox& box);

// A length of 1, 2 or 5 times a power of ten that takes at most `widest_px`, and its words: "5 metres", "50
// centimetres".
struct ScaleBar {
    double length_m = 1.0;
    std::string words;
};
ScaleBar scale_bar(double pixels_per_m, double widest_px);

}  // namespace handrail
