// Finds an open door leaf across a path, which must be shut before the person can go on. Functions of what the context
// contains: one trace of the body for each stretch of the path; app thread. World metres.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/world/walker.h"
#include "app/core/world/world_state.h"

namespace handrail::core {

// The door, an index in Scene::movers, whose leaf blocks a walker on the straight stretches of the path, at floor
// level. No value if none does, if the door is not shut by hand, or if the path leads through that door and reaches the
// doorway before the leaf's face.
std::optional<std::uint32_t> leaf_across(const WorldState& world, const WalkerSize& size, std::span<const Vec3> path_m);
// Its name; empty: none.
std::string leaf_ahead(const SessionContext& context, std::span<const Vec3> path_m);

}  // namespace handrail::core
