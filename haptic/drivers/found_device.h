// Finds the devices that are plugged in, as data for `handrail devices` and for choosing one, and opens them. App
// thread or guard process. find_devices() takes up to half a second, because it queries each device for everything that
// needs no force and no lasting change.
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
};  // Kinesthetic: forces in space. Cues: vibration and triggers. Navigation: a sensor without force.

struct FoundDevice {
    std::string name;   // name for --device: "falcon"
    std::string model;  // for example "Novint Falcon"
    DeviceKind kind = DeviceKind::Kinesthetic;
    std::string driver;       // for example "Handrail's own, over libusb"
    std::string connection;   // for example "USB bus 1, device 7"
    std::string serial;       // serial number; empty if the device has none or may not be queried
    std::string firmware;     // a short phrase, for example "running" or "must be sent when it is opened"
    std::string calibration;  // a short phrase, for example "homed" or "not homed: 1 of 3 legs"
    bool needs_calibration = false;
    std::optional<device::DeviceSpec> spec;  // workspace, force limit and stiffness; only for Kinesthetic
    double rate_hz = 0.0;                    // exchanges per second for which the device is built; 0: unknown
    // True if the driver has been tested with real hardware and not only with emulators. So far that is false for all.
    bool met_hardware = false;
    bool usable = true;
    std::string problem;  // why the device is not usable, and what the person can do about it; one or two sentences
};

// Returns the state of the device in one or a few words, as in `handrail devices --json`: for example "ready", "needs
// calibration" or "cannot be used yet".
std::string_view device_state(const FoundDevice& device);
// Returns the state of the device, suitable for speech.
std::string spoken_device_state(const FoundDevice& device);

// Finds every device that one of our drivers can control.
std::vector<FoundDevice> find_devices();

// A device that can push a hand, identified only by information from the bus, without a query to the device. Devices on
// buses older than USB, and devices that only a service can reach, are not found.
struct PluggedHand {
    std::string name;         // name for --device
    std::string spoken_name;  // for example "Falcon"
    std::string place;        // bus and address, or the event node
    std::string problem;      // why the device may not be opened; empty if it may

    bool operator==(const PluggedHand&) const = default;
};
std::vector<PluggedHand> plugged_hands();

// File name of the udev rule that lets the person at the seat open devices. permission_advice() says where `cmake
// --install` puts the file.
inline constexpr std::string_view kUdevRule = "70-handrail.rules";
std::string permission_advice();

// Returns true if `name_or_serial` is the device's name ("falcon", in any case) or its serial number.
bool is_meant(const FoundDevice& device, std::string_view name_or_serial);

// Opens a kinesthetic device by name, and by serial number if one is given. Only the guard process calls it.
Result<std::unique_ptr<device::HapticDevice>> open_device(std::string_view name, std::string_view serial, Clock& clock,
                                                          const std::function<void(const std::string&)>& report);
// Opens the device, sends it zero force and closes it. The second guard does only this. Succeeds only if the device
// accepted the zero and answered.
Result<void> zero_device(std::string_view name, std::string_view serial, Clock& clock);
// Returns the names that open_device() accepts. Each has a row in device_specs().
std::vector<std::string> openable_device_names();
// Returns true for models on buses older than USB. Only the maker's library can find out whether one is connected.
bool is_found_only_by_opening(std::string_view name);

}  // namespace handrail::drivers
