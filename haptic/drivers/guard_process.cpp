#include "haptic/drivers/guard_process.h"

#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
extern "C" {  // declared here because glibc 2.36's headers lack it
#include <sys/pidfd.h>
}

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guard_permissions.h"
#include "haptic/drivers/hand_guard.h"
#include "haptic/drivers/relief_guard.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

constexpr int kGuardPriority = 71;   // real-time priority just above the servo thread, which waits for the guard
constexpr int kReliefPriority = 72;  // real-time priority of the second guard, above the first guard, which it watches
// Longest single attempt to remove the force. It is longer than a device takes to open.
constexpr unsigned kMostOfOneTryS = 40;
constexpr rlim_t kMostDescriptors = 256;
constexpr rlim_t kMostFileBytes = rlim_t{16} << 20;
constexpr rlim_t kMostMemoryBytes = rlim_t{1} << 30;
// Stack size of each thread that a library starts. It is small, because all of a locked stack occupies memory.
constexpr std::size_t kStackBytes = std::size_t{1} << 20;
constexpr std::size_t kProbeBytes = std::size_t{32} << 20;
// Scores for /proc/self/oom_score_adj, which tells the kernel how readily to kill a process when memory runs out.
constexpr std::string_view kNever = "-1000", kLikeAnyOther = "0";

void lower_limit(__rlimit_resource what, rlim_t most) noexcept {
    rlimit limit{};
    if (::getrlimit(what, &limit) != 0) return;
    limit.rlim_cur = std::min(limit.rlim_cur, most);
    limit.rlim_max = std::min(limit.rlim_max, most);
    ::setrlimit(what, &limit);
}

#if defined(HANDRAIL_SANITIZED)
// A sanitizer reserves terabytes of address space, which can be neither limited nor locked.
constexpr bool kKeepsShadow = true;
#else
constexpr bool kKeepsShadow = false;
#endif

// Locks all current memory pages, and each later page when it is first used. Returns false if that is not permitted, or
// if the permitted amount is too low, because every allocation would then fail once the limit is reached.
bool lock_all_memory() noexcept {
    if (kKeepsShadow || ::mlockall(MCL_CURRENT) != 0) return false;
    if (::mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0) {
        void* probe = ::mmap(nullptr, kProbeBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (probe != MAP_FAILED) {
            ::munmap(probe, kProbeBytes);
            return true;
        }
    }
    ::munlockall();
    return false;
}

bool write_oom_score(std::string_view score) noexcept {
    const Descriptor file(::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
    return file.get() >= 0 && ::write(file.get(), score.data(), score.size()) == static_cast<ssize_t>(score.size());
}

// Asks the kernel not to kill this process when memory runs out. The kernel kills the process that frees the most
// memory. A guard frees little, but without it a force could remain on. Only administrators may set a score below zero,
// but every process may lower the raised score that desktops give their programs.
bool request_sparing() noexcept { return write_oom_score(kNever) || (write_oom_score(kLikeAnyOther), false); }

void protect(HandMailbox& mailbox, int priority) {
    lower_limit(RLIMIT_CORE, 0);
    lower_limit(RLIMIT_NOFILE, kMostDescriptors);
    lower_limit(RLIMIT_FSIZE, kMostFileBytes);
    if (!kKeepsShadow) lower_limit(RLIMIT_AS, kMostMemoryBytes);
    ::mallopt(M_ARENA_MAX, 1);
    pthread_attr_t threads;
    if (::pthread_attr_init(&threads) == 0) {
        if (::pthread_attr_setstacksize(&threads, kStackBytes) == 0) ::pthread_setattr_default_np(&threads);
        ::pthread_attr_destroy(&threads);
    }
    if (!lock_all_memory()) mailbox.memory_locked = false;
    if (!request_sparing()) mailbox.spared = false;
    sched_param scheduling{};
    scheduling.sched_priority = priority;
    // If the system refuses, the thread keeps ordinary scheduling, which is less punctual.
    ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &scheduling);
}

// Maps the mailbox. Returns null if the descriptor is not a mailbox, or if another process could shrink it while it is
// mapped.
HandMailbox* map_mailbox(int fd) noexcept {
    struct stat facts {};
    const int seals = ::fcntl(fd, F_GET_SEALS);
    if (seals < 0 || !(seals & F_SEAL_SHRINK)) return nullptr;
    if (::fstat(fd, &facts) != 0 || facts.st_size < static_cast<off_t>(sizeof(HandMailbox))) return nullptr;
    void* memory = ::mmap(nullptr, sizeof(HandMailbox), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (memory == MAP_FAILED) return nullptr;
    auto* mailbox = static_cast<HandMailbox*>(memory);
    return mailbox->mark == HandMailbox::kMailboxMark ? mailbox : nullptr;
}

}  // namespace

NamedDevices devices_of_this_machine(Clock& clock) {
    return {
        [&clock](const std::string& name, const std::string& serial,
                 const std::function<void(const std::string&)>& report) {
            return open_device(name, serial, clock, report);
        },
        [&clock](const std::string& name, const std::string& serial) { return zero_device(name, serial, clock); },
        [](const std::string& name) { return guard_permissions(name); },
    };
}

int guard_process(int argc, char** argv, const NamedDevices& devices) {
    const std::string_view role = argc > 1 ? argv[1] : "";
    if (argc < 8 || (role != kHoldRole && role != kRelieveRole)) {
        std::fprintf(stderr, "%s\n", phrase("guard.started_by_handrail").c_str());
        return 2;
    }
    for (const int number :
         {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU, SIGUSR1, SIGUSR2, SIGXFSZ})
        ::signal(number, SIG_IGN);
    ::setsid();  // starts a new session, because signals to the program's process group must not reach the guards
    // The guards must not keep the program's input and output open. A process that reads the program's output to its
    // end must wait only for the program.
    if (const Descriptor nowhere(::open("/dev/null", O_RDWR | O_CLOEXEC)); nowhere.get() > STDOUT_FILENO) {
        ::dup2(nowhere.get(), STDIN_FILENO);
        ::dup2(nowhere.get(), STDOUT_FILENO);
    }
    HandMailbox* mailbox = map_mailbox(std::atoi(argv[2]));
    if (!mailbox) return 2;
    const int life_fd = std::atoi(argv[3]), third_fd = std::atoi(argv[4]);
    // The program has already reported any fault in the language file. If the guard can no longer read the file, it
    // speaks English.
    (void)speak_language(argv[5], argv[6]);
    const std::string name = argv[7], serial = argc > 8 ? argv[8] : "";
    if (role == kRelieveRole) {
        protect(*mailbox, kReliefPriority);
        (void)confine::confine(devices.permissions(name));
        // If a driver does not return, the alarm ends this process.
        const auto zero_in_time = [&] {
            ::alarm(kMostOfOneTryS);
            auto zeroed = devices.zero(name, serial);
            ::alarm(0);
            return zeroed;
        };
        return relieve_guard(*mailbox, third_fd, life_fd, zero_in_time,
                             [third_fd] { ::pidfd_send_signal(third_fd, SIGKILL, nullptr, 0); });
    }
    protect(*mailbox, kGuardPriority);
    // The result is ignored, because `handrail devices` reports it if the kernel lacks a protection.
    (void)confine::confine(devices.permissions(name));
    return guard_hand(
        *mailbox, third_fd, life_fd,
        [&](const std::function<void(const std::string&)>& report) { return devices.open(name, serial, report); },
        [] { ::_exit(3); });
}

}  // namespace handrail::drivers
