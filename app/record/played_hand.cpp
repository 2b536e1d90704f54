#include "app/record/played_hand.h"

#include <cmath>

#include "haptic/servo/servo_switches.h"

namespace handrail::record {
namespace {

// Greatest difference between equal forces, because recorded forces are rounded to whole millinewtons.
constexpr double kAsWritten_n = 0.501e-3;

}  // namespace

void PlayedServo::set_scene(std::shared_ptr<const render::HapticScene> scene,
                            std::shared_ptr<servo::HandBodyServo> engine) {
    given_.scene = std::move(scene);
    given_.engine = std::move(engine);
    scenes_.give(given_);
}

void PlayedServo::set_desk(std::shared_ptr<const render::HapticScene> desk) {
    given_.desk = std::move(desk);
    scenes_.give(given_);
}

bool PlayedServo::can(const servo::ServoReads& reads) const {
    return reads.scene <= scenes_.given() && reads.tuning <= tunings_.given() && reads.pose <= poses_.given() &&
           reads.bodies <= bodies_.given() && reads.guidance <= guidances_.given();
}

device::ForceCommand PlayedServo::tick(const servo::HandRow& row) {
    const servo::ServoReads& reads = row.reads;
    const Scenes& scenes = scenes_.at(reads.scene);
    servo::ServoTuning tuning = servo::with_switches(tunings_.at(reads.tuning), reads.stops, reads.focused);
    if (reads.stopping) tuning.forces_on = false;
    engine_ = scenes.engine.get();
    return servo::servo_tick(*state_, {.scene = scenes.scene.get(),
                                       .tuning = tuning,
                                       .pose = poses_.at(reads.pose),
                                       .sample = row.sample,
                                       .now_s = row.time_s,
                                       .bodies = &bodies_.at(reads.bodies),
                                       .desk = scenes.desk.get(),
                                       .guidance = &guidances_.at(reads.guidance),
                                       .engine = engine_});
}

servo::ServoInbox* PlayedHand::change(const core::HandFacts& facts) {
    driven_ = facts.present;
    tool_ = {};
    reported_.clear();
    if (!driven_) return nullptr;
    servos_.push_back(std::make_unique<PlayedServo>(facts.spec));
    return servos_.back().get();
}

bool PlayedHand::step() {
    if (stepping_ || next_ >= rows_.size()) return false;
    const servo::HandRow& row = rows_[next_];
    if (row.servo == 0 || row.servo > servos_.size() || !servos_[row.servo - 1]->can(row.reads)) return false;
    stepping_ = true;
    const bool there = bodies_.before_tick(which_, row);
    stepping_ = false;
    if (!there) return false;
    ++next_;
    PlayedServo& servo = *servos_[row.servo - 1];
    const Vec3 force_n = servo.tick(row).force_n;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(force_n[axis] - row.force_n[axis]) > kAsWritten_n) {
            ++other_forces_;
            break;
        }
    bodies_.after_tick(which_, row, servo.engine());
    if (row.servo == servos_.size()) reported_.push_back(servo.state().tool());
    for (const servo::ContactEvent& event : servo.state().events()) {
        events_.push_back(event);
        events_.back().hand = static_cast<std::uint8_t>(which_);
    }
    return true;
}

bool PlayedHand::run_to(std::uint64_t tick) {
    if (!driven_) return tick == 0;
    while (servos_.back()->state().tool().ticks < tick)
        if (!step()) return false;
    while (!reported_.empty() && reported_.front().ticks <= tick) {
        tool_ = reported_.front();
        reported_.pop_front();
    }
    return true;
}

bool PlayedHand::run_to_events(std::size_t count) {
    while (events_.size() < count)
        if (!step()) return false;
    return true;
}

std::vector<servo::ContactEvent> PlayedHand::take_events(std::size_t count) {
    const auto end = events_.begin() + static_cast<std::ptrdiff_t>(count);
    std::vector<servo::ContactEvent> taken(events_.begin(), end);
    events_.erase(events_.begin(), end);
    return taken;
}

}  // namespace handrail::record
