// Steps that are asked for and steps that were made: how many are still to go, what is said of those that are done, and
// what a blocked one is answered with. Functions, and plain state; app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/world/body_world.h"

namespace handrail {

// What is still to go once `times` steps more are asked for. Of keys that are tapped fast at most eight steps wait, so
// that nobody runs on for long; a count is walked as far as it says.
double more_to_go_m(double left_m, double step_m, int times);

// "north wall, plaster", "Door, shut, left shoulder", "north wall, behind": what was met and, where it is not straight
// ahead, on which side. way_rad: where the body was going. Empty at verbosity 0.
std::string met_words(const SessionContext& context, const TraceHit& met, double way_rad);

// What was walked since the body stood still last, in whole steps.
class Paces {
public:
    void begin() { walked_m_ = 0.0; }
    void walked(double way_m) { walked_m_ += way_m; }
    // "6 steps"; empty where it was none. Begins anew.
    std::string take(const SessionContext& context);
    // Of keys that act in words, "6 steps, then north wall", or "Blocked. North wall" where there was no step; of the
    // keys of a window what was met alone, as its steps are heard. Begins anew.
    std::string take_blocked(const SessionContext& context, const std::string& met);

private:
    double walked_m_ = 0.0;
};

// "Blocked. North wall, plaster".
std::string blocked_words(const std::string& met);
// Whoever types is told each step in words.
bool tells_steps(const SessionContext& context);

}  // namespace handrail
