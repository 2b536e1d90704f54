// What a map says of the game in it: `labyrinth` on worldspawn, the brushes of trigger_hole and trigger_goal, and
// `role` of what is free to move. One reading thread.
#pragma once

#include <functional>
#include <string_view>

#include "worlds/readers/map_brushes.h"
#include "worlds/readers/map_keys.h"
#include "worlds/scene/scene.h"

namespace handrail {

class MapLabyrinth {
public:
    void note_world(const MapEntity& entity, const MapKeys& keys);
    // False: not of the game. A place of it is neither touched nor seen; each brush is one.
    bool take_place(const MapEntity& entity, std::string_view class_name, int index,
                    const std::function<BuiltSolid(const MapBrush&)>& built);
    // The entity's solids are in the scene under this name; free: they are a free body.
    void note_role(const MapEntity& entity, FeatureId feature, bool free, Diagnostics& diagnostics);
    // After the last entity. What makes no game of it is told, and then there is none.
    void attach(Scene& scene, Diagnostics& diagnostics);

private:
    LabyrinthPlan plan_;
    TextPlace world_place_;
};

}  // namespace handrail
