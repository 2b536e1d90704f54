// Computes where on the screen the plan of the storey around the walker is shown; the plan itself is made in
// worlds/plan. Pure functions; the renderer draws lines and fills from plan and layout.
#pragma once

#include <string>

#include "worlds/plan/plan_cut.h"

namespace handrail::window {

struct PixelBox {
    Vec2 min_px{0.0}, max_px{0.0};  // y grows downwards
};

// Maps the world's x and y to pixels.
struct PlanLayout {
    Vec2 centre_m{0.0};     // the point shown in the middle of the box
    double turn_rad = 0.0;  // the heading that points up
    double pixels_per_m = 1.0;
    PixelBox box;

    Vec2 to_pixels(const Vec2& world_m) const;
    Vec2 to_pixels(const Vec3& world_m) const { return to_pixels(Vec2(world_m.x, world_m.y)); }
};

// With north up: the whole world if at least kPlanFinest_px_per_m remain, else the part around the feet, kept within
// the world's bounds. With the heading up: the feet are in the middle.
inline constexpr double kPlanFinest_px_per_m = 16.0;    // a 0.2 m wall is then 3 pixels wide
inline constexpr double kPlanClosest_px_per_m = 100.0;  // so that one wall of a small room does not fill a large window
PlanLayout lay_out_plan(const Aabb& bounds_m, const Vec3& feet_m, double heading_rad, bool north_up,
                        const PixelBox& box);

// A length of 1, 2 or 5 times a power of ten that is at most `widest_px` wide, and its words: "5 metres", "50
// centimetres".
struct ScaleBar {
    double length_m = 1.0;
    std::string words;
};
ScaleBar scale_bar(double pixels_per_m, double widest_px);

}  // namespace handrail::window
