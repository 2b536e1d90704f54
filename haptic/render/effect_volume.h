// Effects: forces that hang in space without visible geometry. A table row says where (a region with soft edges) and
// which law. Plain data, built off the real-time path, then only read. Regions and targets are world metres (of the
// body's own frame for an effect that hangs on one); felt lengths are hand metres and grow with the scale, so that
// zooming never changes how an effect feels; forces act per hand travel. Every law is either the slope of a bounded
// potential or a point that yields along its own spring, so it gives no energy; constant force, flow and vibration are
// sources of stated, bounded power. The laws stand in effects.cpp.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail {

// ---- where ----

struct SphereRegion {
    Vec3 centre_m{0.0};
    double radius_m = 0.0;
};
struct CapsuleRegion {
    Vec3 a_m{0.0}, b_m{0.0};
    double radius_m = 0.0;
};
struct ConvexRegion {
    std::vector<Plane> planes;  // bounded
};
using EffectRegion = std::variant<Aabb, SphereRegion, CapsuleRegion, ConvexRegion>;

// ---- what ----

// A place, a line or a flat rectangle: the centre and up to two half axes at right angles; zero ones are not there.
struct MagnetTarget {
    Vec3 centre_m{0.0};
    Vec3 half_u_m{0.0}, half_v_m{0.0};
};
// Draws to the nearest target, or away from it: F = (F0/w) exp((1 - u^2)/2) e with e the way to the target and u =
// |e|/w. Strongest at u = 1. Between targets the potentials blend, so that no edge is felt where the nearest one
// changes.
struct MagnetLaw {
    std::vector<MagnetTarget> targets;
    double force_n = 2.0;  // F0; negative pushes away. At most 4
    double width_hand_m =
        0.010;  // w, at least 1 mm. Within a small region it shrinks to 0.4 of the region's inner radius
};
// A row of notches along a direction: F = -F0 sin(2 pi s / l); at rest at the origin and every l from it.
struct DetentLaw {
    Vec3 origin_m{0.0};
    Vec3 direction{1.0, 0.0, 0.0};  // unit
    double force_n = 1.5;           // F0, at most 4
    double pitch_hand_m = 0.010;    // l, at least 2 mm
};
// A button that snaps between two places half a travel before and behind the origin: a quartic double well whose outer
// walls fade away.
struct ButtonLaw {
    Vec3 origin_m{0.0};
    Vec3 direction{1.0, 0.0, 0.0};  // unit
    double force_n = 1.0;           // largest force between the places, at most 4
    double travel_hand_m = 0.020;   // from one place to the other, at least 2 mm
};
// Holds the hand where it is until it is torn off.
struct FlyPaperLaw {
    double break_n = 3.0;  // at most 4
};
// A mass hangs on the hand by a spring.
struct InertiaLaw {
    double mass_kg = 0.1;  // 0.05 to 0.3
    double damping_ns_per_m = 0.2;
};
// Wind: a steady force. A source: it gives at most force times the region's length.
struct ForceLaw {
    Vec3 direction{1.0, 0.0, 0.0};  // unit
    double force_n = 1.0;           // at most 2
};
// A source.
struct VibrationLaw {
    Vec3 direction{0.0, 0.0, 1.0};  // unit
    double amplitude_n = 0.2;       // at most 0.5
    double frequency_hz = 100.0;    // 20 to 250
};

// What a law of one's own may look at.
struct EffectPoint {
    Vec3 at_m{0.0};       // where the hand is, in the region's coordinates
    double scale = 1.0;   // world metres per hand metre
    double weight = 0.0;  // 0 at the region's edge, 1 inside
    Vec3 velocity{0.0};   // of the hand through the region, hand metres per second, not filtered
    double time_s = 0.0;  // since the hand came in
    double dt_s = 0.0;
};
// A force computed each tick by code outside this library. The function must be real-time safe; the force is multiplied
// by the region's weight, so it fades at the edge. What it says about stiffness counts in the sum that is kept below
// the device's limit; whether it gives energy is up to it.
struct CustomLaw {
    Vec3 (*force_n)(const EffectPoint& point, const void* data) noexcept = nullptr;
    std::shared_ptr<const void> data;
    double stiffness_n_per_m = 0.0;  // no smaller than the steepest slope of the force over hand travel
};

using EffectLaw =
    std::variant<MagnetLaw, DetentLaw, ButtonLaw, FlyPaperLaw, InertiaLaw, ForceLaw, VibrationLaw, CustomLaw>;

struct EffectVolume {
    static constexpr std::uint32_t kNoBody = std::numeric_limits<std::uint32_t>::max();

    FeatureId feature = kNoFeature;
    EffectRegion region;
    double edge_hand_m =
        0.010;  // how far inside the border the law has its whole strength; less where the region is smaller
    EffectLaw law;
    std::uint32_t body =
        kNoBody;  // HapticScene::bodies this hangs on: region and targets are then in that body's own frame

    // Worked out when the scene is built.
    double inner_radius_m = 0.0;           // of a ball that fits the region
    double stiffness_n_per_m = 0.0;        // no slope of the force is steeper
    double crowd_stiffness_n_per_m = 0.0;  // of this and everything that overlaps it, together
    bool by_obstacle = false;              // an obstacle may be touched within it
};

// World or body box around a region; empty for one without a size.
Aabb bounds_of(const EffectRegion& region);
// The radius of a ball that fits; for convex regions nearly the largest.
double inner_radius_m(const EffectRegion& region);
// True when every number is finite and in the ranges above, the region is closed and has a size, and directions have
// length 1.
bool is_sound(const EffectVolume& effect);
// The steepest slope that the law can have anywhere, at any scale, in N per hand metre.
double stiffness_bound_n_per_m(const EffectLaw& law);

}  // namespace handrail
