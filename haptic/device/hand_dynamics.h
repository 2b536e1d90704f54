// The mechanics of a hand on a force-feedback device: one mass with damping, a spring towards where the hand wants to
// be, dry friction and end stops. It also delays the force on its way to the motor. The simulated device and the
// closed-loop simulation share it, so that studies and scenarios use the same hand. Plain state, no thread of its own;
// noexcept, no allocation. Metres, newtons, seconds, kilograms.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "worlds/base/vec.h"

namespace handrail::device {

struct HandMechanics {
    double mass_kg = 0.4;                                      // hand and device together
    double damping_ns_per_m = 3.2;                             // hand and device together
    double spring_n_per_m = 0.0;                               // towards the hand's target
    double dry_friction_n = 0.05;                              // of the device
    double reach_m = std::numeric_limits<double>::infinity();  // end stops: radius of a sphere around zero
};

struct HandBody {
    Vec3 position_m{0.0};
    Vec3 velocity_m_per_s{0.0};
};

// One step of semi-implicit Euler; step_s at most 0.1 ms for the masses and stiffnesses of hands. force_n: of motor and
// arm together.
void advance_hand(HandBody& hand, const HandMechanics& mechanics, const Vec3& target_m, const Vec3& force_n,
                  double step_s) noexcept;

// The position as an encoder reports it: the nearest whole step along each axis. quantum_m <= 0: the position itself.
Vec3 encoded_m(const Vec3& position_m, double quantum_m) noexcept;

// Commanded forces that the motor gives later. If more than kMost are pending, the oldest is dropped.
class HeldForces {
public:
    static constexpr std::size_t kMost = 64;  // 64 ms of delay at 1 kHz

    void give(double from_s, const Vec3& force_n) noexcept;
    // The newest force that is due; the last one is held.
    Vec3 at(double time_s) noexcept;
    // Zero force, nothing pending.
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
