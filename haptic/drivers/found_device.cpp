#include "haptic/drivers/found_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/hid_link.h"
#include "haptic/drivers/playstation_pad.h"
#include "haptic/drivers/usb_link.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::array kFalconIds{UsbId{0x0403, 0xcb48}};

std::string falcon_firmware_state(bool running) {
    if (running) return "running";
    for (const std::filesystem::path& file : falcon_firmware_files())
        if (falcon_firmware_is_sound(file)) return fmt::format("not running; {} is sent when the device is opened", file.string());
    return fmt::format("missing: put nvent_firmware.bin into {}", falcon_firmware_folder().string());
}

// A neutral frame or two: no force, no firmware.
void look_at_falcon(const UsbDeviceInfo& usb, FoundDevice& found) {
    auto link = open_usb_link(usb);
    if (!link) {
        found.usable = false;
        found.problem = link.error().sentence();
        return;
    }
    SteadyClock clock;
    FalconDevice falcon(std::move(*link), clock);
    const bool running = falcon.answers();
    found.firmware = falcon_firmware_state(running);
    found.usable = running || found.firmware.starts_with("not running");
    if (!found.usable) found.problem = fmt::format("Its firmware is {}.", found.firmware);
    const int legs = std::popcount(static_cast<unsigned>(falcon.homed_legs()));
    found.calibration = !running    ? "not homed: it is asleep"
                        : legs == 3 ? "homed; force not calibrated, so held at 3 newtons"
                                    : fmt::format("not homed: {} of 3 legs; pull the grip out and push it in", legs);
}

void find_falcons(std::vector<FoundDevice>& found) {
    const auto plugged = list_usb_devices(kFalconIds);
    if (!plugged) return;
    for (const UsbDeviceInfo& usb : *plugged) {
        FoundDevice device;
        device.name = "falcon";
        device.model = "Novint Falcon";
        device.driver = "Handrail's own, over libusb";
        device.connection = fmt::format("USB bus {}, device {}", usb.bus, usb.address);
        device.serial = usb.serial;
        device.spec = *find_device_spec("falcon");
        device.rate_hz = 1000.0;
        if (usb.permitted) {
            look_at_falcon(usb, device);
        } else {
            device.usable = false;
            device.problem = permission_advice();
        }
        found.push_back(std::move(device));
    }
}

struct PadId {
    std::uint16_t product;
    PadModel model;
    std::string_view name, spoken;
};
constexpr std::uint16_t kSony = 0x054c;
constexpr std::array kPads{PadId{0x0ce6, PadModel::DualSense, "dualsense", "DualSense"}, PadId{0x0df2, PadModel::DualSense, "dualsense", "DualSense Edge"},
                           PadId{0x05c4, PadModel::DualShock4, "dualshock4", "DualShock 4"}, PadId{0x09cc, PadModel::DualShock4, "dualshock4", "DualShock 4"}};
// 3Dconnexion, and Logitech, who sold theirs before and sells much else.
constexpr std::uint16_t kConnexion = 0x256f, kLogitech = 0x046d;
constexpr std::uint16_t kGenericDesktop = 1, kMultiAxis = 8;

void look_at_pad(const HidDeviceInfo& hid, const PadId& id, FoundDevice& device) {
    device.name = id.name;
    device.model = id.spoken;
    device.kind = DeviceKind::Cues;
    device.rate_hz = 250.0;
    device.calibration = "none needed";
    if (id.model != PadModel::DualSense || !device.usable) return;
    auto link = open_hid_link(hid);
    if (!link) {
        device.usable = false;
        device.problem = link.error().sentence();
        return;
    }
    PlaystationPad pad(std::move(*link), id.model, hid.bluetooth ? PadBus::Bluetooth : PadBus::Usb);
    if (const auto opened = pad.open(); opened) device.firmware = pad.firmware();
    else device.problem = opened.error().sentence();
    device.usable = device.problem.empty();
}

void find_hid_devices(std::vector<FoundDevice>& found) {
    for (const HidDeviceInfo& hid : list_hid_devices()) {
        const auto pad = std::find_if(kPads.begin(), kPads.end(), [&](const PadId& id) { return hid.vendor == kSony && hid.product == id.product; });
        const bool puck = (hid.vendor == kConnexion || hid.vendor == kLogitech) && hid.usage_page == kGenericDesktop && hid.usage == kMultiAxis;
        if (pad == kPads.end() && !puck) continue;
        FoundDevice device;
        device.driver = "Handrail's own, over hidapi";
        device.connection = fmt::format("{}, {}", hid.bluetooth ? "Bluetooth" : "USB", hid.path);
        device.serial = hid.serial;
        device.usable = hid.permitted;
        if (!hid.permitted) device.problem = permission_advice();
        if (puck) {
            device.name = "spacemouse";
            device.model = hid.product_name.empty() ? "SpaceMouse" : hid.product_name;
            device.kind = DeviceKind::Navigation;
            device.rate_hz = 125.0;
            device.calibration = "none needed";
        } else {
            look_at_pad(hid, *pad, device);
        }
        found.push_back(std::move(device));
    }
}

Result<std::unique_ptr<HapticDevice>> open_falcon(std::string_view serial, Clock& clock, const std::function<void(const std::string&)>& tell) {
    const auto plugged = list_usb_devices(kFalconIds);
    if (!plugged) return tl::unexpected(plugged.error());
    const auto wanted = std::find_if(plugged->begin(), plugged->end(), [&](const UsbDeviceInfo& usb) { return serial.empty() || usb.serial == serial; });
    if (wanted == plugged->end()) return fail("The Falcon is not plugged in.");
    if (!wanted->permitted) return fail(permission_advice());
    auto link = open_usb_link(*wanted);
    if (!link) return tl::unexpected(link.error());
    FalconOptions options;
    options.firmware_files = falcon_firmware_files();
    options.tell = tell;
    auto device = std::make_unique<FalconDevice>(std::move(*link), clock, std::move(options));
    if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<HapticDevice>(std::move(device));
}

}  // namespace

std::vector<FoundDevice> find_devices() {
    std::vector<FoundDevice> found;
    find_falcons(found);
    find_hid_devices(found);
    return found;
}

std::string permission_advice() {
    return fmt::format("You may not open it. Please copy the rule {} into /etc/udev/rules.d and plug the device in again.", kUdevRule);
}

bool is_meant(const FoundDevice& device, std::string_view name_or_serial) {
    return device.name == lower_ascii(name_or_serial) || (!device.serial.empty() && device.serial == name_or_serial);
}

std::vector<std::string> openable_device_names() { return {"falcon"}; }

Result<std::unique_ptr<HapticDevice>> open_device(std::string_view name, std::string_view serial, Clock& clock,
                                                  const std::function<void(const std::string&)>& tell) {
    if (name == "falcon") return open_falcon(serial, clock, tell);
    return fail(fmt::format("There is no driver for \"{}\".", name));
}

}  // namespace handrail
