// The leaf of a door that stands open across a stretch of a way, to be shut before one goes on. Function of what the
// context holds: one trace of the body; app thread. World metres.
#pragma once

#include <string>

#include "app/core/context/session_context.h"

namespace handrail {

// What the door is called whose leaf a body meets that walks straight from one place to the other, soles; empty: it
// meets none, or nobody shuts it by hand, or the stretch leads through that door itself.
std::string leaf_ahead(const SessionContext& context, const Vec3& from_m, const Vec3& to_m);

}  // namespace handrail
