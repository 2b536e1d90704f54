// Checks an invariant of the servo tick in the presets debug, asan and tsan. If the check fails, it prints file and
// line on standard error and ends the program. In all other builds the condition is not even computed; other checks
// then give the hand zero force if something is wrong.
#pragma once

#include "worlds/base/contract.h"

#ifdef HANDRAIL_TICK_ASSERT
#define tick_assert(condition) contract_pre(condition)
#else
#define tick_assert(condition) static_cast<void>(0)
#endif
