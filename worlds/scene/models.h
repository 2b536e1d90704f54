// Builds, without a file, scenes of a single object. Such a scene can be placed in a world while the world runs. Pure
// functions; any thread may call them.
#pragma once

#include <memory>
#include <string>

#include "worlds/base/result.h"
#include "worlds/scene/primitive.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Returns a scene of one exact shape, as one solid. Fails with a sentence if make_solid does.
Result<std::shared_ptr<const Scene>> primitive_model(const Primitive& primitive);
// Returns a scene of a box of this size in metres, centred on the origin of its frame.
Result<std::shared_ptr<const Scene>> box_model(const Vec3& size_m);

// Returns a copy of a world with one more object. `name` is announced when the object is touched. `material` is a name
// from the library, or empty for the default wall. Fails with a sentence if the name is taken, the model is empty, or
// the placement is not finite or has no size. Also fails if the material is unknown; the sentence then suggests the
// nearest name.
Result<Scene> with_placed(const Scene& world, const std::string& name, std::shared_ptr<const Scene> model,
                          const Placement& at, const std::string& material);
// Removes the movers from the building and places each as a separate object, so that it can be moved while it is
// touched. The origin of the object's frame is at its pivot. The world then has at most `most_things` placed objects;
// further movers stay part of the building. `thing_of_mover` receives the index of each mover in Scene::placed, or -1
// if the mover stayed.
Scene with_movers_apart(const Scene& world, std::size_t most_things, std::vector<int>& thing_of_mover);
// Does the same as with_movers_apart for bodies that are free to move (Scene::bodies). The origin of each frame is in
// the middle of the body's box. `thing_of_body` receives the index of each body in Scene::placed, or -1 if the body
// stayed part of the building.
Scene with_bodies_apart(Scene world, std::size_t most_things, std::vector<int>& thing_of_body);
// Returns a copy of a world without the placed object of that name. Fails with a sentence if there is no such object.
Result<Scene> without_placed(const Scene& world, const std::string& name);
// Returns the world box around `own`, a box in an object's own frame, for an object placed at `at`.
Aabb placed_bounds(const Aabb& own, const Placement& at);
// Moves the placed object with the index `thing` in Scene::placed, and updates its bounds and drawn surfaces.
void move_placed(Scene& world, std::size_t thing, const Placement& at);
// Returns the index in Scene::placed of the placed object of that name, or -1 if there is none. Ignores case.
int find_placed(const Scene& world, const std::string& name);

}  // namespace handrail
