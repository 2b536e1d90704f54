// A hand of a recording, tick by tick as its servo had it: the same samples and the same values of the app, by their
// numbers. One thread.
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

namespace handrail {

// What was handed over, by how many came before it and itself.
template <class T>
class NumberedValues {
public:
    void give(T value) { values_.push_back(std::move(value)); }
    std::uint32_t given() const { return let_go_ + static_cast<std::uint32_t>(values_.size()); }
    // number <= given(); what came before it is not asked for again. 0: as if nothing had been given.
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

// One of the servos that a hand had.
class PlayedServo final : public ServoInbox {
public:
    explicit PlayedServo(const DeviceSpec& spec) : state_(std::make_unique<ServoState>(spec)) {}

    void set_scene(std::shared_ptr<const HapticScene> scene, std::shared_ptr<HandEngine> engine) override;
    void set_desk(std::shared_ptr<const HapticScene> desk) override;
    void set_tuning(const ServoTuning& tuning) override { tunings_.give(tuning); }
    void set_pose(const WorkspacePose& pose) override { poses_.give(pose); }
    void set_bodies(const BodyFrame& bodies) override { bodies_.give(bodies); }
    void set_guidance(const GuidancePath& guidance) override { guidances_.give(guidance); }
    // All that the tick read has been given.
    bool can(const ServoReads& reads) const;
    // Gives the force.
    ForceCommand tick(const HandRow& row);
    // Its side of what is free to move, of the last tick; null: none.
    HandEngine* engine() const { return engine_; }
    const ServoState& state() const { return *state_; }

private:
    struct Scenes {
        std::shared_ptr<const HapticScene> scene, desk;
        std::shared_ptr<HandEngine> engine;
    };
    std::unique_ptr<ServoState> state_;
    NumberedValues<Scenes> scenes_;
    NumberedValues<ServoTuning> tunings_;
    NumberedValues<WorkspacePose> poses_;
    NumberedValues<BodyFrame> bodies_;
    NumberedValues<GuidancePath> guidances_;
    Scenes given_;  // last
    HandEngine* engine_ = nullptr;
};

class PlayedHand {
public:
    // Rows and bodies outlive it.
    PlayedHand(const std::vector<HandRow>& rows, std::size_t which, PlayedBodies& bodies)
        : rows_(rows), which_(which), bodies_(bodies) {}

    // The session was given this hand. Its servo; null: the hand has none.
    ServoInbox* change(const HandFacts& facts);
    // Until the newest servo has done that many ticks; false where the rows do not go so far. Others may have needed
    // more of them already.
    bool run_to(std::uint64_t tick);
    // Until so many events wait; false where that is not yet known.
    bool run_to_events(std::size_t count);
    // What the newest servo told with the tick that was run to.
    const ToolState& tool() const { return tool_; }
    std::vector<ContactEvent> take_events(std::size_t count);
    // One more tick; false where it has not all that it read.
    bool step();
    // Ticks until now, and those of them whose force is not the one that was recorded.
    std::size_t ticks() const { return next_; }
    std::size_t other_forces() const { return other_forces_; }

private:
    const std::vector<HandRow>& rows_;
    const std::size_t which_;
    PlayedBodies& bodies_;
    std::size_t next_ = 0, other_forces_ = 0;
    bool stepping_ = false;
    std::vector<std::unique_ptr<PlayedServo>> servos_;
    bool driven_ = false;  // there is a hand now
    ToolState tool_;
    std::deque<ToolState> told_;  // by the newest servo since
    std::deque<ContactEvent> events_;
};

}  // namespace handrail
