// Defines the labyrinth game of a world: the player rolls a ball past holes to a goal. Other free bodies may help or
// hinder. Plain data, as the world's file states it.
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
    int level = 0;                   // 1 is the easiest level; 0: this world has no labyrinth game
    FeatureId ball = kNoFeature;     // the free body that the player rolls; always set if level > 0
    std::vector<Place> holes;        // boxes below real gaps in the floor; a ball that falls into one is lost
    std::vector<Place> goals;        // the ball must get into one of these; at least one if level > 0
    std::vector<FeatureId> planks;   // free bodies that the player lays over holes
    std::vector<FeatureId> blocks;   // free bodies that the player fills holes with
    std::vector<FeatureId> borders;  // parts of the building that surround the game

    bool there() const { return level > 0; }
};

}  // namespace handrail
