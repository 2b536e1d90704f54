// A force-feedback joystick as a hand that moves in a plane: right and forward, not up. Its constant force is renewed
// in each tick, and the kernel reports its position. Walls are therefore softer and later than on a device built for
// it. Runs in the guard process. Owned by one thread. Source: the kernel's force feedback interface; USB PID 1.0 behind
// it.
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
