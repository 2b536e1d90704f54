#include "haptic/drivers/falcon_protocol.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

constexpr std::uint8_t kZero = 0x41;  // offset that is added to every small number in a frame
constexpr std::uint8_t kBegin = '<', kEnd = '>';

}  // namespace

FalconFrame pack_falcon_command(const FalconCommand& command) noexcept {
    FalconFrame frame{};
    frame.front() = kBegin;
    frame.back() = kEnd;
    for (std::size_t leg = 0; leg < 3; ++leg) {
        const auto bits =
            static_cast<std::uint16_t>(std::clamp(command.motors[leg], -kFalconMostCounts, kFalconMostCounts));
        for (std::size_t nibble = 0; nibble < 4; ++nibble)
            frame[1 + 4 * leg + nibble] = static_cast<std::uint8_t>(kZero + ((bits >> (4 * nibble)) & 15));
    }
    frame[13] = static_cast<std::uint8_t>(kZero + (command.homing ? 1 : 0) + (command.green ? 2 : 0) +
                                          (command.blue ? 4 : 0) + (command.red ? 8 : 0));
    frame[14] = kZero;
    return frame;
}

std::array<int, 3> falcon_motor_counts(const Vec3& torques_nm, double counts_per_nm) noexcept {
    // The motors turn against the thighs, so the sign is reversed.
    const double highest = std::max({std::abs(torques_nm.x), std::abs(torques_nm.y), std::abs(torques_nm.z)});
    if (!is_finite(torques_nm) || !std::isfinite(counts_per_nm) || !(highest > 0.0)) return {0, 0, 0};
    const Vec3 direction = torques_nm / highest;
    const double counts = std::min(highest * counts_per_nm, static_cast<double>(kFalconMostCounts));
    return {static_cast<int>(-direction.x * counts), static_cast<int>(-direction.y * counts),
            static_cast<int>(-direction.z * counts)};
}

void FalconFrameReader::push(std::span<const std::uint8_t> bytes) noexcept {
    if (bytes.size() > bytes_.size()) {
        skipped_ += bytes.size() - bytes_.size();
        bytes = bytes.last(bytes_.size());
    }
    if (size_ + bytes.size() > bytes_.size()) {
        const std::size_t too_many = size_ + bytes.size() - bytes_.size();
        skipped_ += too_many;
        drop(too_many);
    }
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += bytes.size();
}

void FalconFrameReader::drop(std::size_t bytes) noexcept {
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(bytes), bytes_.begin() + static_cast<std::ptrdiff_t>(size_),
              bytes_.begin());
    size_ -= bytes;
}

std::optional<FalconStatus> FalconFrameReader::next() noexcept {
    while (size_ >= kFalconFrameBytes) {
        FalconStatus status;
        bool sound = bytes_[0] == kBegin && bytes_[15] == kEnd;
        for (std::size_t leg = 0; sound && leg < 3; ++leg) {
            unsigned bits = 0;
            for (std::size_t nibble = 0; nibble < 4; ++nibble) {
                const unsigned value = static_cast<std::uint8_t>(bytes_[1 + 4 * leg + nibble] - kZero);
                sound = sound && value <= 15;
                bits |= (value & 15) << (4 * nibble);
            }
            status.encoders[leg] = static_cast<std::int16_t>(bits);
        }
        // The flags may wrap, because they are a byte and not a small number like the other fields.
        const auto flags = static_cast<std::uint8_t>(bytes_[13] - kZero);
        sound = sound && flags < 0x80;
        if (sound) {
            status.buttons = flags & 15;
            status.homed_legs = (flags >> 4) & 7;
            drop(kFalconFrameBytes);
            return status;
        }
        ++skipped_;
        drop(1);
    }
    return std::nullopt;
}

Result<void> check_falcon_firmware(std::span<const std::uint8_t> image, const std::string& name) {
    std::size_t at = 0;
    bool cut = false;
    const auto word = [&]() -> unsigned {
        if (at + 2 > image.size()) {
            cut = true;
            return 0;
        }
        const unsigned value = image[at] | (static_cast<unsigned>(image[at + 1]) << 8);
        at += 2;
        return value;
    };
    if (word() != 0x08AA || cut) return fail(phrase("drivers.no_firmware"), name);
    for (int i = 0; i < 8; ++i) word();
    word();  // skips the entry address, high word first
    word();
    for (;;) {
        const unsigned words = word();
        if (cut) return fail(phrase("drivers.firmware_cut", {{"bytes", image.size()}}), name);
        if (words == 0) break;
        word();  // skips the load address
        word();
        at += 2 * std::size_t{words};
        if (cut || at > image.size()) return fail(phrase("drivers.firmware_cut", {{"bytes", image.size()}}), name);
    }
    if (at != image.size()) return fail(phrase("drivers.firmware_tail", {{"bytes", image.size() - at}}), name);
    return {};
}

}  // namespace handrail::drivers
