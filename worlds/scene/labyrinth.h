// A game in a world: a ball is to be rolled past holes to a goal, with whatever else is free to move. Plain data, as
// the world's file states it.
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
    int level = 0;                   // 1 the easiest; 0: this world is no labyrinth
    FeatureId ball = kNoFeature;     // of a level above 0: a free body
    std::vector<Place> holes;        // what falls in there is lost; under true gaps of the floor
    std::vector<Place> goals;        // the ball is to come into one of them; of a level above 0 at least one
    std::vector<FeatureId> planks;   // free bodies that are laid over holes
    std::vector<FeatureId> blocks;   // and such that fill them
    std::vector<FeatureId> borders;  // parts of the building round the game

    bool there() const { return level > 0; }
};

}  // namespace handrail
