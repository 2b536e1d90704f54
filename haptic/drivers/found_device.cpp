#include "haptic/drivers/found_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <filesystem>

#include "haptic/drivers/dhd_device.h"
#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/ff_link.h"
#include "haptic/drivers/force_stick.h"
#include "haptic/drivers/haply_device.h"
#include "haptic/drivers/hd_device.h"
#include "haptic/drivers/hid_link.h"
#include "haptic/drivers/playstation_pad.h"
#include "haptic/drivers/space_mouse.h"
#include "haptic/drivers/usb_link.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::array kFalconIds{UsbId{0x0403, 0xcb48}};

std::string why_not(const UsbDeviceInfo& usb) { return usb.permitted ? fmt::format("It cannot be opened: {}.", usb.problem) : permission_advice(); }

std::string place_of(const UsbDeviceInfo& usb) { return fmt::format("USB bus {}, device {}", usb.bus, usb.address); }

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
        device.connection = place_of(usb);
        device.serial = usb.serial;
        device.spec = *find_device_spec("falcon");
        device.rate_hz = 1000.0;
        device.usable = usb.problem.empty();
        if (device.usable) look_at_falcon(usb, device);
        else device.problem = why_not(usb);
        found.push_back(std::move(device));
    }
}

void look_at_pad(const HidDeviceInfo& hid, const PadIdentity& id, FoundDevice& device) {
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
        const auto pad = playstation_pad(hid.vendor, hid.product);
        const bool puck = is_space_mouse(hid);
        if (!pad && !puck) continue;
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

// Devices that only their maker's library can speak to. Their numbers on USB say that one is there; the library itself is loaded in the guard
// alone, when the device is chosen.
struct Maker {
    UsbId id;
    std::string_view name, default_device;
    std::array<std::string_view, 3> libraries;
};
constexpr std::array kMakers{Maker{{0x1451, 0}, "Force Dimension", "omega", {"libdhd.so.3", "libdhd.so", ""}},
                             Maker{{0x2988, 0}, "3D Systems", "touch", {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"}}};

std::string_view model_of(const Maker& maker, const UsbDeviceInfo& usb) {
    for (const std::string_view name : {"omega", "sigma", "lambda", "delta"})
        if (lower_ascii(usb.product_name).starts_with(name)) return name;
    return maker.default_device;
}

bool library_lies_somewhere(const Maker& maker) {
    std::vector<std::string> folders{"/usr/lib", "/usr/lib64", "/usr/lib/x86_64-linux-gnu", "/usr/local/lib", "/lib/x86_64-linux-gnu"};
    const char* named = std::getenv("LD_LIBRARY_PATH");
    for (std::string rest = named ? named : ""; !rest.empty();) {
        const std::size_t end = rest.find(':');
        folders.push_back(rest.substr(0, end));
        rest = end == std::string::npos ? std::string() : rest.substr(end + 1);
    }
    std::error_code ec;
    return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        return std::any_of(maker.libraries.begin(), maker.libraries.end(), [&](std::string_view library) {
            return !library.empty() && !folder.empty() && std::filesystem::exists(std::filesystem::path(folder) / library, ec);
        });
    });
}

void find_makers_devices(std::vector<FoundDevice>& found) {
    for (const Maker& maker : kMakers) {
        const auto plugged = list_usb_devices(std::span(&maker.id, 1));
        if (!plugged) return;
        for (const UsbDeviceInfo& usb : *plugged) {
            FoundDevice device;
            device.name = model_of(maker, usb);
            device.spec = *find_device_spec(device.name);
            device.model = fmt::format("{} {}", maker.name, usb.product_name.empty() ? std::string(device.spec->spoken_name) : usb.product_name);
            device.driver = fmt::format("its maker's library {}, loaded when it is chosen", maker.libraries.front());
            device.connection = place_of(usb);
            device.serial = usb.serial;
            device.firmware = "its own";
            device.calibration = "told when it is opened";
            device.rate_hz = 1000.0;
            device.usable = library_lies_somewhere(maker);
            if (!device.usable) device.problem = fmt::format("The library {} of {} is not installed.", maker.libraries.front(), maker.name);
            found.push_back(std::move(device));
        }
    }
}

void find_inverse3(std::vector<FoundDevice>& found) {
    SteadyClock clock;
    const auto facts = look_at_haply(clock);
    if (!facts) return;
    FoundDevice device;
    device.name = "inverse3";
    device.model = "Haply Inverse3";
    device.driver = "its maker's service, over a WebSocket on this computer";
    device.connection = fmt::format("127.0.0.1, port {}", kHaplyPort);
    device.serial = facts->device_id;
    device.firmware = facts->firmware.empty() ? "its own" : facts->firmware;
    device.calibration = facts->calibrated ? "calibrated" : "not calibrated: follow its maker's steps";
    device.spec = *find_device_spec("inverse3");
    device.rate_hz = 1000.0;
    found.push_back(std::move(device));
}

// Pads that a driver of ours already speaks to over hidapi have event nodes too; they are told once.
void find_ff_devices(std::vector<FoundDevice>& found) {
    for (const FfDeviceInfo& ff : list_ff_devices()) {
        const bool stick = ff.abilities.constant && ff.abilities.stick;
        const bool known = std::any_of(found.begin(), found.end(), [](const FoundDevice& device) { return device.driver.ends_with("hidapi"); });
        if (!stick && known && is_event_node_of_a_playstation_pad(ff.name)) continue;
        FoundDevice device;
        device.name = stick ? "force-stick" : "rumble-pad";
        device.model = ff.name.empty() ? device.name : ff.name;
        device.kind = stick ? DeviceKind::Kinesthetic : DeviceKind::Cues;
        device.driver = "the kernel's force feedback";
        device.connection = ff.path;
        device.calibration = "none needed";
        if (stick) device.spec = *find_device_spec("force-stick");
        device.rate_hz = stick ? 250.0 : 20.0;
        found.push_back(std::move(device));
    }
}

Result<std::unique_ptr<HapticDevice>> open_force_stick() {
    for (const FfDeviceInfo& ff : list_ff_devices()) {
        if (!ff.abilities.constant || !ff.abilities.stick) continue;
        auto link = open_ff_link(ff.path);
        if (!link) return tl::unexpected(link.error());
        auto device = std::make_unique<ForceStick>(std::move(*link));
        if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
        return std::unique_ptr<HapticDevice>(std::move(device));
    }
    return fail("No force-feedback joystick is plugged in.");
}

Result<std::unique_ptr<HapticDevice>> open_falcon(std::string_view serial, Clock& clock, const std::function<void(const std::string&)>& tell) {
    const auto plugged = list_usb_devices(kFalconIds);
    if (!plugged) return tl::unexpected(plugged.error());
    const auto wanted = std::find_if(plugged->begin(), plugged->end(), [&](const UsbDeviceInfo& usb) { return serial.empty() || usb.serial == serial; });
    if (wanted == plugged->end()) return fail("The Falcon is not plugged in.");
    if (!wanted->problem.empty()) return fail(why_not(*wanted));
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

std::string_view device_state(const FoundDevice& device) {
    if (!device.usable) return "cannot be used yet";
    return device.calibration.starts_with("not ") ? "needs calibration" : "ready";
}

std::vector<FoundDevice> find_devices() {
    std::vector<FoundDevice> found;
    find_falcons(found);
    find_makers_devices(found);
    find_inverse3(found);
    find_hid_devices(found);
    find_ff_devices(found);
    return found;
}

std::vector<PluggedHand> plugged_hands() {
    std::vector<PluggedHand> hands;
    const auto add_usb = [&](std::span<const UsbId> ids, auto&& name_of) {
        const auto plugged = list_usb_devices(ids);
        if (!plugged) return;
        for (const UsbDeviceInfo& usb : *plugged) {
            const DeviceSpec& spec = *find_device_spec(name_of(usb));
            hands.push_back({std::string(spec.name), std::string(spec.spoken_name), place_of(usb), usb.problem.empty() ? std::string() : why_not(usb)});
        }
    };
    add_usb(kFalconIds, [](const UsbDeviceInfo&) { return std::string_view("falcon"); });
    for (const Maker& maker : kMakers) add_usb(std::span(&maker.id, 1), [&](const UsbDeviceInfo& usb) { return model_of(maker, usb); });
    for (const FfDeviceInfo& ff : list_ff_devices())
        if (ff.abilities.constant && ff.abilities.stick)
            hands.push_back({"force-stick", ff.name.empty() ? std::string(find_device_spec("force-stick")->spoken_name) : ff.name, ff.path, {}});
    return hands;
}

std::string permission_advice() {
    return fmt::format("You may not open it. Please copy the rule {} into /etc/udev/rules.d and plug the device in again.", kUdevRule);
}

bool is_meant(const FoundDevice& device, std::string_view name_or_serial) {
    return device.name == lower_ascii(name_or_serial) || (!device.serial.empty() && device.serial == name_or_serial);
}

std::vector<std::string> openable_device_names() {
    return {"falcon", "touch", "omni", "phantom-desktop", "phantom-premium", "omega", "sigma", "lambda", "delta", "inverse3", "force-stick"};
}

bool is_found_only_by_opening(std::string_view name) { return name == "touch" || name == "omni" || name.starts_with("phantom-"); }

Result<std::unique_ptr<HapticDevice>> open_device(std::string_view name, std::string_view serial, Clock& clock,
                                                  const std::function<void(const std::string&)>& tell) {
    if (name == "falcon") return open_falcon(serial, clock, tell);
    if (is_found_only_by_opening(name)) return open_hd_device();
    if (name == "omega" || name == "sigma" || name == "lambda" || name == "delta") return open_dhd_device();
    if (name == "inverse3") return open_haply_device(clock);
    if (name == "force-stick") return open_force_stick();
    return fail(fmt::format("There is no driver for \"{}\".", name));
}

}  // namespace handrail
