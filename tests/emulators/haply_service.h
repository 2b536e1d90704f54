// The Inverse3's service, played by a server on this computer that answers each message with one state, as the public
// documentation of the service 3.5 has it. A thread of its own; one connection. Its WebSocket stands in
// haply_service.cpp alone, since Boost.Beast costs a compiler ten seconds.
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
    // Port 0: any that is free. Throws where the port is taken.
    explicit StandInService(bool with_device = true, std::uint16_t port = 0);
    ~StandInService();
    StandInService(const StandInService&) = delete;
    StandInService& operator=(const StandInService&) = delete;

    std::uint16_t port() const;

    std::atomic<Mood> mood{Mood::Sound};
    std::atomic<int> messages{0}, not_understood{0};
    // Under the lock: the hand, 0.1 kg and 8 Ns/m, a millisecond for each message.
    std::mutex lock;
    Vec3 place{0.0}, velocity{0.0}, push{0.0}, force{0.0};
    double largest = 0.0;

private:
    struct Server;
    std::unique_ptr<Server> server_;
};

// A port at which nobody listens.
std::uint16_t port_of_nobody();

}  // namespace handrail::test
