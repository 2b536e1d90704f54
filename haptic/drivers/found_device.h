// What is plugged in, as data for `handrail devices` and for choosing (S137), and how to open one. App thread or guard
// process; looking takes up to half a second, for each device is asked what can be asked without a force or a change
// that lasts.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"

namespace handrail {

enum class DeviceKind {
    Kinesthetic,
    Cues,
    Navigation
};  // forces in space; vibration and triggers; a sensor without force

struct FoundDevice {
    std::string name;   // as --device takes it: "falcon"
    std::string model;  // "Novint Falcon"
    DeviceKind kind = DeviceKind::Kinesthetic;
    std::string driver;       // "Handrail's own, over libusb"
    std::string connection;   // "USB bus 1, device 7"
    std::string serial;       // empty: it has none, or it may not be asked
    std::string firmware;     // a sentence's worth: "running", "must be sent when it is opened"
    std::string calibration;  // "homed", "not homed: 1 of 3 legs"
    bool needs_calibration = false;
    std::optional<DeviceSpec> spec;  // Kinesthetic: workspace, force limit, stiffness
    double rate_hz = 0.0;            // exchanges per second that the device is built for; 0: not known
    bool met_hardware = false;       // the driver has ever met such a device, and not emulators alone: none has yet
    bool usable = true;
    std::string problem;  // why not, and what to do; one or two sentences
};

// In a word or two what the device can do now, as `handrail devices --json` has it: "ready", "needs calibration",
// "cannot be used yet".
std::string_view device_state(const FoundDevice& device);
// The same to be spoken.
std::string spoken_device_state(const FoundDevice& device);

// Everything that a driver of ours can speak to.
std::vector<FoundDevice> find_devices();

// A device that can push a hand, by what the bus says of it: nothing is asked of the device itself. Those on older
// wires than USB and those behind a service are not seen.
struct PluggedHand {
    std::string name;         // as --device takes it
    std::string spoken_name;  // "Falcon"
    std::string place;        // bus and address, or the event node
    std::string problem;      // why it may not be opened; empty when it may

    bool operator==(const PluggedHand&) const = default;
};
std::vector<PluggedHand> plugged_hands();

// Where `cmake --install` puts the rule that lets the person at the seat open devices.
inline constexpr std::string_view kUdevRule = "70-handrail.rules";
std::string permission_advice();

// True if this device is meant by a name ("falcon", any case) or by a serial number.
bool is_meant(const FoundDevice& device, std::string_view name_or_serial);

// A kinesthetic device by name, and by serial number where one is given; opened. For the guard process.
Result<std::unique_ptr<HapticDevice>> open_device(std::string_view name, std::string_view serial, Clock& clock,
                                                  const std::function<void(const std::string&)>& tell);
// Opens such a device, sends it zero force and closes it: all that the second guard does. Succeeds only when the device
// took the zero and answered.
Result<void> zero_device(std::string_view name, std::string_view serial, Clock& clock);
// The names open_device() knows: all are rows of device_specs().
std::vector<std::string> openable_device_names();
// Models that sit on older wires than USB: only their maker's library knows whether one is there.
bool is_found_only_by_opening(std::string_view name);

}  // namespace handrail
