#include <nlohmann/json.hpp>

#include "app/main/commands.h"
#include "app/main/confinement_facts.h"
#include "app/main/device_facts.h"
#include "haptic/drivers/found_device.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

using Json = nlohmann::ordered_json;

std::string_view kind_word(drivers::DeviceKind kind) {
    if (kind == drivers::DeviceKind::Kinesthetic) return "force";
    return kind == drivers::DeviceKind::Cues ? "cues" : "navigation";
}

// Returns null for an unknown value, so that nobody believes that the value is 0.
Json known(double value) { return value > 0.0 && std::isfinite(value) ? Json(value) : Json(nullptr); }
Json known(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json json_of(const drivers::FoundDevice& device) {
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
            {"met_hardware", device.met_hardware},
            {"state", drivers::device_state(device)},
            {"usable", device.usable},
            {"problem", known(device.problem)}};
}

}  // namespace

int run_devices(const DevicesArguments& arguments, std::ostream& out, std::ostream&) {
    const std::vector<drivers::FoundDevice> found = drivers::find_devices();
    if (arguments.json) {
        Json devices = Json::array(), simulated = Json::array();
        for (const drivers::FoundDevice& device : found) devices.push_back(json_of(device));
        for (const device::DeviceSpec& spec : device::device_specs())
            if (spec.name.starts_with("sim-")) simulated.push_back(spec.name);
        out << Json{{"devices", std::move(devices)},
                    {"simulated", std::move(simulated)},
                    {"udev_rule", drivers::kUdevRule},
                    {"confinement", program::json_of(confine::confinement_offered())}}
                   .dump(2, ' ', false, Json::error_handler_t::replace)
            << '\n';
        return 0;
    }
    if (found.empty()) out << phrase("program.no_devices") << '\n';
    for (const drivers::FoundDevice& device : found) {
        const std::vector<std::string> sentences = device_sentences(device);
        for (std::size_t i = 0; i < sentences.size(); ++i) out << (i > 0 ? "  " : "") << sentences[i] << '\n';
    }
    out << phrase("program.simulated_devices") << '\n';
    out << confine::confinement_sentence(confine::confinement_offered()) << '\n';
    return 0;
}

}  // namespace handrail::program
