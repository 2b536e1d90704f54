#include "haptic/drivers/space_mouse.h"

#include <algorithm>
#include <cmath>

namespace handrail::drivers {
namespace {

constexpr double kFullDeflection = 350.0;

// Applies a dead band, then a cube, so that the person can steer finely with light pressure.
double curve(int raw) noexcept {
    const double share = std::clamp(raw / kFullDeflection, -1.0, 1.0);
    const double beyond = (std::abs(share) - SpaceMouse::kDeadBand) / (1.0 - SpaceMouse::kDeadBand);
    if (!(beyond > 0.0)) return 0.0;
    return std::copysign(beyond * beyond * beyond, share);
}

// Converts from the puck's own axes: x right, y towards the person, z down.
Vec3 three(std::span<const std::uint8_t> bytes) noexcept {
    const auto axis = [&](std::size_t i) {
        return curve(static_cast<std::int16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8));
    };
    return {axis(0), -axis(1), -axis(2)};
}

}  // namespace

bool is_space_mouse(const HidDeviceInfo& device) noexcept {
    constexpr std::uint16_t kConnexion = 0x256f, kLogitech = 0x046d, kGenericDesktop = 1, kMultiAxis = 8;
    return (device.vendor == kConnexion || device.vendor == kLogitech) && device.usage_page == kGenericDesktop &&
           device.usage == kMultiAxis;
}

bool SpaceMouse::take(std::span<const std::uint8_t> report, double now_s) noexcept {
    if (report.size() < 2) return false;
    const auto body = report.subspan(1);
    switch (report[0]) {
        case 1:
            if (body.size() < 6) return false;
            state_.move = three(body.first(6));
            if (body.size() >= 12) state_.turn = three(body.subspan(6, 6));
            break;
        case 2:
            if (body.size() < 6) return false;
            state_.turn = three(body.first(6));
            break;
        case 3:
            state_.buttons = 0;
            for (std::size_t i = 0; i < std::min<std::size_t>(body.size(), 4); ++i)
                state_.buttons |= static_cast<std::uint32_t>(body[i]) << (8 * i);
            return true;
        default:
            return false;
    }
    reported_s_ = now_s;
    return true;
}

const PuckState& SpaceMouse::poll(double now_s) noexcept {
    std::array<std::uint8_t, 64> room;
    while (!lost_) {
        const int size = link_->read(room, 0.0);
        if (size == HidLink::kLost) lost_ = true;
        if (size <= 0) break;
        take(std::span(room).first(static_cast<std::size_t>(size)), now_s);
    }
    if (lost_ || now_s - reported_s_ > kSilentAfterS) state_.move = state_.turn = Vec3(0.0);
    if (lost_) state_.buttons = 0;
    return state_;
}

bool SpaceMouse::light(bool on) noexcept {
    const std::array<std::uint8_t, 2> report{4, static_cast<std::uint8_t>(on ? 1 : 0)};
    return link_->write(report);
}

}  // namespace handrail::drivers
