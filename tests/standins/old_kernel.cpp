// Runs a program as if the kernel had neither seccomp nor Landlock. Usage: standin_old_kernel PROGRAM ARGUMENT...
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <initializer_list>

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    const std::uint32_t missing = SCMP_ACT_ERRNO(ENOSYS);
    for (const int call : {SCMP_SYS(seccomp), SCMP_SYS(landlock_create_ruleset)})
        if (seccomp_rule_add(filter, missing, call, 0) != 0) return 2;
    if (seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1,
                         scmp_arg_cmp{0, SCMP_CMP_EQ, PR_SET_SECCOMP, 0}) != 0)
        return 2;
    if (seccomp_load(filter) != 0) return 2;
    ::execv(argv[1], argv + 1);
    return 2;
}
