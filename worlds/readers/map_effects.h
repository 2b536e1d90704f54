// Reads entities of the class haptic_effect. Brushes, or an origin with a radius, say where the effect acts; keys say
// which law. An effect without size, or not closed, is refused by name, and the rest of the map loads.
#pragma once

#include <functional>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/readers/map_keys.h"
#include "worlds/scene/effect.h"

namespace handrail::readers {

// An effect with the name of the thing that it belongs to, which may come later in the file.
struct ReadEffect {
    Effect effect;
    std::string target;  // empty: it belongs to nothing
    TextPlace target_place;
};

// `name`: the effect's name in messages. `built`: turns a brush into a solid, without warnings. Returns nothing if the
// entity is refused.
std::vector<ReadEffect> read_effects(const MapEntity& entity, int index, const std::string& name,
                                     double metres_per_unit, const std::function<BuiltSolid(const MapBrush&)>& built,
                                     Diagnostics& diagnostics);

// Call after the whole file: finds the things that effects belong to. An unknown name is reported with the nearest
// known one; the effect then does not move.
void attach_effects(std::vector<ReadEffect>& effects, Scene& scene, Diagnostics& diagnostics);

}  // namespace handrail::readers
