// Prepares a world outside the app thread, so that the session can enter it: separates moving things from the building,
// and makes the solids for walking and the first haptic scene. Pure functions, which any thread may call.
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
    std::shared_ptr<const Scene> file;   // the world as read from the file
    std::shared_ptr<const Scene> scene;  // the world with its movable parts as placed things
    std::vector<int> thing_of_mover;     // for each mover, the index among the placed things; -1: part of the building
    std::shared_ptr<const render::DynamicsScene> moves_freely;  // null: nothing in the world is movable
    Vec3 feet_m{0.0};                                           // where the walker starts
    double heading_rad = 0.0;
    std::unique_ptr<WalkerWorld> body;
    // The scene that the hand feels until the rounded and simplified scene is ready. If it is null, it is made when
    // the world is entered.
    std::shared_ptr<const render::HapticScene> sharp;
    RoutesKeeper ways;  // stores the routes and rooms of the world for the next start of the program
};

// Prepares a world in which the walker starts at the base, or else at the first start.
EnteringWorld make_ready(std::shared_ptr<const Scene> scene);
// Prepares a world in which the walker starts at this place and heading.
EnteringWorld make_ready_at(std::shared_ptr<const Scene> scene, const Vec3& feet_m, double heading_rad);
// Prepares a world with a haptic scene that the hand can touch at once. Another thread may request `stop` to cancel.
// The member `sharp` is then null.
EnteringWorld make_ready_to_touch(std::shared_ptr<const Scene> scene, const std::stop_token& stop = {});

}  // namespace handrail::core
