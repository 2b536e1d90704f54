// A world made ready to be entered, away from the app thread: what moves set apart, what a body meets, what a hand
// feels first. Pure; any thread.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "app/core/kept/ways_keeper.h"
#include "app/core/world/body_world.h"
#include "haptic/render/dynamics_scene.h"
#include "haptic/render/haptic_scene.h"

namespace handrail {

struct EnteringWorld {
    std::shared_ptr<const Scene> file;                  // as it was read
    std::shared_ptr<const Scene> scene;                 // what moves stands in it as things
    std::vector<int> thing_of_mover;                    // place among the things, -1: part of the building
    std::shared_ptr<const DynamicsScene> moves_freely;  // null: nothing in it is free to move
    Vec3 feet_m{0.0};                                   // where one begins
    double heading_rad = 0.0;
    std::unique_ptr<BodyWorld> body;
    std::shared_ptr<const HapticScene>
        sharp;        // felt until it has been rounded and simplified; null: that is done on entering
    WaysKeeper ways;  // keeps its ways and rooms for the next start
};

// At the base (or first) start of the scene.
EnteringWorld make_ready(std::shared_ptr<const Scene> scene);
// The same, at a place and heading of the caller's choice.
EnteringWorld make_ready_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad);
// The same with something to touch at once. Ask `stop` from another thread where it is not wanted any more: `sharp` is
// null then.
EnteringWorld make_ready_to_touch(std::shared_ptr<const Scene> scene, const std::stop_token& stop = {});

}  // namespace handrail
