// Makes a room for pictures and plans: 6 m east by 4 m north by 2.5 m high, with its south-west corner at the origin
// and
// walls of 0.2 m. It contains:
// - a door in the east wall, y 1.5 to 2.5 m, extending 0.1 m into the room
// - a table in the north-west, x 0.5 to 2, y 2.5 to 3.5 m, 0.7 m high
// - water in the south-west, x 0.5 to 2, y 0.5 to 1.5 m, 0.05 m above the floor
#pragma once

#include <memory>

#include "app/core/context/view.h"
#include "tests/support/names.h"

namespace handrail::test {

ConvexSolid box(const Vec3& min_m, const Vec3& max_m);

// Adds a box with its six surfaces.
void add_box(Scene& scene, const Vec3& min_m, const Vec3& max_m, FeatureKind kind, SolidRole role = SolidRole::Solid);

std::shared_ptr<const Scene> small_room(const Vec3& at_m = Vec3(0.0));

// Returns the view of a person at x, y in the room.
ViewState view_in(std::shared_ptr<const Scene> scene, double x_m, double y_m, double heading_degrees);

// Returns the view of the small room's plan, drawn as if the room were two rooms of three metres next to each other.
// The feet are in the western room. An attic is above the eastern room.
ViewState two_rooms_on_the_plan();

}  // namespace handrail::test
