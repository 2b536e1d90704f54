// Facts about device models as data: one row per model, no code. Sources stand beside each row.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>
#include <string>

namespace handrail {

struct DeviceSpec {
    std::string_view name;                     // as `--device` takes it, case-insensitive: "sim-t", "falcon"
    std::string_view spoken_name;              // "simulated Touch"
    double peak_force_n = 0.0;                 // infinity: none
    double rated_stiffness_n_per_m = 1000.0;   // the 1.0 of every stiffness fraction, before the delay formula
    double workspace_radius_m = 0.08;          // of a sphere the hand reaches, device frame
    double device_damping_ns_per_m = 0.2;
    double delay_s = 1e-3;                     // t_d: from position read to force on the hand beyond the hold
    double min_rate_hz = 600.0;                // slower than this for 20 ms fades the force
    double encoder_quantum_m = 0.0;
    bool kinesthetic = true;
};

std::span<const DeviceSpec> device_specs();
// Exact, case-insensitive; nullptr when unknown.
const DeviceSpec* find_device_spec(std::string_view name);
std::vector<std::string> device_names();
// No limits at all, rating 1000 N/m: what `touch` replays with by default.
const DeviceSpec& ideal_device_spec();

}  // namespace handrail
