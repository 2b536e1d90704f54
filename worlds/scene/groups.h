// Groups of solids as the author of the world made them in an editor: what belongs to them, and what the hand feels of
// them. Pure functions; any thread may call them.
#pragma once

#include <optional>

#include "worlds/scene/scene.h"

namespace handrail {

// Returns true if the solid is in this group, or in a group inside it.
bool is_in_group(const Scene& scene, const Solid& solid, std::uint32_t group);
// Returns true if the solid is in a hidden group, or in a group inside one.
bool is_hidden(const Scene& scene, const Solid& solid);
// Returns how many solids are in this group, also as parts of placed things.
std::size_t solids_in_group(const Scene& scene, std::uint32_t group);

// Returns the scene as the hand feels it: the solids of hidden groups are illusions, and the faces that they covered
// are open. Returns no value if no group is hidden, which costs nothing.
std::optional<Scene> without_hidden_groups(const Scene& scene);
// Makes everything in the group of this material, from the library.
void give_material_to_group(Scene& scene, std::uint32_t group, const MaterialSpec& spec);

}  // namespace handrail
