// A device beside the hand: sticks, buttons or a puck to walk and turn with, and coils or triggers that give cues to
// the fingers. It never pushes the hand, so it needs no guard and no servo: one thread of its own owns it. Nothing here
// waits; a reading or a cue takes a system call or two.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/device/finger_cue.h"
#include "worlds/base/result.h"

namespace handrail {

// Buttons by what they are on most pads; a device has some of them. The bit of each in CompanionState::buttons.
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
    virtual ~Companion() = default;  // still and loose
    // The newest; false when the device is gone.
    virtual bool read(CompanionState& state, double now_s) noexcept = 0;
    // False when the device is gone. A device without coils does nothing.
    virtual bool cue(const FingerCue& cue) noexcept = 0;
};

struct FoundCompanion {
    std::string name;   // as --device takes it: "dualsense", "spacemouse", "rumble-pad"
    std::string model;  // "DualSense"
    std::string path;   // names it as long as it is plugged in
    bool permitted = true;
    std::string how_to;  // what it does, to be spoken: "The left stick walks, ..."
};

// All that are plugged in, without a word to them: one that somebody else holds open is not disturbed.
std::vector<FoundCompanion> find_companions();
Result<std::unique_ptr<Companion>> open_companion(const FoundCompanion& found);
// The names in FoundCompanion, and what to call such a device.
std::vector<std::string> companion_names();
std::string companion_model(std::string_view name);

// A stick's share after a dead band of a tenth and a square, so that it steers finely and a worn stick stays at rest.
double stick_curve(double share) noexcept;

}  // namespace handrail
