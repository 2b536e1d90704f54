#include <nlohmann/json.hpp>

#include "app/main/commands.h"
#include "haptic/drivers/found_device.h"

namespace handrail {
namespace {

using Json = nlohmann::ordered_json;

std::string_view kind_word(DeviceKind kind) {
    switch (kind) {
        case DeviceKind::Kinesthetic:
            return "force";
        case DeviceKind::Cues:
            return "cues";
        case DeviceKind::Navigation:
            return "navigation";
    }
    return "";
}

std::string_view kind_sentence(DeviceKind kind) {
    switch (kind) {
        case DeviceKind::Kinesthetic:
            return "It pushes the hand in space.";
        case DeviceKind::Cues:
            return "It gives cues to the fingers; it cannot stop the hand.";
        case DeviceKind::Navigation:
            return "It moves you through the world; it gives no force.";
    }
    return "";
}

// What is not known is null, so that nobody takes 0 for a fact.
Json known(double value) { return value > 0.0 && std::isfinite(value) ? Json(value) : Json(nullptr); }
Json known(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json json_of(const FoundDevice& device) {
    return {{"name", device.name},
            {"model", device.model},
            {"kind", kind_word(device.kind)},
            {"driver", device.driver},
            {"connection", device.connection},
            {"serial", known(device.serial)},
            {"firmware", known(device.firmware)},
            {"calibration", known(device.calibration)},
            {"workspace_radius_m", known(device.spec ? device.spec->workspace_radius_m : 0.0)},
            {"force_limit_n", known(device.spec ? device.spec->peak_force_n : 0.0)},
            {"stiffness_limit_n_per_m", known(device.spec ? device.spec->rated_stiffness_n_per_m : 0.0)},
            {"slowest_rate_hz", known(device.spec ? device.spec->min_rate_hz : 0.0)},
            {"rate_hz", known(device.rate_hz)},
            {"state", device_state(device)},
            {"usable", device.usable},
            {"problem", known(device.problem)}};
}

void tell(const FoundDevice& device, std::ostream& out) {
    out << fmt::format("{}, called {}, on {}. {}\n", device.model, device.name, device.connection, kind_sentence(device.kind));
    if (!device.serial.empty()) out << fmt::format("  Serial number {}.\n", device.serial);
    out << fmt::format("  Driver: {}.\n", device.driver);
    if (!device.firmware.empty()) out << fmt::format("  Firmware: {}.\n", device.firmware);
    if (!device.calibration.empty()) out << fmt::format("  Calibration: {}.\n", device.calibration);
    if (device.spec)
        out << fmt::format("  Reach {:.0f} centimetres around its middle, force up to {:g} newtons, walls up to {:g} newtons per metre.\n",
                           device.spec->workspace_radius_m * 100.0, device.spec->peak_force_n, device.spec->rated_stiffness_n_per_m);
    if (device.rate_hz > 0.0) out << fmt::format("  Up to {:g} times a second.\n", device.rate_hz);
    if (device.usable) out << fmt::format("  State: {}.\n", device_state(device));
    else out << fmt::format("  It cannot be used yet. {}\n", device.problem);
}

}  // namespace

int run_devices(const DevicesArguments& arguments, std::ostream& out, std::ostream&) {
    const std::vector<FoundDevice> found = find_devices();
    if (arguments.json) {
        Json devices = Json::array(), simulated = Json::array();
        for (const FoundDevice& device : found) devices.push_back(json_of(device));
        for (const DeviceSpec& spec : device_specs())
            if (spec.name.starts_with("sim-")) simulated.push_back(spec.name);
        out << Json{{"devices", std::move(devices)}, {"simulated", std::move(simulated)}, {"udev_rule", kUdevRule}}.dump(2, ' ', false,
                                                                                                                         Json::error_handler_t::replace)
            << '\n';
        return 0;
    }
    if (found.empty()) out << "No touch device was found. Everything works with keyboard and sound. Plug one in and ask again.\n";
    for (const FoundDevice& device : found) tell(device, out);
    out << "Simulated devices are always there: sim-t, sim-f.\n";
    return 0;
}

}  // namespace handrail
