// Defines the interface to a device used in addition to the haptic one. Its sticks, buttons or puck are for walking and
// turning; its coils or triggers give cues to the fingers. A Companion never pushes the hand, so it needs neither the
// guard nor the servo. One separate thread owns it. No function waits; a reading or a cue takes one or two system
// calls.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/device/finger_cue.h"
#include "worlds/base/result.h"

namespace handrail::drivers {

// Buttons, named by their place on most pads. A device may lack some of them. The value is the bit number in
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
    double ahead = 0.0, right = 0.0, turn_right = 0.0;  // deflections from -1 to 1, after dead band and curve
    // Rate of turn of a pad with a motion sensor, clockwise from above, in rad/s; 0 while the pad is held still.
    double yaw_right_rad_per_s = 0.0;
    std::uint32_t buttons = 0;
    bool pressed(CompanionButton button) const { return (buttons >> static_cast<unsigned>(button) & 1U) != 0; }
};

class Companion {
public:
    virtual ~Companion() = default;  // stops the vibration and releases the triggers
    // Stores the newest state in `state`. Returns false if the device is gone.
    virtual bool read(CompanionState& state, double now_s) noexcept = 0;
    // Renders a cue. Returns false if the device is gone. A device without coils ignores the cue.
    virtual bool cue(const device::FingerCue& cue) noexcept = 0;
};

struct FoundCompanion {
    std::string name;   // name for --device: "dualsense", "spacemouse", "rumble-pad"
    std::string model;  // for example "DualSense"
    std::string path;   // path of the device node; valid while the device is plugged in
    bool permitted = true;
    std::string how_to;  // how to use the device, suitable for speech: "The left stick walks, ..."
};

// Finds all companion devices that are plugged in. The search sends the devices nothing, so it does not disturb another
// program that uses one of them.
std::vector<FoundCompanion> find_companions();
Result<std::unique_ptr<Companion>> open_companion(const FoundCompanion& found);
// companion_names() returns the possible values of FoundCompanion::name. companion_model() returns the model for one of
// these names.
std::vector<std::string> companion_names();
std::string companion_model(std::string_view name);

// Shapes a stick's deflection: a dead band of a tenth, then a square. The person can then steer finely, and a worn
// stick stays at rest.
double stick_curve(double share) noexcept;

}  // namespace handrail::drivers
