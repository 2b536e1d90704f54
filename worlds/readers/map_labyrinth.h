// Reads the labyrinth game of a map: the key `labyrinth` on worldspawn, the brushes of trigger_hole and trigger_goal,
// and the key `role` of free bodies. Used on the reading thread only.
#pragma once

#include <functional>
#include <string_view>

#include "worlds/readers/map_brushes.h"
#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

class MapLabyrinth {
public:
    void note_world(const MapEntity& entity, const MapKeys& keys);
    // If the entity is a hole or a goal, stores its places and returns true; else returns false. Each of its brushes
    // becomes a separate place, which can be neither touched nor seen.
    bool take_place(const MapEntity& entity, std::string_view class_name, int index,
                    const std::function<BuiltSolid(const MapBrush&)>& built);
    // Reads the key `role` of an entity. `feature` is the feature of the entity's solids in the scene. `free` says
    // whether these solids are a free body.
    void note_role(const MapEntity& entity, FeatureId feature, bool free, Diagnostics& diagnostics);
    // Call after the last entity. Adds the game to the scene. If the parts do not make a complete game, reports that,
    // and the scene gets no game.
    void attach(Scene& scene, Diagnostics& diagnostics);

private:
    LabyrinthPlan plan_;
    TextPlace world_place_;
};

}  // namespace handrail::readers
