// The devices that are plugged in, as data for `handrail devices` and for choosing (S137), and how to open one. App
// thread or guard process. Finding them takes up to half a second, because each device is asked everything that needs
// no force and no lasting change.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"

namespace handrail::drivers {

enum class DeviceKind {
    Kinesthetic,
    Cues,
    Navigation
};  // forces in space; vibration and triggers; a sensor without force

struct FoundDevice {
    std::string name;   // as --device accepts it: "falcon"
    std::string model;  // "Novint Falcon"
    DeviceKind kind = DeviceKind::Kinesthetic;
    std::string driver;       // "Handrail's own, over libusb"
    std::string connection;   // "USB bus 1, device 7"
    std::string serial;       // empty if it has none, or may not be queried
    std::string firmware;     // a short phrase: "running", "must be sent when it is opened"
    std::string calibration;  // "homed", "not homed: 1 of 3 legs"
    bool needs_calibration = false;
    std::optional<device::DeviceSpec> spec;  // for Kinesthetic: workspace, force limit, stiffness
    double rate_hz = 0.0;                    // exchanges per second that the device is built for; 0: unknown
    // The driver has been tested with such hardware and not only with emulators; so far none has.
    bool met_hardware = false;
    bool usable = true;
    std::string problem;  // why it is not usable, and what to do; one or two sentences
};

// The state of the device in a word or two, as in `handrail devices --json`: "ready", "needs calibration", "cannot be
// used yet".
std::string_view device_state(const FoundDevice& device);
// The same, suitable for speech.
std::string spoken_device_state(const FoundDevice& device);

// Finds every device that one of our drivers can control.
std::vector<FoundDevice> find_devices();

// A device that can push a hand, identified by bus information alone: the device itself is not queried. Devices on
// older wires than USB and those behind a service are not found.
struct PluggedHand {
    std::string name;         // as --device accepts it
    std::string spoken_name;  // "Falcon"
    std::string place;        // bus and address, or the event node
    std::string problem;      // why it may not be opened; empty if it may

    bool operator==(const PluggedHand&) const = default;
};
std::vector<PluggedHand> plugged_hands();

// The rule that lets the person at the seat open devices, and where `cmake --install` puts it.
inline constexpr std::string_view kUdevRule = "70-handrail.rules";
std::string permission_advice();

// Returns true if a name ("falcon", any case) or a serial number refers to this device.
bool is_meant(const FoundDevice& device, std::string_view name_or_serial);

// Opens a kinesthetic device by name, and by serial number if one is given. For the guard process.
Result<std::unique_ptr<device::HapticDevice>> open_device(std::string_view name, std::string_view serial, Clock& clock,
                                                          const std::function<void(const std::string&)>& tell);
// Opens such a device, sends it zero force and closes it. The second guard does nothing else. Succeeds only if the
// device accepted the zero and answered.
Result<void> zero_device(std::string_view name, std::string_view serial, Clock& clock);
// The names that open_device() accepts: all are rows of device_specs().
std::vector<std::string> openable_device_names();
// Returns true for models on older wires than USB: only their maker's library knows whether one is present.
bool is_found_only_by_opening(std::string_view name);

}  // namespace handrail::drivers
