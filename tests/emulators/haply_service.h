// Emulates the service that drives an Inverse3. It is a server on this computer that answers each message with one
// state, as the public documentation of version 3.5 of the service says. It has its own thread and serves one
// connection. Only haply_service.cpp includes the WebSocket library, because Boost.Beast takes ten seconds to compile.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "worlds/base/vec.h"

namespace handrail::test {

enum class Mood { Sound, Damaged, Silent, NoPosition, Hangs_up, Uncalibrated };

class StandInService {
public:
    // If `port` is 0, the server takes any free port. Throws if the port is taken.
    explicit StandInService(bool with_device = true, std::uint16_t port = 0);
    ~StandInService();
    StandInService(const StandInService&) = delete;
    StandInService& operator=(const StandInService&) = delete;

    std::uint16_t port() const;

    std::atomic<Mood> mood{Mood::Sound};
    std::atomic<int> messages{0}, not_understood{0};
    // The simulated hand, guarded by `lock`. It has a mass of 0.1 kg and a damping of 8 Ns/m, and moves for a
    // millisecond with each message.
    std::mutex lock;
    Vec3 place{0.0}, velocity{0.0}, push{0.0}, force{0.0};
    double largest = 0.0;

private:
    struct Server;
    std::unique_ptr<Server> server_;
};

// Returns a port on which nobody listens.
std::uint16_t port_of_nobody();

}  // namespace handrail::test
