// The four named scales, and what follows from a scale: how much of the world the hand reaches, the size of its proxy,
// and the words for it. Pure functions; any thread. World metres, unless a name says hand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/core/dialogue/words.h"
#include "haptic/compile/simplify_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

enum class NamedScale : std::uint8_t { Building, Floor, Room, Detail };

std::string name_of(NamedScale scale);  // "Room"

// World metres per hand metre. Building makes the bounds, corner to corner, fit inside the rim of a device of that
// reach. The other scales are the same everywhere.
double world_m_per_hand_m(NamedScale scale, const Aabb& bounds_m, double reach_hand_m);

// "Room, 9 metres wide, 13 steps": the width of everything that the hand reaches.
std::string scale_sentence(NamedScale scale, double world_m_per_hand_m, double reach_hand_m, const DistanceWords& how);

// Radius of the proxy. It corresponds to felt_diameter_m at scale 60 and keeps that size in the world at other scales,
// within 2 to 6 mm at the hand. It is also at most a third of the width of the narrowest door as rendered.
double ball_radius_m(const Scene& scene, double felt_diameter_m, double world_m_per_hand_m,
                     const compile::Simplification& plan = {});

}  // namespace handrail::core
