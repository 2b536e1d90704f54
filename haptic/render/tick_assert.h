// What the servo tick promises to itself. Looked at in the preset debug alone, where a broken promise names its place
// on stderr and ends the program; elsewhere the condition is not even computed, and the rules of the tick hold: on any
// doubt the hand gets zero force.
#pragma once

#include "worlds/base/contract.h"

#ifdef HANDRAIL_TICK_ASSERT
#define tick_assert(condition) contract_pre(condition)
#else
#define tick_assert(condition) static_cast<void>(0)
#endif
