#include "app/record/played_hand.h"

#include "haptic/servo/servo_switches.h"

namespace handrail {

void PlayedServo::take(const Session& app, std::size_t which) {
    if (!app.scene()) return;
    HandOutput told = app.hand(which);
    if (app.haptic_scene() != given_.scene) {
        given_.scene = app.haptic_scene();
        given_.engine = told.engine;
        scenes_.give(given_);
    }
    if (which == 0 && app.desk_visit().scene() != given_.desk) {
        given_.desk = app.desk_visit().scene();
        scenes_.give(given_);
    }
    tunings_.give(told.tuning);
    poses_.give(told.pose);
    if (std::exchange(given_bodies_, app.bodies().number()) != app.bodies().number()) bodies_.give(app.bodies());
    if (told.guidance && std::exchange(given_guidance_, told.guidance->number) != told.guidance->number)
        guidances_.give(*told.guidance);
}

bool PlayedServo::can(const ServoReads& reads) const {
    return reads.scene <= scenes_.given() && reads.tuning <= tunings_.given() && reads.pose <= poses_.given() &&
           reads.bodies <= bodies_.given() && reads.guidance <= guidances_.given();
}

void PlayedServo::tick(const HandRow& row) {
    const ServoReads& reads = row.reads;
    const Scenes& scenes = scenes_.at(reads.scene);
    ServoTuning tuning = with_switches(tunings_.at(reads.tuning), reads.stops, reads.focused);
    if (reads.stopping) tuning.forces_on = false;
    servo_tick(*state_, scenes.scene.get(), tuning, poses_.at(reads.pose), row.sample, row.time_s,
               &bodies_.at(reads.bodies), scenes.desk.get(), &guidances_.at(reads.guidance), scenes.engine.get());
}

void PlayedHand::change(const HandFacts& facts) {
    driven_ = facts.present;
    if (driven_) servos_.push_back(std::make_unique<PlayedServo>(facts.spec));
}

bool PlayedHand::step() {
    if (next_ >= rows_.size()) return false;
    const HandRow& row = rows_[next_];
    if (row.servo == 0 || row.servo > servos_.size() || !servos_[row.servo - 1]->can(row.reads)) return false;
    ++next_;
    PlayedServo& servo = *servos_[row.servo - 1];
    servo.tick(row);
    for (const ContactEvent& event : servo.state().events()) {
        events_.push_back(event);
        events_.back().hand = static_cast<std::uint8_t>(which_);
    }
    return true;
}

bool PlayedHand::run_to(std::uint64_t tick) {
    while (tool().ticks < tick)
        if (!step()) return false;
    return true;
}

bool PlayedHand::run_to_events(std::size_t count) {
    while (events_.size() < count)
        if (!step()) return false;
    return true;
}

std::vector<ContactEvent> PlayedHand::take_events(std::size_t count) {
    const auto end = events_.begin() + static_cast<std::ptrdiff_t>(count);
    std::vector<ContactEvent> taken(events_.begin(), end);
    events_.erase(events_.begin(), end);
    return taken;
}

}  // namespace handrail
