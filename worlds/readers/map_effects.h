// Reads entities of the class haptic_effect. Brushes, or an origin with a radius, state where the effect acts. Keys
// state its force law. An effect without size, or with a volume that is not closed, is left out and reported by name;
// the rest of the map loads.
#pragma once

#include <functional>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/readers/map_keys.h"
#include "worlds/scene/effect.h"

namespace handrail::readers {

// An effect with the name of the object that it belongs to. That object may come later in the file.
struct ReadEffect {
    Effect effect;
    std::string target;  // name of the object; empty: the effect belongs to none
    TextPlace target_place;
};

// Reads the effects of one entity. `name` is the effect's name in messages. `built` turns a brush into a solid, without
// warnings. Returns nothing if the entity is refused.
std::vector<ReadEffect> read_effects(const MapEntity& entity, int index, const std::string& name,
                                     double metres_per_unit, const std::function<BuiltSolid(const MapBrush&)>& built,
                                     Diagnostics& diagnostics);

// Call after the whole file. Connects the effects to the objects that they belong to. If no object has the name,
// reports the name with the nearest known one; the effect then does not move.
void attach_effects(std::vector<ReadEffect>& effects, Scene& scene, Diagnostics& diagnostics);

}  // namespace handrail::readers
