#include "app/main/device_facts.h"

#include <utility>

#include "worlds/base/language.h"

namespace handrail::program {
namespace {

std::string kind_sentence(drivers::DeviceKind kind) {
    if (kind == drivers::DeviceKind::Kinesthetic) return phrase("program.device_pushes");
    return phrase(kind == drivers::DeviceKind::Cues ? "program.device_cues" : "program.device_moves");
}

}  // namespace

std::vector<std::string> device_sentences(const drivers::FoundDevice& device) {
    std::vector<std::string> sentences{phrase("program.device", {{"model", device.model},
                                                                 {"name", device.name},
                                                                 {"connection", device.connection},
                                                                 {"kind", kind_sentence(device.kind)}})};
    const auto line = [&sentences](std::string sentence) { sentences.push_back(std::move(sentence)); };
    if (!device.serial.empty()) line(phrase("program.device_serial", {{"serial", device.serial}}));
    line(phrase("program.device_driver", {{"driver", device.driver}}));
    if (!device.firmware.empty()) line(phrase("program.device_firmware", {{"firmware", device.firmware}}));
    if (!device.calibration.empty()) line(phrase("program.device_calibration", {{"calibration", device.calibration}}));
    if (device.spec)
        line(phrase("program.device_reach", {{"reach", device.spec->workspace_radius_m * 100.0},
                                             {"force", device.spec->peak_force_n},
                                             {"stiffness", device.spec->rated_stiffness_n_per_m}}));
    line(phrase(device.met_hardware ? "program.device_met" : "program.device_not_met"));
    if (device.rate_hz > 0.0) line(phrase("program.device_rate", {{"rate", device.rate_hz}}));
    line(device.usable ? phrase("program.device_state", {{"state", drivers::spoken_device_state(device)}})
                       : phrase("program.device_problem", {{"problem", device.problem}}));
    return sentences;
}

std::vector<std::string> device_sentences(std::span<const drivers::FoundDevice> devices) {
    std::vector<std::string> all;
    for (const drivers::FoundDevice& device : devices)
        for (std::string& sentence : device_sentences(device)) all.push_back(std::move(sentence));
    if (all.empty()) all.push_back(phrase("program.no_devices"));
    all.push_back(phrase("program.simulated_devices"));
    return all;
}

void DeviceFacts::answer(core::Session& app, double now_s) {
    if (app.requests().take_devices() && !looking_.busy())
        looking_.begin([](const std::stop_token&) { return device_sentences(drivers::find_devices()); });
    if (auto found = looking_.take()) app.apply(core::DevicesFound{std::move(*found)}, now_s);
}

}  // namespace handrail::program
