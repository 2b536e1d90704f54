// Computes a recorded hand again, tick by tick, as its servo did. Uses the same samples of the device, and the same
// values from the app, which the recording identifies by their numbers. One thread.
#pragma once

#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "app/core/context/hands_state.h"
#include "app/record/played_bodies.h"
#include "haptic/servo/hand_recording.h"
#include "haptic/servo/servo_inbox.h"
#include "haptic/servo/servo_tick.h"

namespace handrail::record {

// Stores the values that the app has handed over, numbered from 1 in their order.
template <class T>
class NumberedValues {
public:
    void give(T value) { values_.push_back(std::move(value)); }
    std::uint32_t given() const { return let_go_ + static_cast<std::uint32_t>(values_.size()); }
    // Returns the value with that number. 0 means the initial value, before the app had handed over any. Requires
    // number <= given(). The function drops earlier values, so never call it with a smaller number than before.
    const T& at(std::uint32_t number) {
        if (number == 0) return none_;
        while (let_go_ + 1 < number) {
            values_.pop_front();
            ++let_go_;
        }
        return values_.front();
    }

private:
    std::deque<T> values_;
    std::uint32_t let_go_ = 0;
    T none_{};
};

// Computes one of the servos that a hand had during the session.
class PlayedServo final : public servo::ServoInbox {
public:
    explicit PlayedServo(const device::DeviceSpec& spec) : state_(std::make_unique<servo::ServoState>(spec)) {}

    void set_scene(std::shared_ptr<const render::HapticScene> scene,
                   std::shared_ptr<servo::HandBodyServo> engine) override;
    void set_desk(std::shared_ptr<const render::HapticScene> desk) override;
    void set_tuning(const servo::ServoTuning& tuning) override { tunings_.give(tuning); }
    void set_pose(const servo::WorkspacePose& pose) override { poses_.give(pose); }
    void set_bodies(const servo::BodyFrame& bodies) override { bodies_.give(bodies); }
    void set_guidance(const servo::GuidancePath& guidance) override { guidances_.give(guidance); }
    // Returns true if the app has already handed over everything that the tick read.
    bool can(const servo::ServoReads& reads) const;
    // Computes one tick and returns its force.
    device::ForceCommand tick(const servo::HandRow& row);
    // Returns the hand's part of the engine of free bodies at the last tick; null if there was none.
    servo::HandBodyServo* engine() const { return engine_; }
    const servo::ServoState& state() const { return *state_; }

private:
    struct Scenes {
        std::shared_ptr<const render::HapticScene> scene, desk;
        std::shared_ptr<servo::HandBodyServo> engine;
    };
    std::unique_ptr<servo::ServoState> state_;
    NumberedValues<Scenes> scenes_;
    NumberedValues<servo::ServoTuning> tunings_;
    NumberedValues<servo::WorkspacePose> poses_;
    NumberedValues<servo::BodyFrame> bodies_;
    NumberedValues<servo::GuidancePath> guidances_;
    Scenes given_;  // the values that the app handed over last
    servo::HandBodyServo* engine_ = nullptr;
};

class PlayedHand {
public:
    // `rows` and `bodies` must outlive this object.
    PlayedHand(const std::vector<servo::HandRow>& rows, std::size_t which, PlayedBodies& bodies)
        : rows_(rows), which_(which), bodies_(bodies) {}

    // Call if the session receives another hand. Returns the servo of that hand; null if no hand is present.
    servo::ServoInbox* change(const core::HandFacts& facts);
    // Computes ticks until the newest servo has done `tick` ticks. Returns false if the rows end before that. The servo
    // may already have done more ticks, because other readers needed their results.
    bool run_to(std::uint64_t tick);
    // Computes ticks until `count` events are waiting. Returns false if the rows contain fewer events.
    bool run_to_events(std::size_t count);
    // Returns the state that the newest servo reported after the tick given to run_to.
    const servo::ToolState& tool() const { return tool_; }
    std::vector<servo::ContactEvent> take_events(std::size_t count);
    // Computes one more tick. Returns false if a value that the tick read is missing.
    bool step();
    // Return how many ticks were computed, and how many of them gave another force than the recorded one.
    std::size_t ticks() const { return next_; }
    std::size_t other_forces() const { return other_forces_; }

private:
    const std::vector<servo::HandRow>& rows_;
    const std::size_t which_;
    PlayedBodies& bodies_;
    std::size_t next_ = 0, other_forces_ = 0;
    bool stepping_ = false;
    std::vector<std::unique_ptr<PlayedServo>> servos_;
    bool driven_ = false;  // true while the session has a hand
    servo::ToolState tool_;
    std::deque<servo::ToolState> reported_;  // states that the newest servo has reported since tool_
    std::deque<servo::ContactEvent> events_;
};

}  // namespace handrail::record
