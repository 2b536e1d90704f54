// The list of what was understood of a world's file, and of what to check there. App thread only.
#pragma once

#include <functional>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/stops.h"

namespace handrail::core {

// on_choose: called if a place to check was chosen, to find it or go to it; kept while the list is open. For a world
// whose file states no rooms, one sentence replaces the counts.
void open_understood(const SessionContext& context, std::function<void(const Goal& goal, double now_s)> on_choose,
                     double now_s);

}  // namespace handrail::core
