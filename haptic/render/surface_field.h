// Computes how much lower or higher a surface is felt than its obstacle, as a field over the hand's position. Depth
// textures lower the surface, and force shading raises it over the facets of a tessellated curve. The tick calls
// surface_field() once for each surface that holds the proxy, only in scenes with textures or shading. Servo thread;
// noexcept, no allocation.
#pragma once

#include "haptic/render/haptic_scene.h"

namespace handrail::render {

struct SurfaceField {
    double shift_m = 0.0;   // how much lower than its obstacle the surface is felt; negative: higher
    Vec3 gradient{0.0};     // gradient of the shift over the hand's position
    double friction = 1.0;  // factor by which the material's friction is multiplied
    double swing_to_shift = 0.0;
};

// The input of surface_field() for one hold. It has the positions of the hand and of the proxy's frictionless resting
// place, in the coordinates of the holding shape, and the depth of the press along the normal.
struct FieldRequest {
    std::uint32_t obstacle = 0, face = 0;
    Vec3 normal{0.0};  // normal of the hold
    Vec3 hand_m{0.0}, proxy_m{0.0};
    double press_m = 0.0;
    double radius_m = 0.0;
    double world_m_per_hand_m = 1.0;
    double stiffness_n_per_m = 0.0;  // stiffness per hand metre
    double swing = 1.0;              // swing of waves, see relief_at()
};

// Returns the field. `shape` contains the obstacle: it is the scene itself or the shape of one of its bodies. Materials
// and textures always come from the scene.
SurfaceField surface_field(const HapticScene& scene, const HapticScene& shape, const FieldRequest& request) noexcept;

}  // namespace handrail::render
