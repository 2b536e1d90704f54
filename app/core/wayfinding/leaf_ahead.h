// The leaf of a door that stands open across a path, to be shut before you go on. Function of what the context holds:
// one trace of the body for each stretch of the path; app thread. World metres.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/world/walker.h"
#include "app/core/world/world_state.h"

namespace handrail {

// The door, a place in Scene::movers, whose leaf a body meets that walks straight from each place of the path to the
// next, soles; none: it meets none, or nobody shuts it by hand, or the path leads through that door itself and comes to
// the doorway before it meets the leaf's face.
std::optional<std::uint32_t> leaf_across(const WorldState& world, const BodySize& size, std::span<const Vec3> path_m);
// What it is called; empty: none.
std::string leaf_ahead(const SessionContext& context, std::span<const Vec3> path_m);

}  // namespace handrail
