// The four named scales and what follows from a scale: how much world the hand reaches, how large its ball is, and the
// words for it. Pure functions; any thread. World metres, unless a name says hand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/core/dialogue/words.h"
#include "haptic/compile/simplify_scene.h"
#include "worlds/scene/scene.h"

namespace handrail {

enum class NamedScale : std::uint8_t { Building, Floor, Room, Detail };

std::string name_of(NamedScale scale);  // "Room"

// World metres per hand metre. Building fits the bounds, corner to corner, inside the rim of a device of that reach;
// the others are the same everywhere.
double world_m_per_hand_m(NamedScale scale, const Aabb& bounds_m, double reach_hand_m);

// "Room, 9 metres wide, 13 steps": the width of all that the hand reaches.
std::string scale_sentence(NamedScale scale, double world_m_per_hand_m, double reach_hand_m, const DistanceWords& how);

// The ball: felt_diameter_m at scale 60 and the same size in the world at others, but 2 to 6 mm felt, and at most a
// third of the narrowest door, as wide as it is felt.
double ball_radius_m(const Scene& scene, double felt_diameter_m, double world_m_per_hand_m,
                     const Simplification& plan = {});

}  // namespace handrail
