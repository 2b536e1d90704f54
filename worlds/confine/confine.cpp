#include "worlds/confine/confine.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/confine/parts.h"

extern "C" char** environ;

namespace handrail::confine {

Confinement confinement_offered() { return {seccomp_is_offered(), landlock_version()}; }

// Landlock comes first, because the seccomp filter refuses the system calls of Landlock.
Confinement confine(const Permissions& permissions) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {};
    Confinement active;
    active.landlock = bound_files(permissions);
    active.seccomp = bound_system_calls(permissions);
    return active;
}

std::vector<char*> environment_with(std::span<const std::string_view> names) {
    const auto is_named = [&](std::string_view variable) {
        const std::string_view own = variable.substr(0, variable.find('='));
#if defined(HANDRAIL_SANITIZED)
        if (own.ends_with("SAN_OPTIONS")) return true;
#endif
        return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
            return name.ends_with('*') ? own.starts_with(name.substr(0, name.size() - 1)) : own == name;
        });
    };
    std::vector<char*> variables;
    for (char** variable = environ; *variable; ++variable)
        if (is_named(*variable)) variables.push_back(*variable);
    variables.push_back(nullptr);
    return variables;
}

std::string confinement_sentence(const Confinement& offered) {
    if (offered.seccomp && offered.landlock > 0) return phrase("confine.both");
    if (offered.seccomp) return phrase("confine.seccomp_only");
    return phrase(offered.landlock > 0 ? "confine.landlock_only" : "confine.none");
}

}  // namespace handrail::confine
