// Contains facts about device models, as a table with one row per model. Each row names its sources. Immutable; any
// thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::device {

struct DeviceSpec {
    std::string_view name;      // name of the model for `--device`, in any case: "sim-t", "falcon"
    double peak_force_n = 0.0;  // greatest force; infinity: no limit
    // Stiffness of a wall with fraction 1.0, before the formula for the delay reduces it.
    double rated_stiffness_n_per_m = 1000.0;
    double workspace_radius_m = 0.08;  // radius of the largest sphere that the hand can reach, device frame
    double device_damping_ns_per_m = 0.2;
    // t_d: time from reading the position until the force acts on the hand, without the half period for which the force
    // is held on average.
    double delay_s = 1e-3;
    double min_rate_hz = 600.0;      // if the device answers more slowly for 20 ms, the force fades out; 0: no limit
    double encoder_quantum_m = 0.0;  // step of the measured position along each axis; 0: unknown, or no steps
    bool kinesthetic = true;
    // Root mean square force over ten seconds that the motors tolerate, as a share of the peak force.
    double sustained_share = 0.8;

    std::string spoken_name() const;  // returns a name such as "simulated Touch"; not for the servo thread
};

std::span<const DeviceSpec> device_specs();
// Finds a model by its name, in any case. Returns nullptr if the name is unknown.
const DeviceSpec* find_device_spec(std::string_view name);
std::vector<std::string> device_names();
// Returns a device without limits and with a rated stiffness of 1000 N/m. `touch` replays use it by default.
const DeviceSpec& ideal_device_spec();

// Returns the stiffness in N per hand metre that a fraction of 1 stands for: min(rating, 0.5 b_eff / (T/2 + t_d) / 0.8)
// with b_eff = b_device + 1 Ns/m of a light grip + 0.7 B. Because of the division by 0.8, the default wall (fraction
// 0.8) has half the highest stiffness that stayed stable in simulations of a hand, a held force and a delay. A wall
// with fraction 1 has five eighths of that stiffness.
// - period_s: T, the measured time between device answers, > 0.
// - damping_ns_per_m: B, the damping that the renderer adds along the normal, >= 0.
// Sources: Colgate & Schenkel, Passivity of a class of sampled-data systems, 1997; Diolaiti et al., Stability of haptic
// rendering, 2006.
double effective_stiffness_n_per_m(const DeviceSpec& spec, double period_s, double damping_ns_per_m) noexcept;

}  // namespace handrail::device
