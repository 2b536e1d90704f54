// Assertions for the servo tick. They are checked only in the preset debug, where a broken one prints its place on
// stderr and ends the program. Elsewhere the condition is not even computed, and the rules of the tick apply: in any
// doubt the hand gets zero force.
#pragma once

#include "worlds/base/contract.h"

#ifdef HANDRAIL_TICK_ASSERT
#define tick_assert(condition) contract_pre(condition)
#else
#define tick_assert(condition) static_cast<void>(0)
#endif
