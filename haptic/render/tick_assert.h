// Checks an invariant of the servo tick in the presets debug, asan and tsan: a failure prints its place on standard
// error and ends the program. In all other builds the condition is not even computed, and if anything is wrong, the
// hand gets zero force.
#pragma once

#include "worlds/base/contract.h"

#ifdef HANDRAIL_TICK_ASSERT
#define tick_assert(condition) contract_pre(condition)
#else
#define tick_assert(condition) static_cast<void>(0)
#endif
