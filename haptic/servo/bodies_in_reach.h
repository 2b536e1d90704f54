// One hand and the bodies that can move freely. A body that nobody touches is played back one step late and
// interpolated. A body that the hand touches, holds or is about to touch becomes a BodyModel, moved by the force of the
// same tick. The reaction on a body is exactly the force on the hand, enlarged by a constant factor. The energies of
// world and hand thus keep one ratio, and a world without motors adds none to the hand. Order in a tick: hear (if there
// is a newer frame), place, touch_tick with the output of place() and carried_m(), grip_force_n, the limiter, react.
// Servo thread; never allocates, locks, throws or reads a clock.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "haptic/render/hand_channel.h"
#include "haptic/render/touch.h"
#include "haptic/servo/body_model.h"

namespace handrail::servo {

// Tuning of the feel; it changes only while nothing is touched or held.
struct BodyFeel {
    double world_m_per_hand_m = 1.0;
    double felt_gain = 1.0 / 20.0;  // hand newtons per world newton
    double ceiling_n = 2.5;         // force ceiling of the hand
    double ball_m = 0.005;          // radius of the proxy, world
    double grip_n_per_m = 400.0;    // stiffness of the grip, hand units
    double grip_ns_per_m = 5.0;
};
// How heavy a body the person can move must not depend on how gentle a force they prefer. The ceiling therefore
// corresponds to strength_n in the world.
constexpr double felt_gain(double ceiling_n, double strength_n) noexcept {
    return (ceiling_n < 2.5 ? ceiling_n : 2.5) / strength_n;
}

class BodiesInReach {
public:
    static constexpr std::size_t kMost = render::DynamicsFrame::kNear;  // most bodies modelled at once
    static constexpr double kPlayedLate_s = 1.0 / 240.0 + 1e-3;
    static constexpr double kSilent_s = 0.25;           // a body stops after this long without data from the engine
    static constexpr double kLeaves_s = 0.1;            // a body untouched for this long is played back again
    static constexpr double kHandSpeed_m_per_s = 0.25;  // speed limit in hand units; a released body flies no faster

    explicit BodiesInReach(unsigned hand) noexcept : hand_(hand) {}

    // Null: no free bodies. The owner of the scene keeps it alive while it is set here. Allocates room for its bodies,
    // so call it before the servo's first tick in that world.
    void enter(const render::DynamicsScene* scene);
    // Lets go of everything and discards all frames; knows nothing until the next frame of the same scene.
    void forget() noexcept;
    void hear(const render::DynamicsFrame& frame) noexcept;
    // Makes the next place() write the poses of all bodies, because the table they are written to is new.
    void show_all() noexcept { shown_all_ = false; }
    // Writes where the free bodies are in this tick to their places in `bodies` (HapticScene::bodies), a table that
    // keeps its content between calls. The body that this hand holds is marked as absent for this hand's proxy. Returns
    // true if any free body is not where it was in the last tick. Looks only at the bodies that moved in the last
    // frames and those that this hand has a model of, so a resting body costs nothing.
    bool place(double now_s, const Vec3& hand_m, const BodyFeel& feel, std::span<render::BodyPose> bodies) noexcept;
    // How far the touched body moved its contact point since the last tick. Damping acts on the hand's speed relative
    // to the body.
    Vec3 carried_m() const noexcept { return carried_m_; }

    // Takes hold of the touched body, or else of the nearest one within two radii of the proxy. Returns kNoBody if
    // there is none.
    std::uint32_t take(double now_s, const Vec3& hand_m, const BodyFeel& feel) noexcept;
    void let_go(const BodyFeel& feel) noexcept;
    // Turns the held body, for example by a quarter turn about a world axis when a key is pressed. Does nothing for a
    // ball.
    void turn_held(const Rotation& by) noexcept;
    std::uint32_t holds() const noexcept { return holding_ ? slots_[held_].model.body() : render::kNoBody; }
    // Force of the grip on the hand in hand newtons, at most the ceiling: above it the grip slips.
    Vec3 grip_force_n(const Vec3& hand_m, double dt_s, const BodyFeel& feel) noexcept;

    // Call it after the limiter let `share` (0 to 1) of the tick's force through. Advances the models to now_s + dt_s
    // and sends the pushes to the engine.
    void react(const render::TouchResult& touch, double share, double now_s, double dt_s, const BodyFeel& feel,
               render::HandPushRing& pushes) noexcept;

    // For recordings: one bit for each model whose push did not fit into the ring since the last call. Such a push is
    // kept and sent with the next one.
    std::uint32_t take_refused() noexcept { return std::exchange(refused_, 0U); }
    // For replaying such a tick with a ring that had room for all: takes a push back. Returns false if the push is not
    // one of the refused.
    bool take_back(std::uint32_t refused, const render::HandPush& push) noexcept;

    // Returns, once, a body that was pushed or lifted with all available force and did not move; kNoBody: none. It is
    // announced with its weight.
    std::uint32_t heavy() noexcept;
    // The active models, for measuring; null for an index without one.
    const BodyModel* model(std::size_t i) const noexcept {
        return i < kMost && slots_[i].used ? &slots_[i].model : nullptr;
    }
    const BodyModel* model_of(std::uint32_t body) const noexcept;
    // Number of bodies that the next place() looks at, not counting those with a model; for measuring.
    std::size_t lively() const noexcept { return shown_all_ ? lively_.size() : shown_.size(); }
    // Returns true if no body is touched, held or about to be.
    bool idle() const noexcept {
        for (const Slot& slot : slots_)
            if (slot.used) return false;
        return true;
    }

private:
    struct Slot {
        bool used = false;
        BodyModel model;
        double touched_s = -1e300;
        Placement shown;  // pose of the body's frame in this tick
        Vec3 contact_m{0.0};
        bool contact = false;                  // contact_m comes from the last tick
        Vec3 unsent_ns{0.0}, unsent_nms{0.0};  // impulses that did not fit into the ring yet
        // For how long a push has moved nothing, and from where.
        double strained_s = 0.0;
        Vec3 strained_from_m{0.0};
        bool said = false;
    };
    struct Played {
        double time_s = -1e300;
        std::vector<Placement> things;
    };

    BodyModel::State played(std::size_t body, double play_s) const noexcept;
    Slot* slot_of(std::uint32_t body) noexcept;
    void moved(std::uint32_t body) noexcept;
    bool show(std::uint32_t body, Slot* slot, double now_s, const BodyFeel& feel,
              std::span<render::BodyPose> bodies) noexcept;
    void open(const render::RigidBodyState& word, double now_s) noexcept;
    void strain(Slot& slot, double force_n, double dt_s, const BodyFeel& feel) noexcept;
    void send(Slot& slot, render::HandPush push, render::HandPushRing& pushes) noexcept;
    static void keep(Slot& slot, const render::HandPush& push) noexcept;
    Vec3 grip_point_m() const noexcept;
    Vec3 wrist_nm() const noexcept;

    unsigned hand_;
    const render::DynamicsScene* scene_ = nullptr;
    std::uint32_t game_ = 0;
    std::array<Played, 4> frames_{};  // ring; newest_ is the last
    std::size_t newest_ = 0, known_ = 0;
    std::uint64_t number_ = 0;  // DynamicsFrame::number of the newest
    std::uint64_t heard_ = 0;   // number of frames received so far
    // Bodies that moved within the ring. All frames of the ring agree about any other body, and it was shown there.
    std::vector<std::uint32_t> lively_;
    // For each body the value of heard_ when it last moved; 0: it is not in lively_.
    std::vector<std::uint64_t> moved_at_;
    std::array<render::RigidBodyState, kMost> words_{};
    std::size_t word_count_ = 0;
    std::array<Slot, kMost> slots_{};
    std::vector<Placement> shown_;
    bool shown_all_ = false;
    Vec3 carried_m_{0.0};

    bool holding_ = false, letting_go_ = false;
    std::size_t held_ = 0;
    Vec3 grip_own_m_{0.0};     // in the body's frame
    Vec3 grip_offset_m_{0.0};  // from there to the hand, world, so that a body does not jump to the hand when taken
    Vec3 grip_force_n_{0.0};
    Rotation grip_turn_;
    Vec3 last_hand_m_{0.0}, hand_m_per_s_{0.0};
    bool has_hand_ = false;
    std::uint32_t heavy_ = render::kNoBody;
    std::uint32_t refused_ = 0;
    double most_speed_m_per_s_ = 0.0;
};

}  // namespace handrail::servo
