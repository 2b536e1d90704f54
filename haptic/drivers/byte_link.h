// A device that takes and gives bytes in small packets, with a few numbered requests beside them: what a driver needs
// of USB, and what an emulator can stand in for. One thread at a time. Private to haptic/drivers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handrail {

class ByteLink {
public:
    static constexpr int kLost = -1;  // the device is gone, or no longer ours; it stays so

    virtual ~ByteLink() = default;
    // One vendor request without data. False when it was refused or the device is gone.
    virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
    // Bytes taken, at most all; fewer when the time ran out; kLost.
    virtual int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept = 0;
    // The bytes of one packet as the bus carried it; 0 when none came in time; kLost. `room` holds at least one packet.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
};

}  // namespace handrail
