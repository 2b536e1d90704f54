// The present state of the world that the person is in. Plain state; app thread only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/core/kept/marks.h"
#include "app/core/world/mover_play.h"
#include "app/core/world/placed_things.h"
#include "app/core/world/walker_world.h"

namespace handrail::core {

struct WorldState {
    std::shared_ptr<const Scene> scene;  // null: none entered yet
    Aabb building_m;                     // without the ground that a reader added around it: building_bounds_m
    int entered = 0;                     // increases with every world that is entered
    std::uint32_t felt = 0;              // HapticScene::world of the scene that the hand gets
    PlacedThings things;
    MoverPlay movers;
    std::vector<int> thing_of_mover;      // index among the things; -1: part of the building
    std::unique_ptr<WalkerWorld> solids;  // what a walker bumps into
    Vec3 home_feet_m{0.0};
    double home_heading_rad = 0.0;
    std::vector<Mark> marks;  // the person's
};

// ---- present state of doors, lifts and buttons ----

// True for movers that move to and fro, or that at least set others going, since a button may be too flat to move.
bool usable(const WorldState& world, std::size_t mover);
// The usable mover of that feature; -1: none.
int mover_of(const WorldState& world, FeatureId feature);
// True for a door that opens neither by hand nor automatically when a person comes near: its button opens it, or a
// volume that a person enters.
bool locked(const WorldState& world, std::uint32_t mover);
bool shut(const WorldState& world, std::uint32_t mover);
// A button that opens it and is pressed by hand: the one nearest to that place.
std::optional<FeatureId> button_of(const WorldState& world, std::uint32_t mover, const Vec3& from_m);

}  // namespace handrail::core
