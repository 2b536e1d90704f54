// Scenes of a single thing, built in code, which can be set down in a world while it runs. Pure functions; any thread.
#pragma once

#include <memory>
#include <string>

#include "worlds/base/result.h"
#include "worlds/scene/primitive.h"
#include "worlds/scene/scene.h"

namespace handrail {

// One exact shape as one solid. Fails with a sentence if make_solid does.
Result<std::shared_ptr<const Scene>> primitive_model(const Primitive& primitive);
// A box of this size in metres, centred on its frame's origin.
Result<std::shared_ptr<const Scene>> box_model(const Vec3& size_m);

// A copy of a world with one more thing. `name` is announced when the thing is touched. Fails with a sentence if the
// name is taken, the model is empty, or the placement is not finite or has no size. material: a name from the library,
// or empty for the default wall; for an unknown name, the sentence suggests the nearest.
Result<Scene> with_placed(const Scene& world, const std::string& name, std::shared_ptr<const Scene> model,
                          const Placement& at, const std::string& material);
// Takes the movers out of the building and places each as a separate thing, with the origin of its frame at its pivot,
// so that it can be moved while it is touched. The world then has at most `most_things` placed things; further movers
// stay part of the building. `thing_of_mover` receives each mover's index in Scene::placed, or -1 if it stayed.
Scene with_movers_apart(const Scene& world, std::size_t most_things, std::vector<int>& thing_of_mover);
// The same for bodies that are free to move (Scene::bodies); the origin of each frame is in the middle of its box.
// `thing_of_body` receives each body's index in Scene::placed, or -1 if it stayed part of the building.
Scene with_bodies_apart(Scene world, std::size_t most_things, std::vector<int>& thing_of_body);
// A copy of a world without the placed thing of that name. Fails with a sentence if there is none.
Result<Scene> without_placed(const Scene& world, const std::string& name);
// The world box around a box in a thing's own frame, for a thing placed there.
Aabb placed_bounds(const Aabb& own, const Placement& at);
// Moves the placed thing with this index in Scene::placed, and updates its bounds and drawn surfaces.
void move_placed(Scene& world, std::size_t thing, const Placement& at);
// The index in Scene::placed of the placed thing of that name; -1 if there is none. Ignores case.
int find_placed(const Scene& world, const std::string& name);

}  // namespace handrail
