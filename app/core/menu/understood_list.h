// The list of what was understood of a world's file, and of what is to be checked there. App thread only.
#pragma once

#include <functional>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/stops.h"

namespace handrail {

// on_choose: a place that is to be checked was chosen, to be found or gone to; kept as long as the list is open. A
// world whose file states no rooms gets one sentence in place of counts.
void open_understood(const SessionContext& context, std::function<void(const Goal& goal, double now_s)> on_choose,
                     double now_s);

}  // namespace handrail
