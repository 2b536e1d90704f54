// Implements the servo's own model of one body that a hand touches or holds. In every tick BodyModel is moved by
// exactly the force that the hand feels, by gravity, and by the contact planes that the engine sent last. Later
// messages of the engine correct it. If the hand touched the delayed poses of the engine, it would gain unbounded
// energy; a model that moves in the same tick gives none. Plain state; real-time safe; + - x / and square root only.
// Cost for different numbers of contacts: docs/results.md. Sources: Stewart & Trinkle 1996 (contacts as impulses);
// Catto, Iterative dynamics with temporal coherence, 2005 (sequential impulses, warm start).
#pragma once

#include <array>
#include <cstdint>

#include "haptic/render/rigid_body_state.h"

namespace handrail::servo {

class BodyModel {
public:
    // The pose and velocity of the body at one moment.
    struct State {
        double time_s = 0.0;
        Placement at;  // pose of the body's frame (see RigidBodyState::at)
        Vec3 speed_m_per_s{0.0}, turn_rad_per_s{0.0};
    };

    // Starts the model from a message of the engine. `seen` is the state of the body that the hand has touched until
    // now. The model corrects the difference between both over kCorrect_s.
    void begin(const render::RigidBodyState& reported, const State& seen) noexcept;
    // Accepts a message about a moment within the last kHistory ticks. An earlier moment, or a moment after the model's
    // time, is accepted too. The times of the messages must rise.
    void hear(const render::RigidBodyState& reported) noexcept;
    // Computes one tick, starting at the state's time. `force_n` is in world newtons; `moment_nm` is about the centre
    // of mass.
    void tick(const Vec3& force_n, const Vec3& moment_nm, double dt_s) noexcept;
    // Stops the body until the next message, because the engine has sent none for too long.
    void rest() noexcept;
    void limit_speed(double most_m_per_s) noexcept;

    const State& state() const noexcept { return state_; }
    double reported_s() const noexcept { return reported_.time_s; }
    std::uint32_t body() const noexcept { return reported_.body; }
    const render::RigidBodyState& reported() const noexcept { return reported_; }
    Vec3 speed_at(const Vec3& world_m) const noexcept {
        return state_.speed_m_per_s + glm::cross(state_.turn_rad_per_s, world_m - state_.at.position_m);
    }
    // Returns the distance between the engine's last message and the model's state at the same moment.
    double apart_m() const noexcept { return apart_m_; }

    static constexpr double kCorrect_s = 0.03;
    static constexpr std::size_t kHistory = 64;
    static constexpr int kRounds = 12;

private:
    struct Point;  // a contact prepared for the solver iterations of one tick
    void correct(double dt_s) noexcept;
    void solve(double dt_s) noexcept;

    State state_;
    render::RigidBodyState reported_;
    std::array<State, kHistory> history_{};  // a ring; every correction shifts all of its states
    std::size_t first_ = 0, count_ = 0;
    std::array<Vec3, render::RigidBodyState::kMostPlanes>
        impulse_{};  // for each contact, the impulses of the last tick along the normal and two tangents
    render::Stick stick_;
    Vec3 owed_m_{0.0}, owed_m_per_s_{0.0}, owed_rad_{0.0}, owed_rad_per_s_{0.0};
    double apart_m_ = 0.0;
};

}  // namespace handrail::servo
