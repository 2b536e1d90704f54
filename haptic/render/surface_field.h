// What shifts a surface from where its obstacle lies, as a field over the hand's place: depth textures lower it, force
// shading raises it over the facets of a tessellated curve. One call per surface that holds the ball, only in scenes
// that have such surfaces. Servo thread; noexcept, no allocation.
#pragma once

#include "haptic/render/haptic_scene.h"

namespace handrail {

struct SurfaceField {
    double shift_m = 0.0;   // how much lower the surface is felt; negative: higher
    Vec3 gradient{0.0};     // of the shift, by the hand's place
    double friction = 1.0;  // factor on the material's friction
    double swing_to_shift = 0.0;
};

// What is asked of a hold: where the hand and the ball's frictionless resting place are (in the
// coordinates of the shape that holds), how deep the press is along the normal.
struct FieldRequest {
    std::uint32_t obstacle = 0, face = 0;
    Vec3 normal{0.0};  // of the hold
    Vec3 hand_m{0.0}, ball_m{0.0};
    double press_m = 0.0;
    double radius_m = 0.0;
    double world_m_per_hand_m = 1.0;
    double stiffness_n_per_m = 0.0;  // per hand metre
    double swing = 1.0;              // of waves, see relief_at
};

// `shape` holds the obstacle: the scene itself or that of one of its bodies; materials and textures are the scene's.
SurfaceField surface_field(const HapticScene& scene, const HapticScene& shape, const FieldRequest& request) noexcept;

}  // namespace handrail
