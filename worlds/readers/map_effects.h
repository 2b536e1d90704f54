// Entities of the class haptic_effect: brushes or an origin with a radius say where, keys which law. What has no size
// or is not closed is refused by name, and the rest of the map loads.
#pragma once

#include <functional>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/readers/map_keys.h"
#include "worlds/scene/effect.h"

namespace handrail {

// An effect with the name of the thing it wants to belong to, which may stand later in the file.
struct ReadEffect {
    Effect effect;
    std::string target;  // empty: none
    TextPlace target_place;
};

// `name`: what is said of it. `built`: turns a brush into a solid, without warnings. Nothing where the entity is
// refused.
std::vector<ReadEffect> read_effects(const MapEntity& entity, int index, const std::string& name,
                                     double metres_per_unit, const std::function<BuiltSolid(const MapBrush&)>& built,
                                     Diagnostics& diagnostics);

// After the whole file: which things effects belong to. An unknown name is told with the nearest one; the effect then
// stays where it is.
void attach_effects(std::vector<ReadEffect>& effects, Scene& scene, Diagnostics& diagnostics);

}  // namespace handrail
