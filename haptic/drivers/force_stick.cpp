#include "haptic/drivers/force_stick.h"

#include <cmath>

namespace handrail {

Result<void> ForceStick::open() {
    const FfAbilities can = link_->abilities();
    if (!can.constant || !can.stick) return fail("This joystick has no constant force in two directions.");
    if (can.gain && !link_->gain(1.0)) return fail("The joystick does not take orders. Please plug it in again.");
    open_ = link_->constant(0.0, 0.0);
    if (!open_) return fail("The joystick refuses a force. Please plug it in again.");
    return {};
}

DeviceSample ForceStick::read(double) noexcept {
    FfLink::Stick stick;
    if (open_ && !lost_) lost_ = !link_->poll(stick);
    DeviceSample sample;
    sample.connected = sample.fresh = open_ && !lost_;
    // The kernel's y is positive towards the person.
    sample.position_m = {stick.x * spec_.workspace_radius_m, -stick.y * spec_.workspace_radius_m, 0.0};
    sample.buttons = stick.buttons;
    return sample;
}

void ForceStick::write(const ForceCommand& command) noexcept {
    if (!open_ || lost_) return;
    const double right = command.force_n.x, forward = command.force_n.y;
    const double newtons = std::sqrt(right * right + forward * forward);
    const bool sound = std::isfinite(newtons) && newtons > 0.0;
    lost_ = !link_->constant(sound ? newtons / spec_.peak_force_n : 0.0, sound ? std::atan2(-right, -forward) : 0.0);
}

void ForceStick::close() noexcept {
    if (!open_) return;
    link_->constant(0.0, 0.0);
    link_->stop();
    open_ = false;
}

}  // namespace handrail
