#include "haptic/device/device_spec.h"

#include <array>
#include <limits>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::device {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// Data of real devices. Peak force, rated stiffness and radius come from the device profiles of CHAI3D 3.x, unless
// another source is given. Damping of 0.2 Ns/m and a delay of 1 ms are placeholders if no measurement is published. The
// encoder quantum of the Touch (450 dpi) is from its data sheet, that of the Falcon (0.06 mm at the middle) from its
// kinematics. None of these values was measured for Handrail.
constexpr std::array kSpecs{
    // A mathematical device for replays. It has no force limit and no least rate, and its forces act at once.
    DeviceSpec{"ideal", kNoLimit, 1000.0, 0.08, 0.0, 0.0, 0.0, 0.0},
    // Simulated devices: a Touch and a Falcon, with the values of their profiles.
    DeviceSpec{"sim-t", 3.3, 400.0, 0.075, 0.2, 1e-3, 600.0, 0.055e-3},
    DeviceSpec{"sim-f", 8.0, 3000.0, 0.04, 0.2, 1e-3, 600.0, 0.06e-3},
    // Real devices. 3D Systems, formerly SensAble.
    DeviceSpec{"touch", 3.3, 400.0, 0.075, 0.2, 1e-3, 600.0, 0.055e-3},
    DeviceSpec{"omni", 3.3, 700.0, 0.075, 0.2, 1e-3, 600.0, 0.055e-3},
    // The radii of the next two devices are those of spheres inside the boxes of their data sheets, 160 x 120 x 120 mm
    // and 381 x 267 x 191 mm.
    DeviceSpec{"phantom-desktop", 7.9, 1000.0, 0.06, 0.2, 1e-3, 600.0},
    DeviceSpec{"phantom-premium", 8.5, 800.0, 0.095, 0.2, 1e-3, 600.0},
    // Novint. CHAI3D rates the Falcon at 8 N and 3000 N/m. Its gain in newtons per motor count is unpublished, so an
    // uncalibrated Falcon is limited to 3 N and 1000 N/m. Its serial chip answers 300 to 1000 times a second.
    DeviceSpec{"falcon", 3.0, 1000.0, 0.04, 0.2, 1e-3, 300.0, 0.06e-3},
    // Force Dimension. The whole family shares one rated stiffness.
    DeviceSpec{"omega", 12.0, 5000.0, 0.075, 0.2, 1e-3, 600.0},
    DeviceSpec{"sigma", 12.0, 5000.0, 0.075, 0.2, 1e-3, 600.0},
    DeviceSpec{"lambda", 12.0, 5000.0, 0.112, 0.2, 1e-3, 600.0},
    DeviceSpec{"delta", 20.0, 5000.0, 0.15, 0.2, 1e-3, 600.0},
    // Haply. The maker states about 10 N for short moments and far less for long use, but publishes no rated stiffness.
    // The lower limits in this row apply until somebody measures the device.
    DeviceSpec{"inverse3", 3.0, 500.0, 0.1, 0.2, 2e-3, 300.0},
    // Any joystick with a constant-force effect. Reports say 5 to 10 N at the grip, so 3 N is below all of them. The
    // other values are guesses.
    DeviceSpec{"force-stick", 3.0, 150.0, 0.04, 0.2, 5e-3, 100.0},
    // Open hardware. Its CHAI3D fork declares 5 N and 0.1 m. The rated stiffness is a guess until somebody measures it.
    DeviceSpec{"wooden-haptics", 5.0, 1000.0, 0.1, 0.2, 1e-3, 600.0},
};

}  // namespace

std::string DeviceSpec::spoken_name() const { return phrase("device_name." + std::string(name)); }

std::span<const DeviceSpec> device_specs() { return kSpecs; }

const DeviceSpec* find_device_spec(std::string_view name) {
    const std::string wanted = lower_ascii(name);
    for (const DeviceSpec& spec : kSpecs)
        if (spec.name == wanted) return &spec;
    return nullptr;
}

std::vector<std::string> device_names() {
    std::vector<std::string> names;
    for (const DeviceSpec& spec : kSpecs) names.emplace_back(spec.name);
    return names;
}

const DeviceSpec& ideal_device_spec() { return kSpecs.front(); }

double effective_stiffness_n_per_m(const DeviceSpec& spec, double period_s, double damping_ns_per_m) noexcept {
    constexpr double kLightGripNsPerM = 1.0;
    constexpr double kDampingShare = 0.7;
    constexpr double kSafety = 0.5;
    constexpr double kDefaultWallFraction = 0.8;
    const double damping = spec.device_damping_ns_per_m + kLightGripNsPerM + kDampingShare * damping_ns_per_m;
    const double stable = kSafety * damping / (0.5 * period_s + spec.delay_s) / kDefaultWallFraction;
    return stable < spec.rated_stiffness_n_per_m ? stable : spec.rated_stiffness_n_per_m;
}

}  // namespace handrail::device
