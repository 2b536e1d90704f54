// What the servo of one hand needs for the free bodies of one world: the hand's models of them, its channel to their
// engine, and the table of all moving poses. The app makes (and allocates) it when a world with free bodies is entered.
// From then on it belongs to the servo thread, to one servo at a time. A world without free bodies has none.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptic/render/hand_channel.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"

namespace handrail::servo {

// The person's settings for free bodies. Comes from the app as part of ServoTuning.
struct BodyTuning {
    double strength_n = 50.0;  // strength of the walker in the world; corresponds to 2.5 N of the hand (felt_gain)
    bool hold = false;         // by a key: true takes hold of the touched body, false lets go
    // Buttons of the device. While pressed, they hold the body that was touched when they were pressed. 0: none.
    std::uint32_t grip_buttons = 0;
    std::int32_t quarters = 0;  // quarter turns of the held body to the left, counted since the start
};

class HandBodyServo {
public:
    static constexpr std::size_t kMoreBodies = 256;  // room for bodies that are set down in a world later

    // hand: 0 or 1. bodies: number of bodies of the touched scene (HapticScene::bodies). Allocates.
    HandBodyServo(std::shared_ptr<const render::DynamicsScene> scene, std::shared_ptr<render::HandChannel> channel,
                  unsigned hand, std::size_t bodies);
    HandBodyServo(const HandBodyServo&) = delete;
    HandBodyServo& operator=(const HandBodyServo&) = delete;

    // The stages of a tick, in this order (see servo_tick). None allocates, locks, throws or reads a clock.
    // 1. Takes hold or lets go, by button or key. Returns true if a held button belongs to the grip, so that it must
    //   do nothing else.
    bool grip(const BodyTuning& tuning, std::uint32_t buttons, double now_s, const Vec3& hand_m) noexcept;
    // 2. Returns where all bodies are: free ones as this hand meets them, the others as `told` has them (for this
    //   scene, or empty).
    // Valid until the next call.
    render::BodyPoses place(const render::BodyPoses& told, const render::HapticScene& scene, double now_s,
                            const Vec3& hand_m, const BodyFeel& feel) noexcept;
    Vec3 carried_m() const noexcept { return bodies_.carried_m(); }
    // 3. Force of the held body on the hand, world axes, hand newtons.
    Vec3 grip_force_n(const Vec3& hand_m, double dt_s) noexcept { return bodies_.grip_force_n(hand_m, dt_s, feel_); }
    void felt(const render::TouchResult& result) noexcept { touched_ = result; }
    // 4. Call it after the limiter let `share` of the wanted force through.
    void react(double share, double now_s, double dt_s) noexcept {
        bodies_.react(touched_, share, now_s, dt_s, feel_, channel_->pushes);
    }
    // Replaces all these stages if the hand is not in the world in this tick, or if its position does not continue from
    // the one before. Lets go of everything.
    void leave() noexcept;

    std::uint32_t holds() const noexcept { return bodies_.holds(); }
    std::uint32_t heavy() noexcept { return bodies_.heavy(); }
    const BodiesInReach& bodies() const noexcept { return bodies_; }

    // For recordings and their replay.
    render::HandChannel& channel() noexcept { return *channel_; }
    std::uint32_t take_refused() noexcept { return bodies_.take_refused(); }
    bool take_back(std::uint32_t refused, const render::HandPush& push) noexcept {
        return bodies_.take_back(refused, push);
    }

private:
    const std::shared_ptr<const render::DynamicsScene> scene_;
    const std::shared_ptr<render::HandChannel> channel_;
    BodiesInReach bodies_;
    BodyFeel feel_;
    std::vector<render::BodyPose> poses_;  // poses of the touched scene's bodies, with room for more
    std::vector<char> free_;               // for each body, with room for more: 1 if the engine decides its pose
    std::uint64_t number_ = std::uint64_t{1} << 40;  // number of the table, beyond those of any playback
    std::uint64_t told_ = 0, told_ways_ = 0;         // the numbers in the last `told`
    std::uint32_t generation_ = 0;                   // the scene that the last `told` belonged to
    render::TouchResult touched_;
    bool here_ = false, held_by_key_ = false, held_by_button_ = false;
    std::uint32_t buttons_ = 0;  // buttons of the grip in the last tick
    std::int32_t quarters_ = 0;
    bool quarters_known_ = false;
};

}  // namespace handrail::servo
