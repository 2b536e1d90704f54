// Defines haptic effects as the world file states them: forces in space, without visible geometry. haptic/compile turns
// them into force laws. The kinds of effects are rows of a table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"
#include "worlds/scene/source_place.h"

namespace handrail {

enum class EffectKind { Magnet, Detent, Button, FlyPaper, Inertia, Force, Vibration };

// A row of the table: the legal values of the keys for one kind of effect. Forces are in newtons, widths in metres of
// hand travel.
struct EffectSpec {
    std::string_view name;  // the value of the key `effect` that selects this kind
    EffectKind kind = EffectKind::Magnet;
    // Default and range of the strength; all 0 if this kind has no strength.
    double strength_n = 0.0, least_n = 0.0, most_n = 0.0;
    // Default and range of the width; all 0 if this kind has no width.
    double width_hand_m = 0.0, least_hand_m = 0.0, most_hand_m = 0.0;
    double edge_hand_m = 0.010;
};

// Returns all kinds, in a fixed order.
std::span<const EffectSpec> effect_table();
// Finds the kind with exactly this name, ignoring case. Returns nullptr if there is no such kind.
const EffectSpec* find_effect(std::string_view name);

// The part of a magnet or object to which a magnet pulls the hand.
enum class MagnetPull {
    Point,    // the middle of the magnet's volume
    Line,     // the longest middle line of the magnet's volume
    Surface,  // the largest middle plane of the magnet's volume
    Object,   // the faces of the box around the object that the magnet belongs to
};

struct EffectBall {
    Vec3 centre_m{0.0};
    double radius_m = 0.0;
};
struct EffectCapsule {
    Vec3 a_m{0.0}, b_m{0.0};
    double radius_m = 0.0;
};

constexpr double kLeastEdge_hand_m = 0.001, kMostEdge_hand_m = 0.1;
constexpr double kLeastVibration_hz = 20.0, kMostVibration_hz = 250.0;
constexpr double kLeastMass_kg = 0.05, kMostMass_kg = 0.3;

struct Effect {
    EffectKind kind = EffectKind::Magnet;
    std::variant<ConvexSolid, EffectBall, EffectCapsule> where;
    std::string name;  // name of the effect in messages
    double strength_n = 0.0;
    double width_hand_m = 0.0;
    double edge_hand_m = 0.010;
    Vec3 direction{0.0, 0.0, 1.0};  // direction of the effect, unit length
    double frequency_hz = 100.0;
    double mass_kg = 0.1;
    MagnetPull pull = MagnetPull::Point;
    FeatureId belongs_to = kNoFeature;  // the object that the effect moves with; kNoFeature: the effect does not move
    SourcePlace source;
};

}  // namespace handrail
