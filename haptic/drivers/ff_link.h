// Defines the interface to a device with Linux force feedback. Drivers use FfLink for evdev nodes; an emulator can
// implement it, too. One thread at a time; each call makes a system call and does not wait. Private to haptic/drivers.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::drivers {

struct FfAbilities {
    // `stick` is true if the device has the axes x and y.
    bool rumble = false, constant = false, gain = false, stick = false;
};

// Plays one effect at a time; a new effect replaces the last one in place. Levels are 0 to 1.
class FfLink {
public:
    virtual ~FfLink() = default;
    virtual FfAbilities abilities() const = 0;
    // Drives both coils until the next call. Returns false if the device is gone or rejects the effect.
    virtual bool rumble(double strong, double weak) noexcept = 0;
    // Gives a force of this level in the direction of an angle. The angle counts clockwise, seen from above, from 0
    // towards the person; a quarter turn is left.
    virtual bool constant(double level, double towards_rad) noexcept = 0;
    virtual bool stop() noexcept = 0;
    // Sets the share of its strength that the device may use, 0 to 1.
    virtual bool gain(double share) noexcept = 0;
    // Reads all input since the last call. Returns false if the device is gone. Axes are -1 to 1, positive to the right
    // and towards the person, as in the kernel.
    struct Stick {
        double x = 0.0, y = 0.0;
        std::uint32_t buttons = 0;
    };
    virtual bool poll(Stick& stick) noexcept = 0;
};

struct FfDeviceInfo {
    std::string path, name;
    FfAbilities abilities;
};

// Lists every event node under `folder` that supports force feedback and may be opened.
std::vector<FfDeviceInfo> list_ff_devices(const std::string& folder = "/dev/input");
Result<std::unique_ptr<FfLink>> open_ff_link(const std::string& path);

}  // namespace handrail::drivers
