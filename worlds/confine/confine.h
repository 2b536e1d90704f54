// Confines a process that handles data of other people. seccomp restricts its system calls; Landlock restricts the
// files and TCP ports that it can reach. The process calls `confine` once, before it reads any such data and while it
// has a single thread. The call cannot be undone. It costs less than a millisecond, and afterwards some tens of
// nanoseconds for each system call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::confine {

// The protections that the kernel supports, or those that are active in a process.
struct Confinement {
    bool seccomp = false;
    int landlock = 0;  // version of the kernel's Landlock interface; 0 if the kernel has none
    bool operator==(const Confinement&) const = default;
};

enum class Calls {
    // For the file reader: allows memory, threads, and reading and writing open files; exec, sockets and ptrace end the
    // process.
    Compute,
    // For the device guards: refuses exec, access to other processes, sockets that are not permitted, and calls that
    // bypass Landlock.
    Drive,
};

// The accesses that a confined process keeps. Paths that do not exist are ignored.
struct Permissions {
    Calls calls = Calls::Compute;
    std::vector<std::filesystem::path> read, read_and_write;  // files, or folders with everything in them
    bool device_events = false;            // may receive the kernel's netlink messages about plugged devices
    std::vector<std::uint16_t> tcp_ports;  // TCP ports that the process may connect to
    bool any_internet = false;             // may use all protocols of IPv4 and IPv6
    bool unix_sockets = false;             // may use Unix sockets, including those with a path in a writable folder
};

Confinement confinement_offered();

// Applies all restrictions that the kernel supports, and returns which are active. Afterwards the process cannot gain
// privileges.
Confinement confine(const Permissions& permissions);

// Returns the environment for a process that will be confined. It contains only the named variables of this process;
// "PREFIX_*" names all variables that begin with "PREFIX_". The other variables are left out because they may contain
// keys and addresses of other programs. A build with a sanitizer also keeps the options of that sanitizer. The result
// is for posix_spawn. It points into environ, so it is valid until the environment changes.
std::vector<char*> environment_with(std::span<const std::string_view> names);

// Returns one sentence for the person: what confines the file reader and the device guards, and which protection is
// missing.
std::string confinement_sentence(const Confinement& offered);

}  // namespace handrail::confine
