// Defines the interface to a device that exchanges bytes in small packets and obeys a few numbered requests. Drivers
// use ByteLink for USB devices; an emulator can implement it, too. One thread at a time. Private to haptic/drivers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handrail::drivers {

class ByteLink {
public:
    // Result of a call if the device is gone or another program has opened it. All later calls return it as well.
    static constexpr int kLost = -1;

    virtual ~ByteLink() = default;
    // Sends one vendor request without data. Returns false if the device refused the request or is gone.
    virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
    // Sends bytes. Returns how many the device accepted: all, or fewer if the time ran out, or kLost.
    virtual int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept = 0;
    // Reads one packet exactly as the bus carried it. Returns the packet's size, 0 if none came in time, or kLost.
    // `room` must have space for at least one packet.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
};

}  // namespace handrail::drivers
