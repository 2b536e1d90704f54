// Declares the two parts of `confine`: one restricts system calls, the other files and TCP ports. Private to this
// folder.
#pragma once

#include "worlds/confine/confine.h"

namespace handrail::confine {

// Both functions need PR_SET_NO_NEW_PRIVS.
bool bound_system_calls(const Permissions& permissions);  // returns true if the filter is active
int bound_files(const Permissions& permissions);          // returns the active version of Landlock; 0 if none is active

bool seccomp_is_offered();
int landlock_version();

}  // namespace handrail::confine
