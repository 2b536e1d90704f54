// Lists what the reader understood of a world's file, and the places that somebody should check. Call it on the app
// thread only.
#pragma once

#include <functional>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/stops.h"

namespace handrail::core {

// Opens the list. `on_choose` is called when the person has chosen a place to check, to find it or go to it. The open
// list keeps a copy of `on_choose`. If the world's file states no rooms, one sentence replaces the numbers of rooms and
// other parts.
void open_understood(const SessionContext& context, std::function<void(const Goal& goal, double now_s)> on_choose,
                     double now_s);

}  // namespace handrail::core
