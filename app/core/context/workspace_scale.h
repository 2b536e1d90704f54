// Defines the four named scales and what depends on a scale: how much of the world the hand reaches, the size of the
// proxy, and the words for both. Pure functions, which any thread may call. Lengths are in world metres, unless a name
// contains "hand".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/core/dialogue/words.h"
#include "haptic/compile/simplify_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

enum class NamedScale : std::uint8_t { Building, Floor, Room, Detail };

std::string name_of(NamedScale scale);  // Returns the spoken name: "Room".

// Returns world metres per hand metre. At the scale Building, the whole bounding box fits inside the workspace of a
// device with this reach. The other scales are the same in every world.
double world_m_per_hand_m(NamedScale scale, const Aabb& bounds_m, double reach_hand_m);

// Returns "Room, 9 metres wide, 13 steps". The width is that of everything within reach of the hand.
std::string scale_sentence(NamedScale scale, double world_m_per_hand_m, double reach_hand_m, const DistanceWords& how);

// Returns the radius of the proxy. At scale 60, the proxy's diameter is `felt_diameter_m`. At other scales the proxy
// keeps its size in the world, but stays between 2 and 6 mm at the hand. Its radius is also at most a third of the
// width of the narrowest door as rendered.
double proxy_radius_m(const Scene& scene, double felt_diameter_m, double world_m_per_hand_m,
                      const compile::Simplification& plan = {});

}  // namespace handrail::core
