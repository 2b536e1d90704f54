// Prepares a world for entering, away from the app thread: separates moving things, and makes the solids for walking
// and the first haptic scene. Pure functions; any thread.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "app/core/kept/routes_keeper.h"
#include "app/core/world/walker_world.h"
#include "haptic/render/dynamics_scene.h"
#include "haptic/render/haptic_scene.h"

namespace handrail::core {

struct EnteringWorld {
    std::shared_ptr<const Scene> file;                          // as read from the file
    std::shared_ptr<const Scene> scene;                         // movable parts are in it as placed things
    std::vector<int> thing_of_mover;                            // index among the things; -1: part of the building
    std::shared_ptr<const render::DynamicsScene> moves_freely;  // null: nothing in it is movable
    Vec3 feet_m{0.0};                                           // where the walker begins
    double heading_rad = 0.0;
    std::unique_ptr<WalkerWorld> body;
    std::shared_ptr<const render::HapticScene>
        sharp;          // felt until the rounded and simplified scene is ready; null: made on entering
    RoutesKeeper ways;  // stores its routes and rooms for the next start
};

// Starts at the base of the scene, or at its first start.
EnteringWorld make_ready(std::shared_ptr<const Scene> scene);
// The same, at a place and heading chosen by the caller.
EnteringWorld make_ready_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad);
// The same with a haptic scene to touch at once. Request `stop` from another thread to cancel; `sharp` is then null.
EnteringWorld make_ready_to_touch(std::shared_ptr<const Scene> scene, const std::stop_token& stop = {});

}  // namespace handrail::core
