// Confines a process that handles other people's data: seccomp restricts its system calls, Landlock the files and TCP
// ports that it can reach. A process calls `confine` once, before it reads any such data and while it has a single
// thread; it cannot be undone. Costs less than a millisecond, and then some tens of nanoseconds for each system call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::confine {

// What the kernel supports, or what is active.
struct Confinement {
    bool seccomp = false;
    int landlock = 0;  // version of the kernel's Landlock interface; 0 if there is none
    bool operator==(const Confinement&) const = default;
};

enum class Calls {
    Compute,  // allows memory, threads, and reading and writing open files; exec, sockets and ptrace end the process
    Drive,    // refuses exec, access to other processes, sockets that are not permitted, and ways around Landlock
};

// What a confined process may still do. Paths that do not exist are ignored.
struct Permissions {
    Calls calls = Calls::Compute;
    std::vector<std::filesystem::path> read, read_and_write;  // files, or folders with everything in them
    bool device_events = false;                               // netlink messages of the kernel about plugged devices
    std::vector<std::uint16_t> tcp_ports;                     // ports to connect to
    bool any_internet = false;                                // all protocols of IPv4 and IPv6
    bool unix_sockets = false;                                // also sockets with a path in a writable folder
};

Confinement confinement_offered();

// Applies everything that the kernel supports, and returns what is active. Afterwards the process cannot gain
// privileges.
Confinement confine(const Permissions& permissions);

// Returns the environment for a process that will be confined. It has only the named variables of this process
// ("PREFIX_*" means all that begin so), because the others contain keys and addresses of other programs. A build with a
// sanitizer also keeps that sanitizer's options. The result is for posix_spawn and points into environ, so it is valid
// until the environment changes.
std::vector<char*> environment_with(std::span<const std::string_view> names);

// One sentence for the person: what confines the file reader and the device guards, and what is missing.
std::string confinement_sentence(const Confinement& offered);

}  // namespace handrail::confine
