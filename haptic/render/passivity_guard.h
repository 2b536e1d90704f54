// Implements time-domain passivity control (Hannaford & Ryu, Time-domain passivity control of haptic interfaces, 2002).
// PassivityGuard measures the energy that the held force gives to the hand during a touch, from the measured positions
// and the force that the motor really gave. It adds damping if the hand gets more energy than it gave. The filter pole,
// the allowance and the bound on the surface's own damping prevent force steps, which the published form does not. That
// form cost up to 0.29 N per tick on a clean sweep, and on a surface damped by 2 Ns/m or more it allowed no stiffer
// wall (docs/results.md). Plain state of TouchState; noexcept, no allocation; about 20 flops a tick while it watches a
// touch, none otherwise.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "haptic/render/tick_assert.h"
#include "worlds/base/vec.h"

namespace handrail::render {

class PassivityGuard {
public:
    // Damping of a surface from which on the guard would add nothing useful.
    static constexpr double kNotNeeded_ns_per_m = 2.0;

    // Returns the damping to add now, in Ns/m. `own_step_m` is the displacement of the hand since the last tick, in
    // hand metres. `delay_s` is the delay from the end of the hold until the hand feels a force.
    double watch(const Vec3& own_step_m, double dt_s, double delay_s) noexcept {
        tick_assert(dt_s > 0.0 && delay_s >= 0.0);
        const auto late = static_cast<std::size_t>(std::clamp(delay_s / dt_s + 0.5, 0.0, kMostLate - 1.0));
        energy_j_ -= glm::dot(given_n_[(newest_ + kMostLate - late) % kMostLate], own_step_m);
        const double lacking_j = -kAllowance_j - energy_j_;
        const double speed2 = glm::dot(own_step_m, own_step_m) / (dt_s * dt_s);
        double wanted = 0.0;
        if (lacking_j > 0.0)
            wanted = speed2 > 0.0 ? std::min(lacking_j / (dt_s * speed2), kMost_ns_per_m) : damping_ns_per_m_;
        damping_ns_per_m_ += (wanted - damping_ns_per_m_) * (dt_s / (kPole_s + dt_s));
        tick_assert(damping_ns_per_m_ >= 0.0 && damping_ns_per_m_ <= kMost_ns_per_m);
        return damping_ns_per_m_;
    }
    // Records the force that the motor gives in this tick.
    void given(const Vec3& force_n) noexcept {
        newest_ = (newest_ + 1) % kMostLate;
        given_n_[newest_] = force_n;
    }
    // Starts the count of energy again, for a new contact.
    void reset() noexcept {
        energy_j_ = 0.0;
        damping_ns_per_m_ = 0.0;
    }

private:
    static constexpr double kMost_ns_per_m = 20.0;
    static constexpr double kPole_s = 0.02;
    // Energy that the steps of a held force may give to the hand without added damping.
    static constexpr double kAllowance_j = 1e-3;
    static constexpr std::size_t kMostLate = 16;  // greatest delay of the force that is supported, in ticks

    double energy_j_ = 0.0;  // energy taken from the hand since the contact began; negative: energy given to it
    double damping_ns_per_m_ = 0.0;
    std::array<Vec3, kMostLate> given_n_{};
    std::size_t newest_ = 0;
};

}  // namespace handrail::render
