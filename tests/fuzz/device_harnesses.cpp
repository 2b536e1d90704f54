// Contains the harnesses for data from devices and their services: frames, reports, messages, and the firmware image
// that starts a Falcon.
#include <cmath>

#include "haptic/drivers/falcon_protocol.h"
#include "haptic/drivers/haply_device.h"
#include "haptic/drivers/playstation_pad.h"
#include "haptic/drivers/space_mouse.h"
#include "tests/fuzz/harness.h"
#include "tests/support/names.h"

namespace handrail::fuzz {
namespace {

std::span<const std::uint8_t> as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

bool is_share(double value) { return value >= -1.0 && value <= 1.0; }

std::string pad_fault(PadModel model, PadBus bus, std::span<const std::uint8_t> report) {
    const std::optional<PadInput> input = parse_pad_input(model, bus, report);
    if (!input) return {};
    for (const double stick : {input->left_x, input->left_y, input->right_x, input->right_y})
        if (!is_share(stick)) return "a stick beyond its end";
    for (const double trigger : {input->left_trigger, input->right_trigger})
        if (!(trigger >= 0.0 && trigger <= 1.0)) return "a trigger beyond its end";
    return input->hat >= 0 && input->hat <= 8 ? std::string() : "a hat that looks nowhere";
}

// Returns the report with a correct checksum, so that mutated bytes pass the driver's check.
std::vector<std::uint8_t> with_right_checksum(std::span<const std::uint8_t> report) {
    std::vector<std::uint8_t> right(report.begin(), report.end());
    if (right.size() < 4) return right;
    const std::uint32_t checksum = pad_checksum(0xA1, std::span(right).first(right.size() - 4));
    for (std::size_t i = 0; i < 4; ++i) right[right.size() - 4 + i] = static_cast<std::uint8_t>(checksum >> (8 * i));
    return right;
}

std::string puck_fault(std::span<const std::uint8_t> report) {
    struct SilentLink final : HidLink {
        bool write(std::span<const std::uint8_t>) noexcept override { return true; }
        int read(std::span<std::uint8_t>, double) noexcept override { return 0; }
        int feature(std::span<std::uint8_t>) noexcept override { return kLost; }
    };
    SpaceMouse puck(std::make_unique<SilentLink>());
    puck.take(report, 0.0);
    const PuckState& state = puck.poll(0.0);
    for (int axis = 0; axis < 3; ++axis)
        if (!is_share(state.move[axis]) || !is_share(state.turn[axis])) return "a puck beyond its end";
    return {};
}

}  // namespace

// Feeds the bytes to the parser in pieces, as a serial line does. The first byte sets the length of the pieces.
std::string falcon_fault(std::string_view bytes) {
    if (bytes.empty()) return {};
    const std::size_t piece = 1 + static_cast<unsigned char>(bytes.front()) % 40;
    bytes.remove_prefix(1);
    FalconFrameReader reader;
    for (std::size_t at = 0, frames = 0; at < bytes.size(); at += piece) {
        reader.push(as_bytes(bytes.substr(at, piece)));
        while (const auto status = reader.next()) {
            if (++frames * kFalconFrameBytes > bytes.size()) return "more frames than bytes";
            for (const int encoder : status->encoders)
                if (encoder < -32768 || encoder > 32767) return "an encoder beyond 16 bits";
            if (status->buttons > 15 || status->homed_legs > 7) return "a button or leg that is not there";
        }
        if (reader.skipped() > bytes.size()) return "more bytes skipped than came";
    }
    return {};
}

std::string boot_image_fault(std::string_view bytes) {
    const Result<void> checked = check_falcon_firmware(as_bytes(bytes), "fuzz.bin");
    return checked ? std::string() : words_fault(checked.error().sentence());
}

std::string hid_fault(std::string_view bytes) {
    const auto report = as_bytes(bytes);
    const std::vector<std::uint8_t> right = with_right_checksum(report);
    std::string fault = puck_fault(report);
    for (const PadModel model : {PadModel::DualSense, PadModel::DualShock4})
        for (const auto& read : {report, std::span<const std::uint8_t>(right)}) {
            if (fault.empty()) fault = pad_fault(model, PadBus::Usb, read);
            if (fault.empty()) fault = pad_fault(model, PadBus::Bluetooth, read);
        }
    return fault;
}

std::string haply_fault(std::string_view bytes) {
    for (const std::string& known : {std::string(), std::string("0A1B")}) {
        std::string device_id = known;
        DeviceSample sample;
        const bool taken = parse_haply_state(bytes, device_id, sample);
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(sample.position_m[axis])) return "a place that is not finite";
        if (!taken && device_id != known) return "a device taken from a message that was refused";
        if (!taken && sample.position_m != Vec3(0.0)) return "a place taken from a message that was refused";
        if (taken && !known.empty() && device_id != known) return "the place of another device";
    }
    return {};
}

}  // namespace handrail::fuzz
