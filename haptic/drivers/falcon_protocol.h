// The Novint Falcon's wire: frames of 16 bytes each way, and the boot image that its processor takes after power-on.
// Pure values, any thread; nothing here allocates but the sentences of a refused image. Source: what the open driver
// libnifalcon and its users published about the wire; the image is TI's 8-bit boot table for the C28x.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail {

inline constexpr int kFalconMostCounts = 4095;  // of a motor command, either way
inline constexpr std::size_t kFalconFrameBytes = 16;

struct FalconCommand {
    std::array<int, 3> motors{};  // -4095 to 4095
    bool green = false, blue = false, red = false;
    bool homing = true;
};

struct FalconStatus {
    std::array<int, 3> encoders{};
    std::uint8_t buttons = 0;     // bit 0 plus, 1 forward, 2 centre, 3 minus
    std::uint8_t homed_legs = 0;  // bits 0 to 2
};

using FalconFrame = std::array<std::uint8_t, kFalconFrameBytes>;
// Motors out of range are held at its ends, so that no value can wrap.
FalconFrame pack_falcon_command(const FalconCommand& command) noexcept;

// Motor counts for thigh torques in Nm. What is not finite is zero; what is too much is scaled down, all three by the
// same factor, so that the direction of the force stays. Counts are rounded towards zero.
std::array<int, 3> falcon_motor_counts(const Vec3& torques_nm, double counts_per_nm) noexcept;

// Finds the frames in a stream of bytes. A byte that cannot belong to a frame is skipped, and the search goes on at the
// next '<'.
class FalconFrameReader {
public:
    void clear() noexcept { size_ = 0; }
    void push(std::span<const std::uint8_t> bytes) noexcept;
    std::optional<FalconStatus> next() noexcept;
    std::uint64_t skipped() const noexcept { return skipped_; }

private:
    void drop(std::size_t bytes) noexcept;

    std::array<std::uint8_t, 256> bytes_{};  // sixteen frames, where one is ever in flight; the oldest bytes give way
    std::size_t size_ = 0;
    std::uint64_t skipped_ = 0;
};

// Walks the boot table: key 0x08AA, eight reserved words, entry address, blocks of word count, address and data, a zero
// count at the very end. Refuses in one sentence what is cut, too long, or something else. `name` is the file's.
Result<void> check_falcon_firmware(std::span<const std::uint8_t> image, const std::string& name);

}  // namespace handrail
