#include "worlds/confine/confine.h"

#include <sys/prctl.h>

#include "worlds/base/language.h"
#include "worlds/confine/parts.h"

namespace handrail {

Confinement confinement_offered() { return {seccomp_is_offered(), landlock_version()}; }

// Landlock first: the filter refuses its system calls.
Confinement confine(const Permissions& permissions) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {};
    Confinement active;
    active.landlock = bound_files(permissions);
    active.seccomp = bound_system_calls(permissions);
    return active;
}

std::string confinement_sentence(const Confinement& offered) {
    if (offered.seccomp && offered.landlock > 0) return phrase("confine.both");
    if (offered.seccomp) return phrase("confine.seccomp_only");
    return phrase(offered.landlock > 0 ? "confine.landlock_only" : "confine.none");
}

}  // namespace handrail
