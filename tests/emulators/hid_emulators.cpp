#include "tests/emulators/hid_emulators.h"
#include "tests/support/names.h"

#include <algorithm>

namespace handrail::test {
namespace {

// The CRC-32 of the reports, computed bit by bit as the standard defines it.
std::uint32_t checksum(std::uint8_t leading, std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xffffffffU;
    const auto take = [&](std::uint8_t byte) {
        crc ^= byte;
        for (int i = 0; i < 8; ++i) crc = crc & 1 ? crc >> 1 ^ 0xedb88320U : crc >> 1;
    };
    take(leading);
    for (const std::uint8_t byte : bytes) take(byte);
    return ~crc;
}

void append_checksum(std::vector<std::uint8_t>& report) {
    const std::uint32_t crc = checksum(0xa1, report);
    for (int i = 0; i < 4; ++i) report.push_back(static_cast<std::uint8_t>(crc >> (8 * i)));
}

enum class ReportWay : std::uint8_t { Input = 0x81, Output = 0x91, Feature = 0xb1 };

// Builds a report descriptor with one application on the generic desktop page. All its reports consist of bytes.
class Descriptor {
public:
    explicit Descriptor(std::uint8_t usage)
        : bytes_{0x05, 0x01, 0x09, usage, 0xa1, 0x01, 0x06, 0x00, 0xff, 0x15, 0x00, 0x26, 0xff, 0x00, 0x75, 8} {}
    Descriptor& report(ReportWay way, std::uint8_t number, std::uint8_t size) {
        bytes_.insert(bytes_.end(), {0x85, number, 0x95, size, 0x09, number, static_cast<std::uint8_t>(way), 0x02});
        return *this;
    }
    std::vector<std::uint8_t> end() {
        bytes_.push_back(0xc0);
        return std::move(bytes_);
    }

private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> PadEmulator::descriptor() const {
    Descriptor pad(5);
    if (bluetooth_) {
        pad.report(ReportWay::Input, 0x01, 9);
        for (const ReportWay way : {ReportWay::Input, ReportWay::Output})
            pad.report(way, dual_sense_ ? 0x31 : 0x11, 77);
        pad.report(ReportWay::Feature, dual_sense_ ? 0x05 : 0x02, dual_sense_ ? 40 : 36);
    } else {
        pad.report(ReportWay::Input, 0x01, 63)
            .report(ReportWay::Output, dual_sense_ ? 0x02 : 0x05, dual_sense_ ? 47 : 31);
    }
    if (dual_sense_) pad.report(ReportWay::Feature, 0x20, 63);
    return pad.end();
}

std::vector<std::uint8_t> PuckEmulator::descriptor() const {
    return Descriptor(8)
        .report(ReportWay::Input, 1, 6)
        .report(ReportWay::Input, 2, 6)
        .report(ReportWay::Input, 3, 4)
        .report(ReportWay::Output, 4, 1)
        .end();
}

bool PadEmulator::take(std::span<const std::uint8_t> report) {
    std::span<const std::uint8_t> body = report;
    if (bluetooth_) {
        if (report.size() != 78 || report[0] != (dual_sense_ ? 0x31 : 0x11)) return ++bad, true;
        std::uint32_t reported = 0;
        for (std::size_t i = 0; i < 4; ++i) reported |= static_cast<std::uint32_t>(report[74 + i]) << (8 * i);
        if (reported != checksum(0xa2, report.first(74))) return ++bad, true;
        if (dual_sense_) {
            const int sequence = report[1] >> 4;
            if (last_sequence >= 0 && sequence != ((last_sequence + 1) & 15)) ++sequence_breaks;
            last_sequence = sequence;
        }
        body = report.subspan(3, 71);
    } else {
        if (report.size() != (dual_sense_ ? 48U : 32U) || report[0] != (dual_sense_ ? 0x02 : 0x05)) return ++bad, true;
        body = report.subspan(1);
    }
    ++good;
    if (!dual_sense_) {
        if (body[0] & 0x01) {
            weak = body[3];
            strong = body[4];
        }
        return true;
    }
    rumbles_improved = !(body[0] & 0x01) && (body[38] & 0x04);
    if ((body[0] & 0x02) && ((body[0] & 0x01) || (body[38] & 0x04))) {
        weak = body[2];
        strong = body[3];
    }
    if (body[0] & 0x04) std::copy_n(body.begin() + 10, 11, right_effect.begin());
    if (body[0] & 0x08) std::copy_n(body.begin() + 21, 11, left_effect.begin());
    return true;
}

std::vector<std::uint8_t> PadEmulator::feature(std::uint8_t number) {
    if (bluetooth_ && number == (dual_sense_ ? 0x05 : 0x02)) {
        full_reports = true;
        return std::vector<std::uint8_t>(dual_sense_ ? 41 : 37, number);
    }
    if (dual_sense_ && number == 0x20) {
        std::vector<std::uint8_t> facts(64);
        facts[0] = number;
        facts[44] = static_cast<std::uint8_t>(version & 0xff);
        facts[45] = static_cast<std::uint8_t>(version >> 8);
        return facts;
    }
    return {};
}

std::vector<std::uint8_t> PadEmulator::input() const {
    std::vector<std::uint8_t> report;
    if (bluetooth_ && !full_reports) {
        report = {0x01,    sticks[0], sticks[1], sticks[2],   sticks[3],
                  keys[0], keys[1],   keys[2],   triggers[0], triggers[1]};
        return report;
    }
    if (!bluetooth_) report = {0x01};
    else if (dual_sense_) report = {0x31, 0x10};
    else report = {0x11, 0xc0, 0x00};
    report.insert(report.end(), sticks.begin(), sticks.end());
    if (dual_sense_) {
        report.insert(report.end(), {triggers[0], triggers[1], 0x77, keys[0], keys[1], keys[2]});
    } else {
        report.insert(report.end(), {keys[0], keys[1], static_cast<std::uint8_t>(keys[2] | 0xa4), triggers[0],
                                     triggers[1]});  // the bits above the keys contain a counter
    }
    // Position of the motion sensor's first reading, the pitch. The turn about the upright axis follows it.
    const std::size_t sensor = dual_sense_ ? (bluetooth_ ? 17 : 16) : (bluetooth_ ? 15 : 13);
    report.resize(bluetooth_ ? 74 : 64);
    report[sensor + 2] = static_cast<std::uint8_t>(yaw & 0xff);
    report[sensor + 3] = static_cast<std::uint8_t>((yaw >> 8) & 0xff);
    if (bluetooth_) append_checksum(report);
    return report;
}

void PadEmulator::send() { to_host.push_back(input()); }

void PadEmulator::send_wrong_checksum() {
    to_host.push_back(input());
    to_host.back()[30] ^= 0x04;
}

void PuckEmulator::send(std::uint8_t number, std::array<int, 3> axes) {
    std::vector<std::uint8_t> report{number};
    for (const int axis : axes) {
        report.push_back(static_cast<std::uint8_t>(axis & 0xff));
        report.push_back(static_cast<std::uint8_t>((axis >> 8) & 0xff));
    }
    to_host.push_back(std::move(report));
}

void PuckEmulator::send_all(std::array<int, 6> axes) {
    send(1, {axes[0], axes[1], axes[2]});
    std::vector<std::uint8_t> whole = std::move(to_host.back());
    to_host.pop_back();
    send(1, {axes[3], axes[4], axes[5]});
    whole.insert(whole.end(), to_host.back().begin() + 1, to_host.back().end());
    to_host.back() = std::move(whole);
}

int DirectHidLink::read(std::span<std::uint8_t> room, double) noexcept {
    if (device_.unplugged) return kLost;
    if (device_.to_host.empty()) return 0;
    const std::vector<std::uint8_t> report = std::move(device_.to_host.front());
    device_.to_host.pop_front();
    const std::size_t size = std::min(report.size(), room.size());
    std::copy_n(report.begin(), size, room.begin());
    return static_cast<int>(size);
}

int DirectHidLink::feature(std::span<std::uint8_t> room) noexcept {
    const std::vector<std::uint8_t> report = device_.unplugged ? std::vector<std::uint8_t>() : device_.feature(room[0]);
    if (report.empty()) return kLost;
    const std::size_t size = std::min(report.size(), room.size());
    std::copy_n(report.begin(), size, room.begin());
    return static_cast<int>(size);
}

}  // namespace handrail::test
