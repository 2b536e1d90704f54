// Confinement of a process that handles what others made: seccomp bounds its system calls, Landlock the files and TCP
// ports that it reaches. A process calls `confine` once, before it looks at anything foreign and while it has a single
// thread; there is no way back. Costs less than a millisecond, and some tens of nanoseconds for each system call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

// What the kernel offers, or what took effect.
struct Confinement {
    bool seccomp = false;
    int landlock = 0;  // the version of the kernel's interface; 0 if there is none
    bool operator==(const Confinement&) const = default;
};

enum class Calls {
    Compute,  // memory, threads, and reading and writing what is open; exec, sockets and ptrace end the process
    Drive,    // everything but exec, foreign processes, sockets that are not permitted, and ways around Landlock
};

// What a confined process keeps. Paths that do not exist are ignored.
struct Permissions {
    Calls calls = Calls::Compute;
    std::vector<std::filesystem::path> read, read_and_write;  // files, or folders with everything in them
    bool device_events = false;                               // the kernel's netlink messages on plugged devices
    std::vector<std::uint16_t> tcp_ports;                     // to connect to
    bool any_internet = false;                                // every protocol of IPv4 and IPv6
    bool unix_sockets = false;                                // also those named in folders that may be written
};

Confinement confinement_offered();

// Applies what the kernel offers, and returns what took effect. The process can gain no privileges afterwards.
Confinement confine(const Permissions& permissions);

// The environment for a process that will be confined: of this process's variables the named ones ("PREFIX_*": all that
// begin so), since in the others there are keys and addresses of other programs; in a build with a sanitizer that one's
// options too. As posix_spawn takes it, with pointers into environ: valid until somebody changes that.
std::vector<char*> environment_with(std::span<const std::string_view> names);

// One sentence for the person: what confines the reader of files and the guards of devices, and what is missing.
std::string confinement_sentence(const Confinement& offered);

}  // namespace handrail
