// The labyrinth game of a world: the player rolls a ball past holes to a goal; other free bodies may help or hinder.
// Plain data, as the world's file states it.
#pragma once

#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"
#include "worlds/scene/source_place.h"

namespace handrail {

struct LabyrinthPlan {
    struct Place {
        Aabb box_m;
        SourcePlace source;
    };
    int level = 0;                   // 1 is the easiest; 0: this world is no labyrinth
    FeatureId ball = kNoFeature;     // a free body; always set if level > 0
    std::vector<Place> holes;        // a ball that falls in is lost; they are below real gaps in the floor
    std::vector<Place> goals;        // the ball must get into one of them; at least one if level > 0
    std::vector<FeatureId> planks;   // free bodies to lay over holes
    std::vector<FeatureId> blocks;   // free bodies to fill holes with
    std::vector<FeatureId> borders;  // parts of the building that surround the game

    bool there() const { return level > 0; }
};

}  // namespace handrail
