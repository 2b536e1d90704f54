#include "haptic/drivers/playstation_pad.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/vec.h"

namespace handrail::drivers {
namespace {

constexpr std::uint8_t kOutputCrc = 0xA2, kInputCrc = 0xA1;
constexpr std::size_t kCommonOutput = 47, kBluetoothReport = 78, kDualShockUsbOutput = 32;
constexpr std::size_t kChecksum = 4;
// First firmware version of the DualSense that no longer emulates the older motors when the pad rumbles.
constexpr unsigned kImprovedRumbleFrom = 0x0224;

std::uint16_t zones_from(int first) noexcept { return static_cast<std::uint16_t>((0x3ff << first) & 0x3ff); }

// Writes the mask of the zones from `first` on, then 3 bits with strength - 1 for each zone.
void put_zones(TriggerEffect& effect, int first, int strength) noexcept {
    const std::uint16_t mask = zones_from(first);
    std::uint32_t packed = 0;
    for (int zone = first; zone < 10; ++zone) packed |= static_cast<std::uint32_t>(strength - 1) << (3 * zone);
    effect[1] = static_cast<std::uint8_t>(mask & 0xff);
    effect[2] = static_cast<std::uint8_t>(mask >> 8);
    for (std::size_t i = 0; i < 4; ++i) effect[3 + i] = static_cast<std::uint8_t>(packed >> (8 * i));
}

void put_checksum(std::vector<std::uint8_t>& report) {
    const std::uint32_t crc = pad_checksum(kOutputCrc, std::span(report).first(report.size() - kChecksum));
    for (std::size_t i = 0; i < kChecksum; ++i)
        report[report.size() - kChecksum + i] = static_cast<std::uint8_t>(crc >> (8 * i));
}

double stick(std::uint8_t value) noexcept {
    return std::clamp((static_cast<double>(value) - 128.0) / 127.0, -1.0, 1.0);
}

// Converts a reading of the motion sensor. A positive reading is a turn to the left; 32767 means 2048 degrees a second.
double yaw_right(std::span<const std::uint8_t> yaw) noexcept {
    const auto raw = static_cast<std::int16_t>(static_cast<std::uint16_t>(yaw[0] | yaw[1] << 8));
    return radians_from_degrees(-raw * (2048.0 / 32767.0));
}

std::uint8_t coil(double share) noexcept {
    return static_cast<std::uint8_t>(std::isfinite(share) ? std::lround(std::clamp(share, 0.0, 1.0) * 255.0) : 0);
}

int level(double share) noexcept {
    return std::isfinite(share) ? static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * 8.0)) : 0;
}

}  // namespace

std::optional<PadIdentity> playstation_pad(std::uint16_t vendor, std::uint16_t product) noexcept {
    constexpr std::uint16_t kSony = 0x054c;
    if (vendor != kSony) return std::nullopt;
    switch (product) {
        case 0x0ce6:
            return PadIdentity{PadModel::DualSense, "dualsense", "DualSense"};
        case 0x0df2:
            return PadIdentity{PadModel::DualSense, "dualsense", "DualSense Edge"};
        case 0x05c4:
        case 0x09cc:
            return PadIdentity{PadModel::DualShock4, "dualshock4", "DualShock 4"};
        default:
            return std::nullopt;
    }
}

bool is_event_node_of_a_playstation_pad(std::string_view name) noexcept {
    return name.find("DualSense") != std::string_view::npos ||
           name.find("Wireless Controller") != std::string_view::npos;
}

TriggerEffect trigger_off() noexcept { return {0x05}; }

TriggerEffect trigger_resists(int from_zone, int strength) noexcept {
    TriggerEffect effect{0x21};
    put_zones(effect, std::clamp(from_zone, 0, 9), std::clamp(strength, 1, 8));
    return effect;
}

TriggerEffect trigger_clicks(int from_zone, int to_zone, int strength) noexcept {
    const int from = std::clamp(from_zone, 2, 7), to = std::clamp(to_zone, from + 1, 8);
    const unsigned mask = (1U << from) | (1U << to);
    return {0x25, static_cast<std::uint8_t>(mask & 0xff), static_cast<std::uint8_t>(mask >> 8),
            static_cast<std::uint8_t>(std::clamp(strength, 1, 8) - 1)};
}

TriggerEffect trigger_vibrates(int from_zone, int strength, int frequency_hz) noexcept {
    TriggerEffect effect{0x26};
    put_zones(effect, std::clamp(from_zone, 0, 9), std::clamp(strength, 1, 8));
    effect[9] = static_cast<std::uint8_t>(std::clamp(frequency_hz, 1, 255));
    return effect;
}

PadOutput pad_output_for(const device::FingerCue& cue) noexcept {
    PadOutput output;
    const int resistance =
        level(cue.nearness * (0.4 + 0.6 * std::clamp(std::isfinite(cue.hardness) ? cue.hardness : 0.0, 0.0, 1.0)));
    if (cue.doorway) output.right = trigger_clicks(3, 6, 8);
    else if (resistance > 0 && cue.material_hz >= 1.0)
        output.right = trigger_vibrates(2, resistance, static_cast<int>(std::min(cue.material_hz, 255.0)));
    else if (resistance > 0) output.right = trigger_resists(2, resistance);
    if (const int slope = level(cue.slope); slope > 0) output.left = trigger_resists(2, slope);
    output.strong = coil(cue.knock);
    output.weak = coil(cue.grain);
    return output;
}

std::uint32_t pad_checksum(std::uint8_t leading, std::span<const std::uint8_t> bytes) noexcept {
    const auto crc = ::crc32(::crc32(0, Z_NULL, 0), &leading, 1);
    return static_cast<std::uint32_t>(::crc32(crc, bytes.data(), static_cast<unsigned>(bytes.size())));
}

std::vector<std::uint8_t> pad_output_report(PadModel model, PadBus bus, const PadOutput& output, bool improved_rumble,
                                            int sequence) {
    std::vector<std::uint8_t> report;
    if (model == PadModel::DualShock4) {
        // Only the flag of the coils is set, so that the light stays as the kernel set it.
        report.resize(bus == PadBus::Usb ? kDualShockUsbOutput : kBluetoothReport);
        const std::size_t at = bus == PadBus::Usb ? 1 : 3;
        report[0] = bus == PadBus::Usb ? 0x05 : 0x11;
        // 0xC0: the report has a checksum; 4: the pad sends input every 4 ms.
        if (bus == PadBus::Bluetooth) report[1] = 0xC0 | 4;
        report[at] = 0x01;
        report[at + 3] = output.weak;
        report[at + 4] = output.strong;
        if (bus == PadBus::Bluetooth) put_checksum(report);
        return report;
    }
    std::array<std::uint8_t, kCommonOutput> common{};
    // Flags for both triggers and for using the coils as rumble.
    common[0] = 0x04 | 0x08 | 0x02 | (improved_rumble ? 0x00 : 0x01);
    common[2] = output.weak;
    common[3] = output.strong;
    std::copy(output.right.begin(), output.right.end(), common.begin() + 10);
    std::copy(output.left.begin(), output.left.end(), common.begin() + 21);
    if (improved_rumble) common[38] = 0x04;
    if (bus == PadBus::Usb) {
        report.resize(1 + kCommonOutput);
        report[0] = 0x02;
        std::copy(common.begin(), common.end(), report.begin() + 1);
        return report;
    }
    report.resize(kBluetoothReport);
    report[0] = 0x31;
    report[1] = static_cast<std::uint8_t>((sequence & 15) << 4);
    report[2] = 0x10;
    std::copy(common.begin(), common.end(), report.begin() + 3);
    put_checksum(report);
    return report;
}

std::optional<PadInput> parse_pad_input(PadModel model, PadBus bus, std::span<const std::uint8_t> report) noexcept {
    const bool sense = model == PadModel::DualSense;
    std::size_t at = 1;
    if (bus == PadBus::Usb) {
        if (report.size() != 64 || report[0] != 0x01) return std::nullopt;
    } else {
        if (report.size() != kBluetoothReport || report[0] != (sense ? 0x31 : 0x11)) return std::nullopt;
        const auto body = report.first(report.size() - kChecksum), sum = report.last(kChecksum);
        const std::uint32_t stated = sum[0] | static_cast<std::uint32_t>(sum[1]) << 8 |
                                     static_cast<std::uint32_t>(sum[2]) << 16 |
                                     static_cast<std::uint32_t>(sum[3]) << 24;
        if (stated != pad_checksum(kInputCrc, body)) return std::nullopt;
        at = sense ? 2 : 3;
    }
    const auto block = report.subspan(at);
    PadInput input;
    input.left_x = stick(block[0]);
    input.left_y = -stick(block[1]);
    input.right_x = stick(block[2]);
    input.right_y = -stick(block[3]);
    // In its report, the DualShock 4 has the buttons first, the DualSense the triggers and a counter.
    const auto keys = block.subspan(sense ? 7 : 4, 3), triggers = block.subspan(sense ? 4 : 7, 2);
    input.yaw_right_rad_per_s = yaw_right(block.subspan(sense ? 17 : 14, 2));
    input.left_trigger = triggers[0] / 255.0;
    input.right_trigger = triggers[1] / 255.0;
    input.hat = std::min<int>(keys[0] & 15, 8);
    input.buttons = static_cast<std::uint32_t>(keys[0] >> 4) | static_cast<std::uint32_t>(keys[1]) << 4 |
                    static_cast<std::uint32_t>(keys[2] & (sense ? 7 : 3)) << 12;
    return input;
}

PlaystationPad::PlaystationPad(std::unique_ptr<HidLink> link, PadModel model, PadBus bus)
    : link_(std::move(link)), model_(model), bus_(bus) {
    contract_pre(link_);
}

PlaystationPad::~PlaystationPad() { close(); }

Result<void> PlaystationPad::open() {
    if (bus_ == PadBus::Bluetooth) {
        // After a pad connects over Bluetooth, it sends short reports until the host requests this feature report. The
        // content of the report, the calibration, is not used.
        std::array<std::uint8_t, 64> calibration{};
        calibration[0] = model_ == PadModel::DualSense ? 0x05 : 0x02;
        if (link_->feature(calibration) < 0) return fail(phrase("drivers.pad_silent"));
    }
    if (model_ == PadModel::DualSense) {
        std::array<std::uint8_t, 64> facts{};
        facts[0] = 0x20;
        if (const int size = link_->feature(facts); size >= 46) {
            const unsigned version = facts[44] | static_cast<unsigned>(facts[45]) << 8;
            improved_rumble_ = version >= kImprovedRumbleFrom;
            firmware_ = fmt::format("{:x}.{:02x}", version >> 8, version & 0xff);
        }
    }
    open_ = true;
    if (write({})) return {};
    open_ = false;
    return fail(phrase("drivers.pad_deaf"));
}

std::optional<PadInput> PlaystationPad::read(double timeout_s) noexcept {
    std::optional<PadInput> newest;
    std::array<std::uint8_t, 128> room;
    for (double wait_s = timeout_s; !lost_; wait_s = 0.0) {
        const int size = link_->read(room, wait_s);
        if (size == HidLink::kLost) lost_ = true;
        if (size <= 0) break;
        if (const auto input = parse_pad_input(model_, bus_, std::span(room).first(static_cast<std::size_t>(size))))
            newest = input;
    }
    return newest;
}

bool PlaystationPad::write(const PadOutput& output) {
    if (!open_ || lost_) return false;
    return link_->write(pad_output_report(model_, bus_, output, improved_rumble_, sequence_++));
}

void PlaystationPad::close() noexcept {
    if (open_) write({});
    open_ = false;
}

}  // namespace handrail::drivers
