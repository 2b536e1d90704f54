// Scenes of a single thing, built in code: what can be set down in a world while it runs. Pure functions; any thread.
#pragma once

#include <memory>
#include <string>

#include "worlds/base/result.h"
#include "worlds/scene/primitive.h"
#include "worlds/scene/scene.h"

namespace handrail {

// One exact shape, as one solid. Fails, with a sentence, where make_solid does.
Result<std::shared_ptr<const Scene>> primitive_model(const Primitive& primitive);
// A box of this size in metres around its frame's zero.
Result<std::shared_ptr<const Scene>> box_model(const Vec3& size_m);

// A copy of a world with one thing more. The name is what it is called when touched; a name that is taken, an empty
// model, or a placement that is not finite or has no size fails with a sentence. material: of the library, or empty for
// the default wall; an unknown one names the nearest.
Result<Scene> with_placed(const Scene& world, const std::string& name, std::shared_ptr<const Scene> model,
                          const Placement& at, const std::string& material);
// Takes the movers out of the building and sets each down as a thing of its own, with zero of its frame at its pivot,
// so that it can be moved while it is touched. At most `most_things` things stand in the world afterwards; movers
// beyond that stay part of the building. The place of each mover in Scene::placed, -1 for one that stayed.
Scene with_movers_apart(const Scene& world, std::size_t most_things, std::vector<int>& thing_of_mover);
// Likewise what is free to move (Scene::bodies), with zero of each frame in the middle of its box. The place of each in
// Scene::placed, -1 for one that stayed part of the building.
Scene with_bodies_apart(Scene world, std::size_t most_things, std::vector<int>& thing_of_body);
// A copy of a world without the placed thing of that name, or a sentence that there is none.
Result<Scene> without_placed(const Scene& world, const std::string& name);
// The box around a box of a thing's own frame, as it stands there.
Aabb placed_bounds(const Aabb& own, const Placement& at);
// The thing of that number in Scene::placed stands elsewhere: its bounds and what is drawn of it follow.
void move_placed(Scene& world, std::size_t thing, const Placement& at);
// The place of the placed thing of that name in Scene::placed; -1 for none. Case-insensitive.
int find_placed(const Scene& world, const std::string& name);

}  // namespace handrail
