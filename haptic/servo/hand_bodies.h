// One hand and the bodies that are free to move. What nobody touches is played back a step late, interpolated; what the
// hand touches, holds or is about to touch is a HeldBody, moved under the force of the same tick. The reaction on a
// body is the very force on the hand, made larger by a constant: so the world's energy and the hand's keep one
// proportion, and a world without engines gives the hand none. In a tick, in this order: hear (where there is a newer
// frame), place, touch_tick with what place() wrote and carried_m(), grip_force_n, the limiter, react. Servo thread;
// never allocates, locks, throws or reads a clock.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "haptic/render/hand_channel.h"
#include "haptic/render/touch.h"
#include "haptic/servo/held_body.h"

namespace handrail {

// Changes only while nothing is touched or held.
struct BodyFeel {
    double world_m_per_hand_m = 1.0;
    double felt_gain = 1.0 / 20.0;  // hand newtons per world newton
    double ceiling_n = 2.5;         // of the hand
    double ball_m = 0.005;          // radius, world
    double grip_n_per_m = 400.0;    // of the hand
    double grip_ns_per_m = 5.0;
};
// What can be moved does not depend on how gently one wants to be touched: the ceiling stands for strength_n.
constexpr double felt_gain(double ceiling_n, double strength_n) noexcept {
    return (ceiling_n < 2.5 ? ceiling_n : 2.5) / strength_n;
}

class HandBodies {
public:
    static constexpr std::size_t kMost = DynamicsFrame::kNear;  // modelled at once
    static constexpr double kPlayedLate_s = 1.0 / 240.0 + 1e-3;
    static constexpr double kSilent_s = 0.25;           // after so long without a word a body stands still
    static constexpr double kLeaves_s = 0.1;            // untouched for so long it is played back again
    static constexpr double kHandSpeed_m_per_s = 0.25;  // of the hand: a body let go flies no faster

    explicit HandBodies(unsigned hand) noexcept : hand_(hand) {}

    // Null: no free bodies. Whoever owns the scene keeps it for as long as it is set here. Allocates room for its
    // bodies, so it is called before the servo's first tick in that world.
    void enter(const DynamicsScene* scene);
    // Lets go of everything and knows nothing until the next frame, in the same scene.
    void forget() noexcept;
    void hear(const DynamicsFrame& frame) noexcept;
    // The next place() writes the places of all bodies: what they are written to has been made anew.
    void show_all() noexcept { shown_all_ = false; }
    // Where the free bodies are on this tick, written to their places among `bodies` (HapticScene::bodies), which keep
    // what was written; what is held is not there for this hand's ball. True when any of them is elsewhere than on the
    // last tick. Looks only at what moved in the last frames and at what this hand has a model of: a body that rests
    // costs nothing.
    bool place(double now_s, const Vec3& hand_m, const BodyFeel& feel, std::span<BodyPose> bodies) noexcept;
    // How far the touched body carried its contact since the last tick: damping is of the hand against the body.
    Vec3 carried_m() const noexcept { return carried_m_; }

    // Takes hold of what is touched, or else of what is nearest within two radii of the ball; kNoBody where there is
    // nothing.
    std::uint32_t take(double now_s, const Vec3& hand_m, const BodyFeel& feel) noexcept;
    void let_go(const BodyFeel& feel) noexcept;
    // Turns what is held: a quarter turn about a world axis, as by keys. Nothing for a ball.
    void turn_held(const Rotation& by) noexcept;
    std::uint32_t holds() const noexcept { return holding_ ? slots_[held_].model.body() : kNoBody; }
    // On the hand, hand newtons, no more than the ceiling: above it the grip slips.
    Vec3 grip_force_n(const Vec3& hand_m, double dt_s, const BodyFeel& feel) noexcept;

    // After the limiter let `share` of the tick's force through, 0 to 1: moves the models on to now_s + dt_s and tells
    // the engine.
    void react(const TouchResult& touch, double share, double now_s, double dt_s, const BodyFeel& feel,
               HandPushRing& pushes) noexcept;

    // For a recording: of which models a push found no room since this was asked last, a bit each; it was kept for the
    // next one.
    std::uint32_t take_refused() noexcept { return std::exchange(refused_, 0U); }
    // For computing such a tick again, whose ring had room for all: takes back a push of one of them. False: of none.
    bool take_back(std::uint32_t refused, const HandPush& push) noexcept;

    // A body that was pushed or lifted with all there is and did not move, once; kNoBody: none. To be said with its
    // weight.
    std::uint32_t heavy() noexcept;
    // The models that run, for measuring; null beyond.
    const HeldBody* model(std::size_t i) const noexcept {
        return i < kMost && slots_[i].used ? &slots_[i].model : nullptr;
    }
    const HeldBody* model_of(std::uint32_t body) const noexcept;
    // Bodies that the next place() looks at, without those that have a model; for measuring.
    std::size_t lively() const noexcept { return shown_all_ ? lively_.size() : shown_.size(); }
    // Nothing is touched, held or about to be.
    bool idle() const noexcept {
        for (const Slot& slot : slots_)
            if (slot.used) return false;
        return true;
    }

private:
    struct Slot {
        bool used = false;
        HeldBody model;
        double touched_s = -1e300;
        Placement shown;  // on this tick, of the body's frame
        Vec3 contact_m{0.0};
        bool contact = false;                  // contact_m is of the last tick
        Vec3 unsent_ns{0.0}, unsent_nms{0.0};  // what did not fit into the ring
        // A push that moves nothing.
        double strained_s = 0.0;
        Vec3 strained_from_m{0.0};
        bool said = false;
    };
    struct Played {
        double time_s = -1e300;
        std::vector<Placement> things;
    };

    HeldBody::State played(std::size_t body, double play_s) const noexcept;
    Slot* slot_of(std::uint32_t body) noexcept;
    void moved(std::uint32_t body) noexcept;
    bool show(std::uint32_t body, Slot* slot, double now_s, const BodyFeel& feel, std::span<BodyPose> bodies) noexcept;
    void open(const BodyWord& word, double now_s) noexcept;
    void strain(Slot& slot, double force_n, double dt_s, const BodyFeel& feel) noexcept;
    void send(Slot& slot, HandPush push, HandPushRing& pushes) noexcept;
    static void keep(Slot& slot, const HandPush& push) noexcept;
    Vec3 grip_point_m() const noexcept;
    Vec3 wrist_nm() const noexcept;

    unsigned hand_;
    const DynamicsScene* scene_ = nullptr;
    std::uint32_t game_ = 0;
    std::array<Played, 4> frames_{};  // ring, newest_ the last
    std::size_t newest_ = 0, known_ = 0;
    std::uint64_t number_ = 0;  // DynamicsFrame::number of the newest
    std::uint64_t heard_ = 0;   // frames so far
    // Bodies that moved within the ring: all frames of the ring agree about any other, and it was shown there.
    std::vector<std::uint32_t> lively_;
    std::vector<std::uint64_t> moved_at_;  // of each body: heard_ when it moved last; 0: it is not among lively_
    std::array<BodyWord, kMost> words_{};
    std::size_t word_count_ = 0;
    std::array<Slot, kMost> slots_{};
    std::vector<Placement> shown_;
    bool shown_all_ = false;
    Vec3 carried_m_{0.0};

    bool holding_ = false, letting_go_ = false;
    std::size_t held_ = 0;
    Vec3 grip_own_m_{0.0};     // in the body's frame
    Vec3 grip_offset_m_{0.0};  // from there to the hand, world: what is held does not jump to it
    Vec3 grip_force_n_{0.0};
    Rotation grip_turn_;
    Vec3 last_hand_m_{0.0}, hand_m_per_s_{0.0};
    bool has_hand_ = false;
    std::uint32_t heavy_ = kNoBody;
    std::uint32_t refused_ = 0;
    double most_speed_m_per_s_ = 0.0;
};

}  // namespace handrail
