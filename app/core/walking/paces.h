// Counts the steps that the person requested and the steps that the walker made: how many remain, and what is announced
// when they are done or blocked. Functions and plain state for the app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/world/walker_world.h"

namespace handrail::core {

// Returns the remaining distance once `times` more steps are requested. After fast taps, at most eight steps wait, so
// that the walker does not continue for long. A typed count is walked in full.
double more_to_go_m(double left_m, double step_m, int times);

// Returns what the walker met: "north wall, plaster". If that is not straight ahead, adds the side: "Door, shut, left
// shoulder", "north wall, behind". `way_rad` is the direction of the walk. The text is empty at verbosity 0.
std::string met_words(const SessionContext& context, const TraceHit& met, double way_rad);

// Counts the distance walked since the walker last stood still, in whole steps.
class Paces {
public:
    void begin() { walked_m_ = 0.0; }
    void walked(double way_m) { walked_m_ += way_m; }
    // Returns "6 steps", or an empty text if there was no step, and starts counting again.
    std::string take(const SessionContext& context);
    // Returns the announcement at an obstacle, and starts counting again. For a person who types, the announcement is
    // "6 steps, then north wall", or "Blocked. North wall" if there was no step. For a person who uses keys in a
    // window, it is only what was met, because the steps are audible.
    std::string take_blocked(const SessionContext& context, const std::string& met);

private:
    double walked_m_ = 0.0;
};

// Returns "Blocked. North wall, plaster".
std::string blocked_words(const std::string& met);
// Returns true if the person types commands, so that the number of steps is announced.
bool announces_steps(const SessionContext& context);

}  // namespace handrail::core
