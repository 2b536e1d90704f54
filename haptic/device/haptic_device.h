// The seam to anything a hand holds. Device frame: right-handed, x right, y forward (away from the person), z up,
// metres from the middle of the workspace. Drivers turn their own axes into this one. Servo thread only, after open().
#pragma once

#include <cstdint>
#include <string>

#include "haptic/device/device_spec.h"
#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail {

// Of a device that is not connected.
enum class DeviceLoss : std::uint8_t {
    Unplugged,  // it is gone, and whoever held it has let it go
    MayPush,    // what held it is gone, and the last force may still act
    ForceOff,   // what held it is gone; the device has taken a force of zero since
};

struct DeviceSample {
    Vec3 position_m{0.0};       // device frame; may be anything on a broken device, checked by servo_tick
    std::uint32_t buttons = 0;  // bit 0 is the first
    bool fresh = true;          // false when the device had no new answer for this tick
    bool connected = true;
    DeviceLoss loss = DeviceLoss::Unplugged;  // means something while not connected
    // False while the device does not know where it is: its position means nothing, and no force may act.
    bool homed = true;
    std::uint8_t homed_legs = 0;  // bit by leg, of a device that finds its zero leg by leg; others leave it 0
    bool hot = false;             // the device says that its motors are too warm
    bool failed = false;          // the driver says that the device is there but does not do as it is told
    Vec3 gimbal_rad{0.0};         // angles of the grip about right, forward and up as its maker counts them; zero where
                                  // nothing measures them
};

struct ForceCommand {
    Vec3 force_n{0.0};  // on the hand, device frame
};

class HapticDevice {
public:
    virtual ~HapticDevice() = default;
    virtual const DeviceSpec& spec() const = 0;
    virtual Result<void> open() = 0;  // app thread, before the servo starts
    // On the servo thread never blocks longer than 1 ms. A driver that must wait longer for its hardware lives in the
    // guard process, and what the servo holds in its place never waits at all (haptic/drivers).
    virtual DeviceSample read(double now_s) noexcept = 0;
    virtual void write(const ForceCommand& command) noexcept = 0;
    virtual void close() noexcept = 0;  // zero force, then let go
};

}  // namespace handrail
