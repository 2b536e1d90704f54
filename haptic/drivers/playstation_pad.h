// Drives Sony's DualSense and DualShock 4. The driver reads their sticks, triggers and buttons, and gives cues to the
// fingers by two voice coils and, on the DualSense, by two triggers that resist. It renders no walls; a cue only
// indicates a wall. The pad is connected by USB, or by Bluetooth, where each report carries a checksum. Any one thread.
// The pad is read at most 250 times a second and written at most 125 times; read() and write() cost a system call each.
// Sources: the Linux drivers hid-playstation and hid-sony for reports and checksum; published descriptions of the
// trigger effects.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/device/finger_cue.h"
#include "haptic/drivers/hid_link.h"

namespace handrail::drivers {

enum class PadModel : std::uint8_t { DualSense, DualShock4 };
enum class PadBus : std::uint8_t { Usb, Bluetooth };

// A Sony pad identified by its USB or Bluetooth numbers.
struct PadIdentity {
    PadModel model = PadModel::DualSense;
    std::string_view name, spoken;  // for example "dualsense" and "DualSense Edge"
};
std::optional<PadIdentity> playstation_pad(std::uint16_t vendor, std::uint16_t product) noexcept;

// Returns true if an event node with this name belongs to a DualSense or DualShock 4. The kernel creates event nodes
// for the pad under the pad's own name.
bool is_event_node_of_a_playstation_pad(std::string_view name) noexcept;

struct PadInput {
    // Deflections of the sticks, -1 to 1; right and forward are positive.
    double left_x = 0.0, left_y = 0.0, right_x = 0.0, right_y = 0.0;
    double left_trigger = 0.0, right_trigger = 0.0;  // pull of the trigger, 0 to 1
    // How fast the pad turns about its upright axis, in rad/s, clockwise from above. The sensor's calibration is not
    // used, because errors of a few per cent and a drift of a degree a second do not matter for pointing.
    double yaw_right_rad_per_s = 0.0;
    int hat = 8;  // 0: up, then clockwise to 7; 8: not pressed
    // Pressed buttons, from bit 0 on: square cross circle triangle L1 R1 L2 R2 create options L3 R3 PS touch mute.
    std::uint32_t buttons = 0;
};

// Effect of a trigger. Its pull is divided into ten zones, 0 to 9. The functions below build effects and clamp values
// out of range.
using TriggerEffect = std::array<std::uint8_t, 11>;
TriggerEffect trigger_off() noexcept;
TriggerEffect trigger_resists(int from_zone, int strength_1_to_8) noexcept;
TriggerEffect trigger_clicks(int from_zone_2_to_7, int to_zone, int strength_1_to_8) noexcept;
TriggerEffect trigger_vibrates(int from_zone, int strength_1_to_8, int frequency_hz) noexcept;

struct PadOutput {
    TriggerEffect left = trigger_off(), right = trigger_off();
    std::uint8_t strong = 0, weak = 0;  // strength of the left coil (strong) and of the right coil (weak)
};

PadOutput pad_output_for(const device::FingerCue& cue) noexcept;

// Convert reports to and from bytes. Parsing returns nothing for a Bluetooth input with a wrong checksum, and for bytes
// that are not a full input report.
std::vector<std::uint8_t> pad_output_report(PadModel model, PadBus bus, const PadOutput& output, bool improved_rumble,
                                            int sequence);
std::optional<PadInput> parse_pad_input(PadModel model, PadBus bus, std::span<const std::uint8_t> report) noexcept;
// Returns the CRC-32 (as in zip) of one leading byte and the report without its last four bytes. The leading byte is
// 0xA2 for output, 0xA1 for input and 0xA3 for feature reports.
std::uint32_t pad_checksum(std::uint8_t leading, std::span<const std::uint8_t> bytes) noexcept;

class PlaystationPad {
public:
    PlaystationPad(std::unique_ptr<HidLink> link, PadModel model, PadBus bus);
    ~PlaystationPad();  // releases the triggers and stops the coils
    PlaystationPad(const PlaystationPad&) = delete;
    PlaystationPad& operator=(const PlaystationPad&) = delete;

    // Requests full reports from a pad on Bluetooth, and the firmware version from a DualSense.
    Result<void> open();
    // Returns the newest input that has arrived or arrives within `timeout_s`; nothing if there is none.
    std::optional<PadInput> read(double timeout_s) noexcept;
    bool write(const PadOutput& output);
    void close() noexcept;
    bool lost() const { return lost_; }
    // Returns the firmware version, for example "2.36" for a DualSense; an empty string for a DualShock 4.
    const std::string& firmware() const { return firmware_; }

private:
    std::unique_ptr<HidLink> link_;
    PadModel model_;
    PadBus bus_;
    bool open_ = false, lost_ = false, improved_rumble_ = false;
    int sequence_ = 0;
    std::string firmware_;
};

}  // namespace handrail::drivers
