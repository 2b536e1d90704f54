// 3Dconnexion's SpaceMouse: a puck that is pressed, not moved; for walking and turning, without force. Any one thread.
// Source: its HID descriptor, and descriptions of the reports in open drivers.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "haptic/drivers/hid_link.h"
#include "worlds/base/vec.h"

namespace handrail::drivers {

// Device frame: x right, y forward, z up; rotations about the same axes, right-handed. All -1 to 1, 0 at rest, after
// dead band and curve.
struct PuckState {
    Vec3 move{0.0}, turn{0.0};
    std::uint32_t buttons = 0;
};

// Recognises 3Dconnexion's pucks and those of Logitech, who sold them before and also sells many other devices.
bool is_space_mouse(const HidDeviceInfo& device) noexcept;

class SpaceMouse {
public:
    static constexpr double kDeadBand = 0.08;     // share of full deflection, so that a resting hand moves nothing
    static constexpr double kSilentAfterS = 0.1;  // a puck that sends nothing for this long is at rest

    explicit SpaceMouse(std::unique_ptr<HidLink> link) : link_(std::move(link)) {}

    // Takes the reports that are waiting; never waits.
    const PuckState& poll(double now_s) noexcept;
    bool lost() const { return lost_; }
    bool light(bool on) noexcept;

    // Takes one report as bytes; returns false if it is not one of the puck's.
    bool take(std::span<const std::uint8_t> report, double now_s) noexcept;

private:
    std::unique_ptr<HidLink> link_;
    PuckState state_;
    double told_s_ = -1.0;
    bool lost_ = false;
};

}  // namespace handrail::drivers
