// A device that takes and gives bytes in small packets, plus a few numbered requests. This is what a driver needs of
// USB, and what an emulator can replace. One thread at a time. Private to haptic/drivers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handrail::drivers {

class ByteLink {
public:
    static constexpr int kLost = -1;  // the device is gone, or another owner has it; permanent

    virtual ~ByteLink() = default;
    // Sends one vendor request without data. Returns false if it was refused or the device is gone.
    virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
    // Returns the number of bytes accepted: all, or fewer if the time ran out, or kLost.
    virtual int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept = 0;
    // Reads one packet as the bus carried it. Returns its size; 0 if none came in time; or kLost. `room` must hold at
    // least one packet.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
};

}  // namespace handrail::drivers
