// Drives 3Dconnexion's SpaceMouse, a puck that the hand pushes and twists but that hardly moves. The puck is for
// walking and turning and gives no force. Any one thread. Source: its HID descriptor, and descriptions of the reports
// in open drivers.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "haptic/drivers/hid_link.h"
#include "worlds/base/vec.h"

namespace handrail::drivers {

// Deflections in the device frame: x right, y forward, z up; rotations about the same axes, right-handed. All are -1 to
// 1, and 0 at rest, after dead band and curve.
struct PuckState {
    Vec3 move{0.0}, turn{0.0};
    std::uint32_t buttons = 0;
};

// Returns true for 3Dconnexion's pucks and for those of Logitech, who sold them earlier. Logitech also sells many other
// devices.
bool is_space_mouse(const HidDeviceInfo& device) noexcept;

class SpaceMouse {
public:
    // Dead band as a share of full deflection. A hand that only rests on the puck thus moves nothing.
    static constexpr double kDeadBand = 0.08;
    static constexpr double kSilentAfterS = 0.1;  // time without a report after which the puck is at rest

    explicit SpaceMouse(std::unique_ptr<HidLink> link) : link_(std::move(link)) {}

    // Processes the reports that have arrived. Never waits.
    const PuckState& poll(double now_s) noexcept;
    bool lost() const { return lost_; }
    bool light(bool on) noexcept;

    // Processes one report, given as bytes. Returns false if the bytes are not a report of the puck.
    bool take(std::span<const std::uint8_t> report, double now_s) noexcept;

private:
    std::unique_ptr<HidLink> link_;
    PuckState state_;
    double reported_s_ = -1.0;
    bool lost_ = false;
};

}  // namespace handrail::drivers
