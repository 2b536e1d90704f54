// The leaf of a door that stands open across a stretch of a way, to be shut before one goes on. Function of what the
// context holds: one trace of the body; app thread. World metres.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/world/walker.h"
#include "app/core/world/world_state.h"

namespace handrail {

// The door, a place in Scene::movers, whose leaf a body meets that walks straight from one place to the other, soles;
// none: it meets none, or nobody shuts it by hand, or the stretch leads through that door itself and comes to the
// doorway before it meets the leaf's face.
std::optional<std::uint32_t> leaf_across(const WorldState& world, const BodySize& size, const Vec3& from_m,
                                         const Vec3& to_m);
// What it is called; empty: none.
std::string leaf_ahead(const SessionContext& context, const Vec3& from_m, const Vec3& to_m);

}  // namespace handrail
