// Runs Dynamics on a separate thread at 240 Hz, paced by a Clock, and passes all data to and from Dynamics. Each
// channel has one producer and one consumer. Without start(), the owner steps the same loop in virtual time. A step
// takes account of all data that arrived before the step, so the same calls give bit-identical results.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "haptic/dynamics/body_engine.h"
#include "haptic/dynamics/dynamics.h"
#include "haptic/dynamics/engine_recording.h"
#include "haptic/render/hand_channel.h"
#include "worlds/base/clock.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::dynamics {

// Carry out a request of the app, or set the poses of all driven things.
void carry_out(Dynamics& dynamics, const BodyEngine::Order& order);
void carry_out(Dynamics& dynamics, const std::vector<render::BodyPose>& driven);

class DynamicsLoop : public BodyEngine {
public:
    using EventRing = SpscRing<render::BodyEvent, 256>;

    // `recording` receives a row for each step and must outlive the loop. Null: no recording.
    explicit DynamicsLoop(std::shared_ptr<const render::DynamicsScene> scene, double begin_s = 0.0,
                          EngineRecording* recording = nullptr);
    ~DynamicsLoop() override;

    // start() starts the thread. The clock must outlive the loop and must also be the clock of the hands. stop() ends
    // and joins the thread; it may be called again.
    void start(Clock& clock);
    void stop();
    // Computes every step that has ended by `now_s`. The loop's thread calls it, or the owner in virtual time. After a
    // stall it computes at most kMostBehind missed steps and drops the rest of the time. Bodies then move more slowly
    // than the clock, which feels as if they were heavier. Returns false if no step was due.
    bool step_until(double now_s);

    // The servo thread of each hand calls these functions.
    std::shared_ptr<render::HandChannel> hand(unsigned which) const override { return hands_[which]; }
    render::HandPushRing& pushes(unsigned hand) { return hands_[hand]->pushes; }
    void place_hand(unsigned hand, const render::HandPlace& place) { hands_[hand]->place.publish(place); }
    bool newer_frame(unsigned hand) { return hands_[hand]->frame.refresh(); }
    const render::DynamicsFrame& frame(unsigned hand) const { return hands_[hand]->frame.read(); }

    // The app thread calls these functions.
    bool order(const Order& order) override;
    void drive(const DrivenPoses& poses) override { driven_.publish({poses, ++drives_}); }
    bool newer_frame_for_app() override { return for_app_.refresh(); }
    const render::DynamicsFrame& frame_for_app() const override { return for_app_.read(); }
    bool take_event(render::BodyEvent& event) override { return events_.pop(event); }

    // late_steps() returns the number of steps that were computed late, after a stall. lost_s() returns the seconds
    // that were dropped. Both count from the start. Any thread.
    std::uint64_t late_steps() const { return late_steps_.load(std::memory_order_relaxed); }
    double lost_s() const { return lost_s_.load(std::memory_order_relaxed); }

    static constexpr int kMostBehind = 12;

private:
    struct Driven {
        DrivenPoses poses;
        std::uint32_t number = 0;  // number of the drive() call that passed these poses, counted from 1
    };

    void take();
    void one_step();

    EngineRecording* const recording_;
    Dynamics dynamics_;
    const std::array<std::shared_ptr<render::HandChannel>, 2> hands_{std::make_shared<render::HandChannel>(),
                                                                     std::make_shared<render::HandChannel>()};
    LatestValue<render::DynamicsFrame> for_app_;
    SpscRing<Order, 64> orders_;
    LatestValue<Driven> driven_;
    std::uint32_t drives_ = 0;  // number of drive() calls; app thread
    EventRing events_;
    render::DynamicsFrame now_;
    EngineRow row_;  // row of the recording for the current step
    std::vector<render::BodyEvent> heard_;
    std::atomic<std::uint64_t> late_steps_{0};
    std::atomic<double> lost_s_{0.0};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace handrail::dynamics
