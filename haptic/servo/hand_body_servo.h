// Holds the data that the servo of one hand needs for the free bodies of one world: the hand's models of them, the
// hand's channel to their engine, and the table of all moving poses. When the person enters a world with free bodies,
// the app allocates a HandBodyServo. From then on the servo thread owns it; only one servo may use it at a time. A
// world without free bodies has none.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptic/render/hand_channel.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"

namespace handrail::servo {

// The person's settings for free bodies. They are part of ServoTuning.
struct BodyTuning {
    // Strength of the walker in the world. A force of this size is felt as 2.5 N at the hand (felt_gain).
    double strength_n = 50.0;
    bool hold = false;  // set by a key: true grips the touched body, false releases it
    // Buttons of the device for gripping. While they are pressed, they hold the body that was touched when they were
    // pressed. 0: none.
    std::uint32_t grip_buttons = 0;
    // Number of quarter turns of the held body to the left since the start; turns to the right are negative.
    std::int32_t quarters = 0;
};

class HandBodyServo {
public:
    static constexpr std::size_t kMoreBodies = 256;  // room for bodies that are added to a world later

    // `hand` is 0 or 1. `bodies` is the number of bodies of the touched scene (HapticScene::bodies). Allocates.
    HandBodyServo(std::shared_ptr<const render::DynamicsScene> scene, std::shared_ptr<render::HandChannel> channel,
                  unsigned hand, std::size_t bodies);
    HandBodyServo(const HandBodyServo&) = delete;
    HandBodyServo& operator=(const HandBodyServo&) = delete;

    // The functions from here on are the stages of a tick, in this order (see servo_tick). None allocates, locks,
    // throws or reads a clock.
    // 1. Grips or releases a body, by button or key. Returns true if a held button belongs to the grip, so that the
    //   button must have no other effect.
    bool grip(const BodyTuning& tuning, std::uint32_t buttons, double now_s, const Vec3& hand_m) noexcept;
    // 2. Returns the poses of all bodies. Free bodies have the pose at which this hand touches them. The others have
    //   the pose in `given`, which belongs to this scene or is empty. Valid until the next call.
    render::BodyPoses place(const render::BodyPoses& given, const render::HapticScene& scene, double now_s,
                            const Vec3& hand_m, const BodyFeel& feel) noexcept;
    Vec3 carried_m() const noexcept { return bodies_.carried_m(); }
    // 3. Returns the force of the held body on the hand, in world axes and hand newtons.
    Vec3 grip_force_n(const Vec3& hand_m, double dt_s) noexcept { return bodies_.grip_force_n(hand_m, dt_s, feel_); }
    void felt(const render::TouchResult& result) noexcept { touched_ = result; }
    // 4. Moves the bodies. Call it after the limiter has passed the share `share` of the requested force.
    void react(double share, double now_s, double dt_s) noexcept {
        bodies_.react(touched_, share, now_s, dt_s, feel_, channel_->pushes);
    }
    // Call it instead of all stages if the hand is not in the world in this tick, or if the hand's position has jumped.
    // Releases everything that the hand holds.
    void leave() noexcept;

    std::uint32_t holds() const noexcept { return bodies_.holds(); }
    std::uint32_t heavy() noexcept { return bodies_.heavy(); }
    const BodiesInReach& bodies() const noexcept { return bodies_; }

    // For recordings and for replaying them.
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
    std::vector<render::BodyPose> poses_;  // poses of the touched scene's bodies, with room for more bodies
    std::vector<char> free_;               // for each body, with room for more: 1 if the engine determines its pose
    // Number of the pose table. The first number is greater than the numbers of any playback.
    std::uint64_t number_ = std::uint64_t{1} << 40;
    std::uint64_t given_ = 0, given_ways_ = 0;  // numbers of the last argument `given`
    std::uint32_t generation_ = 0;              // scene to which the last argument `given` belonged
    render::TouchResult touched_;
    bool here_ = false, held_by_key_ = false, held_by_button_ = false;
    std::uint32_t buttons_ = 0;  // grip buttons that were pressed in the last tick
    std::int32_t quarters_ = 0;
    bool quarters_known_ = false;
};

}  // namespace handrail::servo
