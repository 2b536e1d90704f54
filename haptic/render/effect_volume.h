// Effects: forces in space without visible geometry. A row of the effect table gives a region with soft edges and a
// force law. Plain data, built at set-up and then only read. Regions and targets are in world metres, or in the body's
// own frame for an effect attached to a body. Felt lengths are in hand metres and are multiplied by the scale, so
// zooming never changes how an effect feels. Forces act per hand travel. Most laws give no energy, because they are
// either the slope of a bounded potential or a point that yields along its own spring. The exceptions are constant
// force, liquid flow and vibration, which are sources of stated, bounded power. effects.cpp contains the laws.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail::render {

// ---- regions ----

struct SphereRegion {
    Vec3 centre_m{0.0};
    double radius_m = 0.0;
};
struct CapsuleRegion {
    Vec3 a_m{0.0}, b_m{0.0};
    double radius_m = 0.0;
};
struct ConvexRegion {
    std::vector<Plane> planes;  // the region is the intersection behind these planes, which must be bounded
};
using EffectRegion = std::variant<Aabb, SphereRegion, CapsuleRegion, ConvexRegion>;

// ---- laws ----

// A point, a line or a flat rectangle, given by its centre and up to two half axes at right angles. A zero vector means
// that there is no such axis.
struct MagnetTarget {
    Vec3 centre_m{0.0};
    Vec3 half_u_m{0.0}, half_v_m{0.0};
};
// Pulls towards the nearest target, or pushes away from it: F = (F0/w) exp((1 - u^2)/2) e, where e is the vector to the
// target and u = |e|/w. The force is greatest at u = 1. Between targets the potentials blend, so that the hand feels no
// edge where the nearest target changes.
struct MagnetLaw {
    std::vector<MagnetTarget> targets;
    double force_n = 2.0;  // F0; a negative value pushes away; at most 4
    // Width w, at least 1 mm. In a small region it is reduced to 0.4 of the region's inner radius.
    double width_hand_m = 0.010;
};
// A row of detents along a direction: F = -F0 sin(2 pi s / l). The hand rests at the origin and at every multiple of l
// from it.
struct DetentLaw {
    Vec3 origin_m{0.0};
    Vec3 direction{1.0, 0.0, 0.0};  // unit vector
    double force_n = 1.5;           // F0, at most 4
    double pitch_hand_m = 0.010;    // l, the distance between detents; at least 2 mm
};
// A button that snaps between two positions, half its travel before and behind the origin. Its potential is a quartic
// double well whose outer walls fade out.
struct ButtonLaw {
    Vec3 origin_m{0.0};
    Vec3 direction{1.0, 0.0, 0.0};  // unit vector
    double force_n = 1.0;           // largest force between the two positions, at most 4
    double travel_hand_m = 0.020;   // distance between the two positions, at least 2 mm
};
// Holds the hand where it is until the hand tears itself free.
struct FlyPaperLaw {
    double break_n = 3.0;  // force at which the hand tears free; at most 4
};
// A mass attached to the hand by a spring.
struct InertiaLaw {
    double mass_kg = 0.1;  // mass, 0.05 to 0.3
    double damping_ns_per_m = 0.2;
};
// Wind: a steady force. It is a source of energy and gives at most the force times the region's length.
struct ForceLaw {
    Vec3 direction{1.0, 0.0, 0.0};  // unit vector
    double force_n = 1.0;           // at most 2 N
};
// A vibration. It is a source of energy.
struct VibrationLaw {
    Vec3 direction{0.0, 0.0, 1.0};  // unit vector
    double amplitude_n = 0.2;       // at most 0.5 N
    double frequency_hz = 100.0;    // 20 to 250 Hz
};

// The input of a custom law.
struct EffectPoint {
    Vec3 at_m{0.0};       // position of the hand, in the region's coordinates
    double scale = 1.0;   // world metres per hand metre
    double weight = 0.0;  // weight of the region, 0 at its edge and 1 inside
    Vec3 velocity{0.0};   // velocity of the hand through the region, hand metres per second, unfiltered
    double time_s = 0.0;  // time since the hand entered the region
    double dt_s = 0.0;
};
// A force that code outside this library computes in each tick. The function must be real-time safe. Its force is
// multiplied by the region's weight, so it fades at the edge. The stated stiffness is added to that of the other
// effects, and the sum is kept below the device's limit. The function itself must ensure that it gives no energy.
struct CustomLaw {
    Vec3 (*force_n)(const EffectPoint& point, const void* data) noexcept = nullptr;
    std::shared_ptr<const void> data;
    double stiffness_n_per_m = 0.0;  // upper bound for the slope of the force over hand travel
};

using EffectLaw =
    std::variant<MagnetLaw, DetentLaw, ButtonLaw, FlyPaperLaw, InertiaLaw, ForceLaw, VibrationLaw, CustomLaw>;

struct EffectVolume {
    static constexpr std::uint32_t kNoBody = std::numeric_limits<std::uint32_t>::max();

    FeatureId feature = kNoFeature;
    EffectRegion region;
    // Depth inside the border of the region from which on the law has its full strength. It is less if the region is
    // small.
    double edge_hand_m = 0.010;
    EffectLaw law;
    // Index in HapticScene::bodies of the body that the effect is attached to. Region and targets are then in that
    // body's frame.
    std::uint32_t body = kNoBody;

    // The members below are computed when the scene is built.
    double inner_radius_m = 0.0;     // radius of a ball that fits into the region
    double stiffness_n_per_m = 0.0;  // upper bound for the slope of the force
    // Sum of the stiffness bounds of this effect and of all effects that overlap it.
    double crowd_stiffness_n_per_m = 0.0;
    bool by_obstacle = false;  // an obstacle may be felt inside the region
};

// Returns the bounds of a region, in world or body coordinates. They are empty for a region without a size.
Aabb bounds_of(const EffectRegion& region);
// Returns the radius of a ball that fits into the region. For convex regions it is nearly the largest such radius.
double inner_radius_m(const EffectRegion& region);
// Returns true if the effect is valid: every number is finite and within the ranges above, the region is bounded and
// has a size, and directions have length 1.
bool is_sound(const EffectVolume& effect);
// Returns an upper bound for the slope of the law, in N per hand metre, at any place and any scale.
double stiffness_bound_n_per_m(const EffectLaw& law);

}  // namespace handrail::render
