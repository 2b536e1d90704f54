// Implements the wire protocol of the Novint Falcon: frames of 16 bytes in each direction, and the boot image that its
// processor needs after power-on. Pure functions and values, any thread; nothing allocates except the sentences about a
// rejected image. Source: what the open driver libnifalcon and its users published about the protocol. The image is
// TI's 8-bit boot table for the C28x.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail::drivers {

inline constexpr int kFalconMostCounts = 4095;  // greatest motor command, in either direction
inline constexpr std::size_t kFalconFrameBytes = 16;

struct FalconCommand {
    std::array<int, 3> motors{};  // motor counts, -4095 to 4095
    bool green = false, blue = false, red = false;
    bool homing = true;
};

struct FalconStatus {
    std::array<int, 3> encoders{};
    std::uint8_t buttons = 0;     // bit 0: plus, 1: forward, 2: centre, 3: minus
    std::uint8_t homed_legs = 0;  // bits 0 to 2, one for each leg
};

using FalconFrame = std::array<std::uint8_t, kFalconFrameBytes>;
// Packs a command into a frame. Motor values out of range are clamped, so that no value can wrap.
FalconFrame pack_falcon_command(const FalconCommand& command) noexcept;

// Converts thigh torques in Nm to motor counts. If a torque is not finite, all counts are zero. If a torque is too
// large, all three are reduced by the same factor, so that the direction of the force stays. Counts are rounded towards
// zero.
std::array<int, 3> falcon_motor_counts(const Vec3& torques_nm, double counts_per_nm) noexcept;

// Finds frames in a sequence of received bytes. Skips a byte that cannot belong to a frame and continues the search at
// the next '<'.
class FalconFrameReader {
public:
    void clear() noexcept { size_ = 0; }
    void push(std::span<const std::uint8_t> bytes) noexcept;
    std::optional<FalconStatus> next() noexcept;
    std::uint64_t skipped() const noexcept { return skipped_; }

private:
    void drop(std::size_t bytes) noexcept;

    // Room for sixteen frames, although normally at most one is in flight. If there is no room, the oldest bytes are
    // dropped.
    std::array<std::uint8_t, 256> bytes_{};
    std::size_t size_ = 0;
    std::uint64_t skipped_ = 0;
};

// Checks a boot table: key 0x08AA, eight reserved words, entry address, blocks of word count, address and data, and a
// zero count at the very end. Rejects, with one sentence, an image that is truncated, too long, or not a boot table.
// The sentence contains `name`, the name of the file.
Result<void> check_falcon_firmware(std::span<const std::uint8_t> image, const std::string& name);

}  // namespace handrail::drivers
