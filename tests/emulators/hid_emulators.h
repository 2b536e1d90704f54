// Emulates HID devices. A PlayStation pad checks the reports that it receives and reports the state of its keys and
// sticks. A HidLink connects the driver directly to a device. The pad implements its reports independently of the
// driver, including the checksum. Not thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "haptic/drivers/hid_link.h"
#include "tests/support/names.h"

namespace handrail::test {

// A device behind a HID node.
class HidEmulator {
public:
    virtual ~HidEmulator() = default;
    // Returns the report descriptor that the bus delivers: usage, numbers and lengths of the reports, without the
    // meaning of single bits.
    virtual std::vector<std::uint8_t> descriptor() const = 0;
    // Receives a report from the host. Returns false if the device refuses the report.
    virtual bool take(std::span<const std::uint8_t> report) = 0;
    // Returns the feature report with this number; empty if the device has none.
    virtual std::vector<std::uint8_t> feature(std::uint8_t number) = 0;

    std::deque<std::vector<std::uint8_t>> to_host;
    bool unplugged = false;
};

class PadEmulator final : public HidEmulator {
public:
    PadEmulator(bool dual_sense, bool bluetooth) : dual_sense_(dual_sense), bluetooth_(bluetooth) {}
    std::vector<std::uint8_t> descriptor() const override;
    bool take(std::span<const std::uint8_t> report) override;
    std::vector<std::uint8_t> feature(std::uint8_t number) override;
    // Queues an input report of the pad's current state. Over Bluetooth the reports are short until the host has
    // requested the calibration.
    void send();
    void send_wrong_checksum();

    // State of sticks, triggers and keys.
    std::array<std::uint8_t, 4> sticks{128, 128, 128, 128};
    std::array<std::uint8_t, 2> triggers{};
    std::array<std::uint8_t, 3> keys{8, 0, 0};
    // Reading of the motion sensor for a turn about the upright axis: positive to the left; 32767 means 2048 degrees a
    // second.
    std::int16_t yaw = 0;
    unsigned version = 0x0224;

    // The data that the pad has received.
    std::uint64_t good = 0, bad = 0;
    std::array<std::uint8_t, 11> right_effect{}, left_effect{};
    std::uint8_t strong = 0, weak = 0;
    bool rumbles_improved = false;
    int last_sequence = -1, sequence_breaks = 0;
    bool full_reports = false;

private:
    std::vector<std::uint8_t> input() const;
    bool dual_sense_, bluetooth_;
};

// A SpaceMouse: only its reports and its light are emulated.
class PuckEmulator final : public HidEmulator {
public:
    std::vector<std::uint8_t> descriptor() const override;
    bool take(std::span<const std::uint8_t> report) override {
        if (report.size() != 2 || report[0] != 4) return false;
        light = report[1] != 0;
        return true;
    }
    std::vector<std::uint8_t> feature(std::uint8_t) override { return {}; }
    void send(std::uint8_t number, std::array<int, 3> axes);
    void send_all(std::array<int, 6> axes);
    void send_buttons(std::uint32_t buttons) {
        to_host.push_back({3, static_cast<std::uint8_t>(buttons), static_cast<std::uint8_t>(buttons >> 8),
                           static_cast<std::uint8_t>(buttons >> 16), static_cast<std::uint8_t>(buttons >> 24)});
    }
    bool light = false;
};

class DirectHidLink final : public HidLink {
public:
    explicit DirectHidLink(HidEmulator& device) : device_(device) {}
    bool write(std::span<const std::uint8_t> report) noexcept override {
        return !device_.unplugged && device_.take(report);
    }
    int read(std::span<std::uint8_t> room, double timeout_s) noexcept override;
    int feature(std::span<std::uint8_t> room) noexcept override;

private:
    HidEmulator& device_;
};

}  // namespace handrail::test
