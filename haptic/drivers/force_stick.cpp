#include "haptic/drivers/force_stick.h"

#include <cmath>

#include "haptic/drivers/force_packing.h"
#include "worlds/base/language.h"

namespace handrail::drivers {

Result<void> ForceStick::open() {
    const FfAbilities can = link_->abilities();
    if (!can.constant || !can.stick) return fail(phrase("drivers.weak_stick"));
    if (can.gain && !link_->gain(1.0)) return fail(phrase("drivers.deaf_stick"));
    open_ = link_->constant(0.0, 0.0);
    if (!open_) return fail(phrase("drivers.stick_refuses"));
    return {};
}

device::DeviceSample ForceStick::read(double) noexcept {
    FfLink::Stick stick;
    if (open_ && !lost_) lost_ = !link_->poll(stick);
    device::DeviceSample sample;
    sample.connected = sample.fresh = open_ && !lost_;
    // In the kernel's convention, y is positive towards the person.
    sample.position_m = {stick.x * spec_.workspace_radius_m, -stick.y * spec_.workspace_radius_m, 0.0};
    sample.buttons = stick.buttons;
    return sample;
}

void ForceStick::write(const device::ForceCommand& command) noexcept {
    if (!open_ || lost_) return;
    // The stick cannot give an upward force. If any component is not finite, the whole command is replaced by zero.
    if (!is_finite(command.force_n)) {
        lost_ = !link_->constant(0.0, 0.0);
        return;
    }
    const Vec3 force = held_to({command.force_n.x, command.force_n.y, 0.0}, spec_.peak_force_n);
    const double newtons = std::sqrt(force.x * force.x + force.y * force.y);
    lost_ = !link_->constant(newtons / spec_.peak_force_n, newtons > 0.0 ? std::atan2(-force.x, -force.y) : 0.0);
}

void ForceStick::close() noexcept {
    if (!open_) return;
    link_->constant(0.0, 0.0);
    link_->stop();
    open_ = false;
}

}  // namespace handrail::drivers
