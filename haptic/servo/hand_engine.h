// What the servo of one hand has for the free bodies of one world: its side of them, its channel to their engine, and
// the table of where everything is that moves. Made by the app, which allocates, when a world with free bodies is
// entered; from then on the servo thread's alone, one servo at a time. A world without free bodies has none.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptic/render/hand_channel.h"
#include "haptic/render/touch.h"
#include "haptic/servo/hand_bodies.h"

namespace handrail {

// What the person wants of free bodies. As a part of ServoTuning it comes from the app.
struct BodyTuning {
    double strength_n = 50.0;        // of the person in the world; it stands for 2.5 N of the hand (felt_gain)
    bool hold = false;               // by a key: takes hold of what is touched, and lets go with false
    std::uint32_t grip_buttons = 0;  // of the device: held, they hold what was touched when they were pressed; 0: none
    std::int32_t quarters = 0;       // turns of what is held, to the left, counted since the start
};

class HandEngine {
public:
    static constexpr std::size_t kMoreBodies = 256;  // that may be set down in a world later

    // hand: 0 or 1. bodies: of the felt scene (HapticScene::bodies). Allocates.
    HandEngine(std::shared_ptr<const DynamicsScene> scene, std::shared_ptr<HandChannel> channel, unsigned hand,
               std::size_t bodies);
    HandEngine(const HandEngine&) = delete;
    HandEngine& operator=(const HandEngine&) = delete;

    // The stages of a tick, in this order (servo_tick). None allocates, locks, throws or reads a clock.
    // 1. By button or key. True: a button that is held is the grip's, and nobody else's.
    bool grip(const BodyTuning& tuning, std::uint32_t buttons, double now_s, const Vec3& hand_m) noexcept;
    // 2. Where all bodies are: free ones as this hand meets them, the others as told (of the scene, or nothing).
    // Good until the next call.
    BodyPoses place(const BodyPoses& told, const HapticScene& scene, double now_s, const Vec3& hand_m,
                    const BodyFeel& feel) noexcept;
    Vec3 carried_m() const noexcept { return bodies_.carried_m(); }
    // 3. On the hand, world axes, hand newtons: of what it holds.
    Vec3 grip_force_n(const Vec3& hand_m, double dt_s) noexcept { return bodies_.grip_force_n(hand_m, dt_s, feel_); }
    void felt(const TouchResult& result) noexcept { touched_ = result; }
    // 4. After the limiter let that share of the wanted force through.
    void react(double share, double now_s, double dt_s) noexcept {
        bodies_.react(touched_, share, now_s, dt_s, feel_, channel_->pushes);
    }
    // Instead of all that: the hand is not in the world on this tick, or its place has nothing to do with the one
    // before. Lets go of everything.
    void leave() noexcept;

    std::uint32_t holds() const noexcept { return bodies_.holds(); }
    std::uint32_t heavy() noexcept { return bodies_.heavy(); }
    const HandBodies& bodies() const noexcept { return bodies_; }

    // For a recording, and computing it again.
    HandChannel& channel() noexcept { return *channel_; }
    std::uint32_t take_refused() noexcept { return bodies_.take_refused(); }
    bool take_back(std::uint32_t refused, const HandPush& push) noexcept { return bodies_.take_back(refused, push); }

private:
    const std::shared_ptr<const DynamicsScene> scene_;
    const std::shared_ptr<HandChannel> channel_;
    HandBodies bodies_;
    BodyFeel feel_;
    std::vector<BodyPose> poses_;                    // of the felt scene's bodies, and room for more
    std::vector<char> free_;                         // likewise: the engine says where it is
    std::uint64_t number_ = std::uint64_t{1} << 40;  // of the table, beyond those of any playback
    std::uint64_t told_ = 0, told_ways_ = 0;         // numbers of what was told last
    std::uint32_t generation_ = 0;                   // of the scene it was told of
    TouchResult touched_;
    bool here_ = false, held_by_key_ = false, held_by_button_ = false;
    std::uint32_t buttons_ = 0;  // of the grip, on the last tick
    std::int32_t quarters_ = 0;
    bool quarters_known_ = false;
};

}  // namespace handrail
