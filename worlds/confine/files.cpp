// Restricts the files and TCP ports of a process with Landlock. It calls Landlock's system calls directly, because the
// C library has no functions for them.
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>

#include "worlds/base/descriptor.h"
#include "worlds/confine/parts.h"

namespace handrail::confine {
namespace {

// The kernel's struct landlock_ruleset_attr. The <linux/landlock.h> of Debian 12 ends with version 2, so the newer
// members are declared here. An older kernel accepts a longer structure if the parts that it does not know are zero.
struct Ruleset {
    std::uint64_t files = 0, network = 0, scoped = 0;
};
struct PortRule {
    std::uint64_t allowed = 0, port = 0;
};
constexpr int kPortRule = 2;  // the value of LANDLOCK_RULE_NET_PORT
constexpr std::uint64_t kTruncate = 1ULL << 14, kIoctlOfDevices = 1ULL << 15;
constexpr std::uint64_t kBind = 1ULL << 0, kConnect = 1ULL << 1;
constexpr std::uint64_t kAbstractSockets = 1ULL << 0, kSignals = 1ULL << 1;

// Returns all access rights up to a version of Landlock. These rights are refused unless a rule grants them.
constexpr std::uint64_t kFirstRights = (1ULL << 13) - 1, kRefer = 1ULL << 13;
std::uint64_t rights_of(int version) {
    std::uint64_t rights = kFirstRights;
    if (version >= 2) rights |= kRefer;
    if (version >= 3) rights |= kTruncate;
    if (version >= 5) rights |= kIoctlOfDevices;
    return rights;
}

constexpr std::uint64_t kReading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kNamedSockets = LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_REMOVE_FILE;
constexpr std::uint64_t kWriting = kReading | LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate | kIoctlOfDevices;

Ruleset ruleset_for(const Permissions& permissions, int version) {
    Ruleset set;
    set.files = rights_of(version);
    if (version >= 4 && !permissions.any_internet) set.network = kBind | kConnect;
    if (version >= 6 && !permissions.unix_sockets) set.scoped |= kAbstractSockets;
    // Signals are not restricted for the device guards (Calls::Drive), because one guard must be able to end the other
    // when it hangs.
    if (version >= 6 && permissions.calls == Calls::Compute) set.scoped |= kSignals;
    return set;
}

bool permit(int ruleset, const std::filesystem::path& path, std::uint64_t rights) {
    // Calls the kernel directly, because umockdev would treat the C library's open() of a device folder as the opening
    // of a device.
    const Descriptor at(static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path.c_str(), O_PATH | O_CLOEXEC)));
    struct stat facts {};
    if (at.get() < 0 || ::fstat(at.get(), &facts) != 0) return true;  // a path that does not exist needs no rule
    if (!S_ISDIR(facts.st_mode)) rights &= ~(kNamedSockets | LANDLOCK_ACCESS_FS_READ_DIR);
    landlock_path_beneath_attr rule{};
    rule.allowed_access = rights;
    rule.parent_fd = at.get();
    return ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

bool permit_port(int ruleset, std::uint16_t port) {
    const PortRule rule{kConnect, port};
    return ::syscall(SYS_landlock_add_rule, ruleset, kPortRule, &rule, 0) == 0;
}

}  // namespace

int landlock_version() {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version > 0 ? static_cast<int>(version) : 0;
}

int bound_files(const Permissions& permissions) {
    const int version = landlock_version();
    if (version == 0) return 0;
    const Ruleset wanted = ruleset_for(permissions, version);
    const Descriptor set(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &wanted, sizeof wanted, 0)));
    if (set.get() < 0) return 0;
    bool complete = true;
    for (const std::filesystem::path& path : permissions.read)
        complete = permit(set.get(), path, kReading & wanted.files) && complete;
    const std::uint64_t writing = kWriting | (permissions.unix_sockets ? kNamedSockets : 0);
    for (const std::filesystem::path& path : permissions.read_and_write)
        complete = permit(set.get(), path, writing & wanted.files) && complete;
    if (wanted.network != 0)
        for (const std::uint16_t port : permissions.tcp_ports) complete = permit_port(set.get(), port) && complete;
    return complete && ::syscall(SYS_landlock_restrict_self, set.get(), 0) == 0 ? version : 0;
}

}  // namespace handrail::confine
