// A device with Linux force feedback: what a driver needs of an evdev node, and what an emulator can replace. One
// thread at a time; each call takes a system call and does not wait. Private to haptic/drivers.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::drivers {

struct FfAbilities {
    bool rumble = false, constant = false, gain = false, stick = false;  // stick: it has the axes x and y
};

// Plays one effect at a time, replaced in place. Levels 0 to 1.
class FfLink {
public:
    virtual ~FfLink() = default;
    virtual FfAbilities abilities() const = 0;
    // Drives both coils until the next call. Returns false if the device is gone or refuses.
    virtual bool rumble(double strong, double weak) noexcept = 0;
    // A force of this level in the direction of an angle: 0 is towards the person, then clockwise seen from above, so
    // 1/4 turn is left.
    virtual bool constant(double level, double towards_rad) noexcept = 0;
    virtual bool stop() noexcept = 0;
    // Share of its strength that the device may use, 0 to 1.
    virtual bool gain(double share) noexcept = 0;
    // Takes all input since the last call; returns false if the device is gone. Axes -1 to 1, positive to the right and
    // towards the person, as in the kernel.
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

// Every event node under `folder` that has force feedback and may be opened.
std::vector<FfDeviceInfo> list_ff_devices(const std::string& folder = "/dev/input");
Result<std::unique_ptr<FfLink>> open_ff_link(const std::string& path);

}  // namespace handrail::drivers
