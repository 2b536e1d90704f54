// Shared by the tests of both guards: the program's end of the pipe to a guard, and a device behind real guards that is
// ticked as by a servo.
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

// Wakes whoever waits for that event.
inline void signal_event(int event) {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(event, &one, sizeof one);
}

// Both ends of a guard's messages; the first is the program's.
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
    // Closes the program's end, as happens when it dies.
    void leave() {
        if (ends[0] >= 0) ::close(std::exchange(ends[0], -1));
    }
};

// Ticks it like a servo until the condition is true.
template <class Condition>
bool tick_until(GuardedDevice& device, Condition&& condition) {
    return eventually([&] {
        const DeviceSample sample = device.read(0.0);
        device.write({{0.0, 2.0, 0.0}});
        return condition(sample);
    });
}

}  // namespace handrail::test
