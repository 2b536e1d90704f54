// Defines the interface to any device that a hand holds. Device frame: right-handed, x right, y forward (away from the
// person), z up, metres from the middle of the workspace. Drivers convert their own axes into this frame. After open(),
// only the servo thread uses it.
#pragma once

#include <cstdint>
#include <string>

#include "haptic/device/device_spec.h"
#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail::device {

// Why a device is not connected, and whether its last force may still act.
enum class DeviceLoss : std::uint8_t {
    Unplugged,  // the device is gone, and the process that held it has released it
    MayPush,    // the process that held the device is gone, and the last force may still act
    ForceOff,   // the process that held the device is gone, but the device has accepted a force of zero since
};

struct DeviceSample {
    // Position of the hand in the device frame. A broken device may report any value, so servo_tick() checks it.
    Vec3 position_m{0.0};
    std::uint32_t buttons = 0;  // pressed buttons; bit 0 is the first button
    bool fresh = true;          // false if the device had no new answer for this tick
    bool connected = true;
    DeviceLoss loss = DeviceLoss::Unplugged;  // why the device is not connected; valid only if `connected` is false
    // False while the device does not know its own position. position_m is then invalid, and the driver must give no
    // force.
    bool homed = true;
    std::uint8_t homed_legs = 0;  // On a device that homes leg by leg, one bit for each homed leg. On other devices 0.
    bool hot = false;             // the device reports that its motors are too warm
    bool failed = false;          // the driver reports that the device is present but does not obey commands
    // Angles of the grip about the right, forward and up axes, as the maker counts them. Zero if the device does not
    // measure them.
    Vec3 gimbal_rad{0.0};
};

struct ForceCommand {
    Vec3 force_n{0.0};  // force on the hand, device frame
};

class HapticDevice {
public:
    virtual ~HapticDevice() = default;
    virtual const DeviceSpec& spec() const = 0;
    virtual Result<void> open() = 0;  // called on the app thread, before the servo starts
    // The servo thread calls read() and write(), so they must never block longer than 1 ms. A driver that must wait
    // longer for its hardware runs in the guard process. On the servo thread GuardedDevice replaces it and never waits
    // (haptic/drivers).
    virtual DeviceSample read(double now_s) noexcept = 0;
    virtual void write(const ForceCommand& command) noexcept = 0;
    virtual void close() noexcept = 0;  // sends zero force, then releases the device
};

}  // namespace handrail::device
