// Filters system calls with libseccomp.
#include <fcntl.h>
#include <linux/netlink.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "worlds/confine/parts.h"

namespace handrail::confine {
namespace {

#if defined(HANDRAIL_SANITIZED)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

// Mask for an int argument, because the kernel reads only the lower half of it.
constexpr std::uint64_t kLowHalf = 0xFFFF'FFFF;
constexpr unsigned kMostFamilies = 64;  // number of socket families that are tested; Linux has fewer

struct FilterEnd {
    void operator()(void* filter) const { seccomp_release(filter); }
};

class Filter {
public:
    explicit Filter(std::uint32_t otherwise) : filter_(seccomp_init(otherwise)) { good_ = filter_ != nullptr; }

    template <class... Conditions>
    void rule(std::uint32_t action, int call, Conditions... conditions) {
        if (!good_) return;
        // A system call that does not exist on this processor needs no rule.
        const int status = seccomp_rule_add(filter_.get(), action, call, sizeof...(conditions), conditions...);
        good_ = status == 0 || status == -EDOM;
    }
    void rules(std::uint32_t action, std::initializer_list<int> calls) {
        for (const int call : calls) rule(action, call);
    }
    // Applies the filter to all threads of the process, because a sanitizer or a library may have started some.
    bool load() {
        return good_ && seccomp_attr_set(filter_.get(), SCMP_FLTATR_CTL_TSYNC, 1) == 0 &&
               seccomp_load(filter_.get()) == 0;
    }

private:
    std::unique_ptr<void, FilterEnd> filter_;
    bool good_ = false;
};

// Conditions on the argument at the position `place`: argument() compares the whole value, masked() only the bits of
// `mask`.
scmp_arg_cmp argument(unsigned place, scmp_compare how, std::uint64_t value) { return {place, how, value, 0}; }
scmp_arg_cmp masked(unsigned place, std::uint64_t mask, std::uint64_t value) {
    return {place, SCMP_CMP_MASKED_EQ, mask, value};
}

const std::uint32_t kRefuse = SCMP_ACT_ERRNO(EPERM);

// Calls that start programs. The file reader never starts programs, so if it tries to, an attacker controls it, and the
// kernel ends it. If the call were only refused, the attacker could continue, and Handrail would believe the answers.
const std::initializer_list<int> kStartPrograms{SCMP_SYS(execve), SCMP_SYS(execveat)};

// Calls that reach other processes or bypass Landlock. io_uring makes calls that no filter sees, and file handles open
// files without a path.
const std::initializer_list<int> kReachOut{
    SCMP_SYS(process_vm_readv),
    SCMP_SYS(process_vm_writev),
    SCMP_SYS(pidfd_open),
    SCMP_SYS(pidfd_getfd),
    SCMP_SYS(kcmp),
    SCMP_SYS(io_uring_setup),
    SCMP_SYS(io_uring_enter),
    SCMP_SYS(io_uring_register),
    SCMP_SYS(name_to_handle_at),
    SCMP_SYS(open_by_handle_at),
    SCMP_SYS(mount),
    SCMP_SYS(move_mount),
    SCMP_SYS(open_tree),
    SCMP_SYS(fsopen),
    SCMP_SYS(umount2),
    SCMP_SYS(pivot_root),
    SCMP_SYS(chroot),
    SCMP_SYS(unshare),
    SCMP_SYS(setns),
    SCMP_SYS(bpf),
    SCMP_SYS(perf_event_open),
    SCMP_SYS(userfaultfd),
    SCMP_SYS(add_key),
    SCMP_SYS(request_key),
    SCMP_SYS(keyctl),
    SCMP_SYS(init_module),
    SCMP_SYS(finit_module),
    SCMP_SYS(delete_module),
    SCMP_SYS(kexec_load),
    SCMP_SYS(kexec_file_load),
    SCMP_SYS(reboot),
    SCMP_SYS(swapon),
    SCMP_SYS(swapoff),
};

void refuse_what_reaches_out(Filter& filter) {
    filter.rules(kRefuse, kReachOut);
    for (const unsigned long what : {static_cast<unsigned long>(TIOCSTI), static_cast<unsigned long>(TIOCLINUX)})
        // These requests insert characters into the input of a terminal.
        filter.rule(kRefuse, SCMP_SYS(ioctl), masked(1, kLowHalf, what));
    if (kSanitized) return;  // the leak detection of a sanitizer uses the calls below to stop its own process
    filter.rule(kRefuse, SCMP_SYS(ptrace));
    const auto self = static_cast<std::uint64_t>(::getpid());
    for (const int call : {SCMP_SYS(kill), SCMP_SYS(tgkill), SCMP_SYS(rt_sigqueueinfo), SCMP_SYS(rt_tgsigqueueinfo)})
        filter.rule(kRefuse, call, argument(0, SCMP_CMP_NE, self));
    filter.rule(kRefuse, SCMP_SYS(tkill));
}

bool is_permitted(const Permissions& permissions, unsigned family) {
    const bool internet = permissions.any_internet || !permissions.tcp_ports.empty();
    return (family == AF_NETLINK && permissions.device_events) || (family == AF_UNIX && permissions.unix_sockets) ||
           ((family == AF_INET || family == AF_INET6) && internet);
}

// Refuses sockets without ending the process, because libraries look for services, such as the system log, and can do
// without them. If the filter ended the process because of a manufacturer's library, the second guard would have to
// control the force on the hand.
void refuse_sockets(Filter& filter, const Permissions& permissions) {
    for (unsigned family = 0; family < kMostFamilies; ++family)
        if (!is_permitted(permissions, family))
            filter.rule(kRefuse, SCMP_SYS(socket), argument(0, SCMP_CMP_EQ, std::uint64_t{family}));
    filter.rule(kRefuse, SCMP_SYS(socket), argument(0, SCMP_CMP_GE, std::uint64_t{kMostFamilies}));
    if (permissions.device_events)
        filter.rule(kRefuse, SCMP_SYS(socket), argument(0, SCMP_CMP_EQ, std::uint64_t{AF_NETLINK}),
                    argument(2, SCMP_CMP_NE, std::uint64_t{NETLINK_KOBJECT_UEVENT}));
    if (permissions.any_internet || permissions.tcp_ports.empty()) return;
    // Stream sockets only, because Landlock can restrict only the ports of TCP.
    for (const int family : {AF_INET, AF_INET6})
        for (const int type : {SOCK_DGRAM, SOCK_RAW, SOCK_SEQPACKET, SOCK_DCCP})
            filter.rule(kRefuse, SCMP_SYS(socket), argument(0, SCMP_CMP_EQ, static_cast<std::uint64_t>(family)),
                        masked(1, std::uint64_t{0xF}, static_cast<std::uint64_t>(type)));
}

void permit_computing(Filter& filter) {
    const std::uint32_t allow = SCMP_ACT_ALLOW;
    filter.rules(allow, {SCMP_SYS(read),
                         SCMP_SYS(readv),
                         SCMP_SYS(pread64),
                         SCMP_SYS(write),
                         SCMP_SYS(writev),
                         SCMP_SYS(lseek),
                         SCMP_SYS(close),
                         SCMP_SYS(fstat),
                         SCMP_SYS(poll),
                         SCMP_SYS(ppoll),
                         SCMP_SYS(recvmsg),
                         SCMP_SYS(sendmsg),
                         SCMP_SYS(recvfrom),
                         SCMP_SYS(sendto),
                         SCMP_SYS(mmap),
                         SCMP_SYS(munmap),
                         SCMP_SYS(mremap),
                         SCMP_SYS(mprotect),
                         SCMP_SYS(madvise),
                         SCMP_SYS(brk),
                         SCMP_SYS(futex),
                         SCMP_SYS(rt_sigaction),
                         SCMP_SYS(rt_sigprocmask),
                         SCMP_SYS(rt_sigreturn),
                         SCMP_SYS(sigaltstack),
                         SCMP_SYS(set_robust_list),
                         SCMP_SYS(rseq),
                         SCMP_SYS(sched_yield),
                         SCMP_SYS(sched_getaffinity),
                         SCMP_SYS(getpid),
                         SCMP_SYS(gettid),
                         SCMP_SYS(getrandom),
                         SCMP_SYS(clock_gettime),
                         SCMP_SYS(clock_nanosleep),
                         SCMP_SYS(nanosleep),
                         SCMP_SYS(gettimeofday),
                         SCMP_SYS(getrusage),
                         SCMP_SYS(sysinfo),
                         SCMP_SYS(restart_syscall),
                         SCMP_SYS(exit),
                         SCMP_SYS(exit_group)});
    // The C library of Debian 12 uses this call to get the size of an open file.
    filter.rule(allow, SCMP_SYS(newfstatat), masked(3, std::uint64_t{AT_EMPTY_PATH}, std::uint64_t{AT_EMPTY_PATH}));
    // Allows new threads, but no new processes. clone3 passes its flags in memory, where a filter cannot read them. If
    // the kernel says that clone3 does not exist, the C library uses clone.
    filter.rule(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));
    filter.rule(allow, SCMP_SYS(clone), masked(0, std::uint64_t{CLONE_THREAD}, std::uint64_t{CLONE_THREAD}));
    // abort() needs this call.
    filter.rule(allow, SCMP_SYS(tgkill), argument(0, SCMP_CMP_EQ, static_cast<std::uint64_t>(::getpid())));
    // Allows this call only for reading limits, such as that of the stack.
    filter.rule(allow, SCMP_SYS(prlimit64), argument(2, SCMP_CMP_EQ, std::uint64_t{0}));
}

// Sanitizers need further system calls. So in a build with a sanitizer, the filter refuses only the listed harmful
// calls, and Landlock alone restricts files.
bool bound_to_computing() {
    Filter filter(kSanitized ? SCMP_ACT_ALLOW : kRefuse);
    if (kSanitized) refuse_what_reaches_out(filter);
    else permit_computing(filter);
    filter.rules(SCMP_ACT_KILL_PROCESS, kStartPrograms);
    filter.rules(SCMP_ACT_KILL_PROCESS, {SCMP_SYS(socket), SCMP_SYS(connect)});
    if (!kSanitized) filter.rule(SCMP_ACT_KILL_PROCESS, SCMP_SYS(ptrace));
    return filter.load();
}

bool bound_to_driving(const Permissions& permissions) {
    Filter filter(SCMP_ACT_ALLOW);
    refuse_what_reaches_out(filter);
    filter.rules(kRefuse, kStartPrograms);
    refuse_sockets(filter, permissions);
    return filter.load();
}

}  // namespace

bool seccomp_is_offered() {
    constexpr unsigned kIsActionOffered = 2;  // the value of SECCOMP_GET_ACTION_AVAIL
    const std::uint32_t action = SCMP_ACT_KILL_PROCESS;
    return ::syscall(SYS_seccomp, kIsActionOffered, 0, &action) == 0;
}

bool bound_system_calls(const Permissions& permissions) {
    return permissions.calls == Calls::Compute ? bound_to_computing() : bound_to_driving(permissions);
}

}  // namespace handrail::confine
