// Simulates the mechanics of a hand on a force-feedback device. The hand is one mass with damping, a spring towards its
// target, dry friction and end stops. The motor applies a commanded force after a delay. The simulated device and the
// closed-loop simulation share this code, so that studies and scenarios use the same hand. Plain state, no thread of
// its own; noexcept, no allocation. Metres, newtons, seconds, kilograms.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "worlds/base/vec.h"

namespace handrail::device {

struct HandMechanics {
    double mass_kg = 0.4;           // mass of hand and device together
    double damping_ns_per_m = 3.2;  // damping of hand and device together
    double spring_n_per_m = 0.0;    // stiffness of the spring towards the hand's target
    double dry_friction_n = 0.05;   // friction of the device
    // Radius of the sphere around the origin that the end stops form.
    double reach_m = std::numeric_limits<double>::infinity();
};

struct HandBody {
    Vec3 position_m{0.0};
    Vec3 velocity_m_per_s{0.0};
};

// Advances the hand by one step of semi-implicit Euler. `step_s` may be at most 0.1 ms for the masses and stiffnesses
// of hands. `force_n` is the sum of the motor's force and the arm's force.
void advance_hand(HandBody& hand, const HandMechanics& mechanics, const Vec3& target_m, const Vec3& force_n,
                  double step_s) noexcept;

// Returns the position as an encoder reports it, rounded to whole steps along each axis. If `quantum_m` <= 0, the
// position is not rounded.
Vec3 encoded_m(const Vec3& position_m, double quantum_m) noexcept;

// Queue of commanded forces that the motor applies later. If more than kMost are pending, the oldest is dropped.
class HeldForces {
public:
    static constexpr std::size_t kMost = 64;  // greatest number of pending forces, enough for 64 ms of delay at 1 kHz

    void give(double from_s, const Vec3& force_n) noexcept;
    // Returns the newest force that is due at `time_s`. If no force has become due since the last call, the result is
    // the same as in that call.
    Vec3 at(double time_s) noexcept;
    // Sets the force to zero and drops all pending forces.
    void clear() noexcept;

private:
    struct Held {
        double from_s = 0.0;
        Vec3 force_n{0.0};
    };
    std::array<Held, kMost> held_{};
    std::size_t first_ = 0, count_ = 0;
    Vec3 now_n_{0.0};
};

}  // namespace handrail::device
