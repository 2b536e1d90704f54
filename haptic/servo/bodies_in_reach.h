// Connects one hand with the free bodies. A body that nobody touches is played back one step late, with interpolated
// poses. A body that the hand touches, holds or is about to touch becomes a BodyModel, which the force of the same tick
// moves. The reaction on a body is exactly the force on the hand, enlarged by a constant factor. The energies of world
// and hand thus keep a constant ratio, and a world without motors gives the hand no energy.
//
// In each tick the servo calls: hear() if there is a newer frame, place(), touch_tick() with the output of place() and
// carried_m(), grip_force_n(), the limiter, and react(). Servo thread; never allocates, locks, throws or reads a clock.
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

// Tuning of how bodies feel. The tuning changes only while no body is touched or held.
struct BodyFeel {
    double world_m_per_hand_m = 1.0;
    double felt_gain = 1.0 / 20.0;  // force on the hand per force in the world, newtons per newton
    double ceiling_n = 2.5;         // greatest force on the hand
    double proxy_radius_m = 0.005;  // radius of the proxy in the world
    double grip_n_per_m = 400.0;    // stiffness of the grip, N per hand metre
    double grip_ns_per_m = 5.0;
};
// Returns the factor from world newtons to hand newtons, with which `strength_n` in the world is felt as the ceiling at
// the hand. How heavy a body the person can move thus does not depend on how gentle a force they prefer.
constexpr double felt_gain(double ceiling_n, double strength_n) noexcept {
    return (ceiling_n < 2.5 ? ceiling_n : 2.5) / strength_n;
}

class BodiesInReach {
public:
    // Greatest number of bodies with a model at once.
    static constexpr std::size_t kMost = render::DynamicsFrame::kNear;
    static constexpr double kPlayedLate_s = 1.0 / 240.0 + 1e-3;
    static constexpr double kSilent_s = 0.25;  // time without data from the engine after which a model stops its body
    static constexpr double kLeaves_s = 0.1;   // time without a touch after which a body is played back again
    static constexpr double kHandSpeed_m_per_s = 0.25;  // speed limit in hand metres; a released body flies no faster

    explicit BodiesInReach(unsigned hand) noexcept : hand_(hand) {}

    // Enters a world; null: the world has no free bodies. The owner of the scene keeps the scene alive until the next
    // call. Allocates room for the scene's bodies, so call it before the servo's first tick in that world.
    void enter(const render::DynamicsScene* scene);
    // Releases the held body, ends all models and discards all frames. No pose is known until the next frame of the
    // same scene.
    void forget() noexcept;
    void hear(const render::DynamicsFrame& frame) noexcept;
    // Makes the next place() write the poses of all bodies, because they go into a new table.
    void show_all() noexcept { shown_all_ = false; }
    // Writes the poses of the free bodies in this tick to `bodies` (indices of HapticScene::bodies), a table that keeps
    // its content between calls. The body that this hand holds is written as absent, so that this hand's proxy does not
    // touch it. Returns true if any free body has moved since the last tick. Examines only the bodies that moved in the
    // last frames and those with a model, so a resting body costs nothing.
    bool place(double now_s, const Vec3& hand_m, const BodyFeel& feel, std::span<render::BodyPose> bodies) noexcept;
    // Returns how far the motion of the touched body has moved the contact point since the last tick. Damping acts on
    // the hand's velocity relative to the body.
    Vec3 carried_m() const noexcept { return carried_m_; }

    // Grips the touched body. If none is touched, grips the nearest body within two radii of the proxy. Returns the
    // body's index, or kNoBody if there is none.
    std::uint32_t take(double now_s, const Vec3& hand_m, const BodyFeel& feel) noexcept;
    void let_go(const BodyFeel& feel) noexcept;
    // Rotates the held body, for example by a quarter turn about a world axis when a key is pressed. Does nothing for a
    // ball.
    void turn_held(const Rotation& by) noexcept;
    std::uint32_t holds() const noexcept { return holding_ ? slots_[held_].model.body() : render::kNoBody; }
    // Returns the force of the grip on the hand in hand newtons. Above the ceiling, the grip slips.
    Vec3 grip_force_n(const Vec3& hand_m, double dt_s, const BodyFeel& feel) noexcept;

    // Call it after the limiter has passed the share `share` (0 to 1) of the tick's force. Advances the models to now_s
    // + dt_s and sends their pushes to the engine.
    void react(const render::TouchResult& touch, double share, double now_s, double dt_s, const BodyFeel& feel,
               render::HandPushRing& pushes) noexcept;

    // For recordings: returns one bit for each model whose push had no room in the ring since the last call. The model
    // keeps the refused push and sends it with the next one.
    std::uint32_t take_refused() noexcept { return std::exchange(refused_, 0U); }
    // For replaying a tick in which the ring had no room for a push, with a ring that has room for all pushes: removes
    // the push again. Returns false if the push is not one of the refused ones.
    bool take_back(std::uint32_t refused, const render::HandPush& push) noexcept;

    // Returns, once, a body that did not move although the hand pushed or lifted it with all available force; kNoBody:
    // none. The app announces the body and its weight.
    std::uint32_t heavy() noexcept;
    // For measuring: returns model i if it is active, otherwise null.
    const BodyModel* model(std::size_t i) const noexcept {
        return i < kMost && slots_[i].used ? &slots_[i].model : nullptr;
    }
    const BodyModel* model_of(std::uint32_t body) const noexcept;
    // For measuring: the number of bodies without a model that the next place() examines.
    std::size_t lively() const noexcept { return shown_all_ ? lively_.size() : shown_.size(); }
    // Returns true if no body is touched, held or about to be touched.
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
        bool contact = false;                  // contact_m is the contact point of the last tick
        Vec3 unsent_ns{0.0}, unsent_nms{0.0};  // impulses for which the ring had no room yet
        // Time for which a push has moved nothing, and the body's position when the push began.
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
    void open(const render::RigidBodyState& reported, double now_s) noexcept;
    void strain(Slot& slot, double force_n, double dt_s, const BodyFeel& feel) noexcept;
    void send(Slot& slot, render::HandPush push, render::HandPushRing& pushes) noexcept;
    static void keep(Slot& slot, const render::HandPush& push) noexcept;
    Vec3 grip_point_m() const noexcept;
    Vec3 wrist_nm() const noexcept;

    unsigned hand_;
    const render::DynamicsScene* scene_ = nullptr;
    std::uint32_t game_ = 0;
    std::array<Played, 4> frames_{};  // a ring; newest_ is the index of the newest frame
    std::size_t newest_ = 0, known_ = 0;
    std::uint64_t number_ = 0;  // DynamicsFrame::number of the newest frame
    std::uint64_t heard_ = 0;   // number of frames received so far
    // Bodies that moved in the frames of the ring. For any other body all these frames have the same pose, and place()
    // has already written that pose.
    std::vector<std::uint32_t> lively_;
    // For each body, the value of heard_ when it last moved; 0 if it is not in lively_.
    std::vector<std::uint64_t> moved_at_;
    std::array<render::RigidBodyState, kMost> reported_{};
    std::size_t reported_count_ = 0;
    std::array<Slot, kMost> slots_{};
    std::vector<Placement> shown_;
    bool shown_all_ = false;
    Vec3 carried_m_{0.0};

    bool holding_ = false, letting_go_ = false;
    std::size_t held_ = 0;
    Vec3 grip_own_m_{0.0};  // gripped point, in the body's frame
    // Vector in the world from the gripped point to the hand. Because of this offset, a body does not jump to the hand
    // when it is gripped.
    Vec3 grip_offset_m_{0.0};
    Vec3 grip_force_n_{0.0};
    Rotation grip_turn_;
    Vec3 last_hand_m_{0.0}, hand_m_per_s_{0.0};
    bool has_hand_ = false;
    std::uint32_t heavy_ = render::kNoBody;
    std::uint32_t refused_ = 0;
    double most_speed_m_per_s_ = 0.0;
};

}  // namespace handrail::servo
