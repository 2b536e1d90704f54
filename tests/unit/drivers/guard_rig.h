// Provides what the tests of both guards share: the program's end of the connection to a guard, and a servo-like loop
// for a device behind real guards.
#pragma once

#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <utility>

#include "haptic/drivers/guarded_device.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail::test {

// Wakes the thread or process that waits for `event`.
inline void signal_event(int event) {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(event, &one, sizeof one);
}

// Both ends of the connection that carries a guard's messages. The first end is the program's.
struct GuardEnds {
    std::array<int, 2> ends{-1, -1};

    GuardEnds() { ::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()); }
    ~GuardEnds() {
        leave();
        ::close(ends[1]);
    }
    GuardEnds(const GuardEnds&) = delete;
    GuardEnds& operator=(const GuardEnds&) = delete;

    int guards() const { return ends[1]; }
    std::string message() const {
        std::array<char, 256> bytes{};
        const auto size = ::recv(ends[0], bytes.data(), bytes.size(), 0);
        return size > 0 ? std::string(bytes.begin(), bytes.begin() + size) : std::string();
    }
    // Closes the program's end, as the kernel does when the program dies.
    void leave() {
        if (ends[0] >= 0) ::close(std::exchange(ends[0], -1));
    }
};

// Reads and writes the device as the servo does until the condition is true.
template <class Condition>
bool tick_until(GuardedDevice& device, Condition&& condition) {
    return eventually([&] {
        const DeviceSample sample = device.read(0.0);
        device.write({{0.0, 2.0, 0.0}});
        return condition(sample);
    });
}

}  // namespace handrail::test
