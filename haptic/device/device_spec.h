// Facts about device models as data: one row per model, no code. Sources are next to each row. Immutable, any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::device {

struct DeviceSpec {
    std::string_view name;                    // as `--device` accepts it, case-insensitive: "sim-t", "falcon"
    double peak_force_n = 0.0;                // infinity: no limit
    double rated_stiffness_n_per_m = 1000.0;  // stiffness that a fraction of 1.0 stands for, before the delay formula
    double workspace_radius_m = 0.08;         // of the largest sphere that the hand can reach, device frame
    double device_damping_ns_per_m = 0.2;
    double delay_s = 1e-3;           // t_d: from reading the position to the force on the hand, beyond the hold
    double min_rate_hz = 600.0;      // a slower rate for 20 ms fades the force; 0: no limit
    double encoder_quantum_m = 0.0;  // step of the measured position along each axis; 0: unknown or none
    bool kinesthetic = true;
    // Share of the peak force that the motors bear as root mean square over ten seconds.
    double sustained_share = 0.8;

    std::string spoken_name() const;  // such as "simulated Touch"; not on the servo's thread
};

std::span<const DeviceSpec> device_specs();
// Case-insensitive; nullptr if unknown.
const DeviceSpec* find_device_spec(std::string_view name);
std::vector<std::string> device_names();
// No limits at all, rating 1000 N/m: the default of `touch` replays.
const DeviceSpec& ideal_device_spec();

// The stiffness, in N per hand metre, that a fraction of 1 stands for: min(rating, 0.5 b_eff / (T/2 + t_d) / 0.8) with
// b_eff = b_device + 1 Ns/m of a light grip + 0.7 B. Dividing by 0.8 puts the default wall (fraction 0.8) at half the
// highest stiffness that stayed stable in simulations of a hand, a held force and a delay. A full wall (fraction 1) is
// then at five eighths of it. period_s: measured time between device answers, > 0. damping_ns_per_m: B that the
// renderer adds along the normal, >= 0. Sources: Colgate & Schenkel, Passivity of a class of sampled-data systems,
// 1997; Diolaiti et al., Stability of haptic rendering, 2006.
double effective_stiffness_n_per_m(const DeviceSpec& spec, double period_s, double damping_ns_per_m) noexcept;

}  // namespace handrail::device
