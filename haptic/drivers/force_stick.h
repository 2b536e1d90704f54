// Drives a force-feedback joystick as a haptic device. The hand moves in a plane: right and forward, but not up. Each
// tick sends a new constant force, and the kernel reports the position. Walls are therefore softer, and respond later,
// than on a device built for haptics. Runs in the guard process; one thread owns it. Source: the kernel's force
// feedback interface, which is based on USB PID 1.0.
#pragma once

#include <memory>

#include "haptic/device/haptic_device.h"
#include "haptic/drivers/ff_link.h"

namespace handrail::drivers {

class ForceStick final : public device::HapticDevice {
public:
    explicit ForceStick(std::unique_ptr<FfLink> link)
        : link_(std::move(link)), spec_(*device::find_device_spec("force-stick")) {}
    ~ForceStick() override { ForceStick::close(); }

    const device::DeviceSpec& spec() const override { return spec_; }
    Result<void> open() override;
    device::DeviceSample read(double now_s) noexcept override;
    void write(const device::ForceCommand& command) noexcept override;
    void close() noexcept override;

private:
    std::unique_ptr<FfLink> link_;
    device::DeviceSpec spec_;
    bool open_ = false, lost_ = false;
};

}  // namespace handrail::drivers
