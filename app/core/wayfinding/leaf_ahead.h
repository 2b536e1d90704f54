// Finds an open door leaf across a path. The person must shut the door before they can continue. Functions of the
// context, for the app thread. Each stretch of the path costs one trace of the walker's shape. Lengths are in world
// metres.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/world/walker.h"
#include "app/core/world/world_state.h"

namespace handrail::core {

// Returns the door whose leaf blocks a walker on the straight stretches of the path, as an index in Scene::movers. The
// path is at floor level. Returns no value if there is no such leaf or a person does not shut that door by hand. Also
// returns no value if the path leads through that door and reaches the doorway before the face of the leaf.
std::optional<std::uint32_t> leaf_across(const WorldState& world, const WalkerSize& size, std::span<const Vec3> path_m);
// Returns the door that leaf_across() finds for the walker, or kNoFeature.
FeatureId leaf_ahead(const SessionContext& context, std::span<const Vec3> path_m);
// Returns the name of such a door for directions; empty for kNoFeature.
std::string leaf_name(const SessionContext& context, FeatureId door);

}  // namespace handrail::core
