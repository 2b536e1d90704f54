// Stores the present state of the world that the person is in. Plain state for the app thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/marks.h"
#include "app/core/world/mover_play.h"
#include "app/core/world/placed_things.h"
#include "app/core/world/walker_world.h"

namespace handrail::core {

struct WorldState {
    std::shared_ptr<const Scene> scene;  // null: no world has been entered
    Aabb building_m;         // box of the building, without ground that a reader added around it (building_bounds_m)
    int entered = 0;         // number of the world; increases with every world that is entered
    std::uint32_t felt = 0;  // HapticScene::world of the scene that is sent to the hand
    PlacedThings things;
    MoverPlay movers;
    std::vector<int> thing_of_mover;      // for each mover, the index among the placed things; -1: part of the building
    std::unique_ptr<WalkerWorld> solids;  // the solids that a walker bumps into
    Vec3 home_feet_m{0.0};
    double home_heading_rad = 0.0;
    // Where the person entered the world, and the name of that place, which is known before the rooms are found. Empty:
    // the place has no such name.
    Vec3 begun_feet_m{0.0};
    std::string begun_at;
    std::vector<Mark> marks;  // the person's marks
};

// ---- present state of doors, lifts and buttons ----

// Returns true for a mover that moves to and fro. Some buttons are too flat to move, so the result is also true for a
// mover that only sets other movers going.
bool usable(const WorldState& world, std::size_t mover);
// Returns the index of the usable mover of this feature, or -1.
int mover_of(const WorldState& world, FeatureId feature);
// Returns true for a door that opens neither by hand nor automatically when a person comes near. A button opens such a
// door, or a volume that a person enters.
bool locked(const WorldState& world, std::uint32_t mover);
bool shut(const WorldState& world, std::uint32_t mover);
// Returns the button that opens this door by hand and is nearest to `from_m`, if there is one.
std::optional<FeatureId> button_of(const WorldState& world, std::uint32_t mover, const Vec3& from_m);

}  // namespace handrail::core
