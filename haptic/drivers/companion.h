// A device used in addition to the haptic one: sticks, buttons or a puck for walking and turning, and coils or triggers
// that give cues to the fingers. It never pushes the hand, so it needs no guard and no servo. One separate thread owns
// it. No function waits; a reading or a cue takes a system call or two.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/device/finger_cue.h"
#include "worlds/base/result.h"

namespace handrail::drivers {

// Buttons, named by their place on most pads; a device has only some of them. The value is the bit in
// CompanionState::buttons.
enum class CompanionButton : std::uint8_t {
    South,
    East,
    West,
    North,
    LeftShoulder,
    RightShoulder,
    LeftSpecial,
    RightSpecial,
    LeftStick,
    RightStick,
    Up,
    Right,
    Down,
    Left
};

struct CompanionState {
    double ahead = 0.0, right = 0.0, turn_right = 0.0;  // -1 to 1, after dead band and curve
    std::uint32_t buttons = 0;
    bool pressed(CompanionButton button) const { return (buttons >> static_cast<unsigned>(button) & 1U) != 0; }
};

class Companion {
public:
    virtual ~Companion() = default;  // stops the vibration and loosens the triggers
    // Returns the newest state in `state`; false if the device is gone.
    virtual bool read(CompanionState& state, double now_s) noexcept = 0;
    // Returns false if the device is gone. A device without coils ignores the cue.
    virtual bool cue(const device::FingerCue& cue) noexcept = 0;
};

struct FoundCompanion {
    std::string name;   // as --device accepts it: "dualsense", "spacemouse", "rumble-pad"
    std::string model;  // "DualSense"
    std::string path;   // identifies it while it is plugged in
    bool permitted = true;
    std::string how_to;  // what it does, suitable for speech: "The left stick walks, ..."
};

// Finds all devices that are plugged in, without sending them anything: a device that another program has open is not
// disturbed.
std::vector<FoundCompanion> find_companions();
Result<std::unique_ptr<Companion>> open_companion(const FoundCompanion& found);
// The possible values of FoundCompanion::name, and the model for such a name.
std::vector<std::string> companion_names();
std::string companion_model(std::string_view name);

// Shapes a stick's deflection: a dead band of a tenth, then a square, so that it steers finely and a worn stick stays
// at rest.
double stick_curve(double share) noexcept;

}  // namespace handrail::drivers
