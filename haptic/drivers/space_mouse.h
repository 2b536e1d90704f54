// 3Dconnexion's SpaceMouse: a puck that is pressed, not moved; for walking and turning, without force. Any one thread.
// Source: the reports as its HID descriptor and open drivers describe them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "haptic/drivers/hid_link.h"
#include "worlds/base/vec.h"

namespace handrail {

// Device frame: x right, y forward, z up; turn about the same axes, right-handed. All -1 to 1, 0 at rest, after dead
// band and curve.
struct PuckState {
    Vec3 move{0.0}, turn{0.0};
    std::uint32_t buttons = 0;
};

// 3Dconnexion's, and Logitech's, who sold theirs before and sells much else.
bool is_space_mouse(const HidDeviceInfo& device) noexcept;

class SpaceMouse {
public:
    static constexpr double kDeadBand = 0.08;     // of full deflection: a resting hand moves nobody
    static constexpr double kSilentAfterS = 0.1;  // a puck that stops telling is at rest

    explicit SpaceMouse(std::unique_ptr<HidLink> link) : link_(std::move(link)) {}

    // Takes what is waiting; never waits.
    const PuckState& poll(double now_s) noexcept;
    bool lost() const { return lost_; }
    bool light(bool on) noexcept;

    // One report as bytes; false when it is none of the puck's.
    bool take(std::span<const std::uint8_t> report, double now_s) noexcept;

private:
    std::unique_ptr<HidLink> link_;
    PuckState state_;
    double told_s_ = -1.0;
    bool lost_ = false;
};

}  // namespace handrail
