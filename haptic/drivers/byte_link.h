// A device that exchanges bytes in small packets and obeys a few numbered requests. Drivers use this interface for USB
// devices; an emulator can implement it, too. One thread at a time. Private to haptic/drivers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handrail::drivers {

class ByteLink {
public:
    static constexpr int kLost = -1;  // result for a device that is gone or that another program has opened; permanent

    virtual ~ByteLink() = default;
    // Sends one vendor request without data. Returns false if it was refused or the device is gone.
    virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
    // Returns the number of bytes that the device accepted: all, or fewer if the time ran out, or kLost.
    virtual int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept = 0;
    // Reads one packet exactly as the bus carried it. Returns its size, 0 if none came in time, or kLost. `room` must
    // have space for at least one packet.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
};

}  // namespace handrail::drivers
