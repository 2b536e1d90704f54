// The world one is in as it stands now. Plain state; app thread only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/core/kept/marks.h"
#include "app/core/world/body_world.h"
#include "app/core/world/mover_play.h"
#include "app/core/world/placed_things.h"

namespace handrail {

struct WorldState {
    std::shared_ptr<const Scene> scene;  // null: none was entered yet
    Aabb building_m;                     // without the ground that a reader laid around it: building_bounds_m
    int entered = 0;                     // rises with every world that is entered
    std::uint32_t felt = 0;              // HapticScene::world of what a hand is given to feel of it
    PlacedThings things;
    MoverPlay movers;
    std::vector<int> thing_of_mover;    // place among the things, -1: part of the building
    std::unique_ptr<BodyWorld> solids;  // what a body bumps into
    Vec3 home_feet_m{0.0};
    double home_heading_rad = 0.0;
    std::vector<Mark> marks;  // the person's
};

// ---- doors, lifts and buttons, as they stand ----

// What moves to and fro, or at least sets others going: a button may be too flat to be pressed in.
bool usable(const WorldState& world, std::size_t mover);
// The usable mover of that feature; -1: none.
int mover_of(const WorldState& world, FeatureId feature);
// A door that neither a hand nor coming near opens: its button does, or some place that one walks into.
bool locked(const WorldState& world, std::uint32_t mover);
bool shut(const WorldState& world, std::uint32_t mover);
// What opens it and is pressed by hand: the one nearest to that place.
std::optional<FeatureId> button_of(const WorldState& world, std::uint32_t mover, const Vec3& from_m);

}  // namespace handrail
