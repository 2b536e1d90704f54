// Drives Dynamics: a thread of its own at 240 Hz, paced by a Clock, and every hand-over to and from it. Each channel
// has one producer and one consumer. Without start() the same loop is stepped by its owner in virtual time: whatever
// was handed over before a step counts in it, so the same calls give the same bits.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "haptic/dynamics/dynamics.h"
#include "haptic/render/hand_channel.h"
#include "worlds/base/clock.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/spsc_ring.h"

namespace handrail {

class DynamicsLoop {
public:
    using EventRing = SpscRing<BodyEvent, 256>;

    // What the app asks for, in its order.
    struct Order {
        enum class Kind : std::uint8_t { Restart, Lead, LetGo, Walker, Shove };
        Kind kind = Kind::Restart;
        std::uint32_t body = kNoBody;
        Vec3 at_m{0.0};  // Lead: where to; Walker: the feet
        double most_n = 0.0;
        Rotation turn{};
        Vec3 speed_m_per_s{0.0};                // Shove
        double for_s = 0.0;                     // Shove
        double radius_m = 0.0, height_m = 0.0;  // Walker; a height of 0: nobody
    };
    // Where every driven thing is; index as DynamicsScene::driven. Made and freed off the servo thread.
    using DrivenPoses = std::shared_ptr<const std::vector<BodyPose>>;

    explicit DynamicsLoop(std::shared_ptr<const DynamicsScene> scene, double begin_s = 0.0);
    ~DynamicsLoop();
    DynamicsLoop(const DynamicsLoop&) = delete;
    DynamicsLoop& operator=(const DynamicsLoop&) = delete;

    // Makes the thread. The clock outlives the loop, and its time is that of the hands. stop() joins; more often does
    // no harm.
    void start(Clock& clock);
    void stop();
    // Every whole step that ended by now; the thread's body, or for the owner of virtual time. After a stall at most
    // kMostBehind steps are made up for and the rest of the time is let go: bodies then move slower than the clock,
    // which nobody who touches them can tell from a heavier machine. False: none was due.
    bool step_until(double now_s);

    // Servo thread of each hand.
    // 0 or 1; whoever takes it may keep it beyond the engine's end.
    std::shared_ptr<HandChannel> hand(unsigned which) const { return hands_[which]; }
    HandPushRing& pushes(unsigned hand) { return hands_[hand]->pushes; }
    void place_hand(unsigned hand, const HandPlace& place) { hands_[hand]->place.publish(place); }
    bool newer_frame(unsigned hand) { return hands_[hand]->frame.refresh(); }
    const DynamicsFrame& frame(unsigned hand) const { return hands_[hand]->frame.read(); }

    // App thread.
    bool order(const Order& order) { return orders_.push(order); }
    void drive(const DrivenPoses& poses) { driven_.publish(poses); }
    bool newer_frame_for_app() { return for_app_.refresh(); }
    const DynamicsFrame& frame_for_app() const { return for_app_.read(); }
    // Ears' thread. When it is full the oldest stay.
    EventRing& events() { return events_; }

    // Steps that were made up for late, and seconds let go, since the start; any thread.
    std::uint64_t late_steps() const { return late_steps_.load(std::memory_order_relaxed); }
    double lost_s() const { return lost_s_.load(std::memory_order_relaxed); }

    static constexpr int kMostBehind = 12;

private:
    void take();
    void one_step();

    Dynamics dynamics_;
    const std::array<std::shared_ptr<HandChannel>, 2> hands_{std::make_shared<HandChannel>(),
                                                             std::make_shared<HandChannel>()};
    LatestValue<DynamicsFrame> for_app_;
    SpscRing<Order, 64> orders_;
    LatestValue<DrivenPoses> driven_;
    EventRing events_;
    DynamicsFrame now_;
    std::vector<BodyEvent> heard_;
    std::atomic<std::uint64_t> late_steps_{0};
    std::atomic<double> lost_s_{0.0};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace handrail
