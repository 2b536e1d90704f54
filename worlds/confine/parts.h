// The two halves of `confine`. Private to this folder.
#pragma once

#include "worlds/confine/confine.h"

namespace handrail::confine {

// Both need PR_SET_NO_NEW_PRIVS.
bool bound_system_calls(const Permissions& permissions);  // true if the filter is active
int bound_files(const Permissions& permissions);          // the version that is active; 0 if none is

bool seccomp_is_offered();
int landlock_version();

}  // namespace handrail::confine
