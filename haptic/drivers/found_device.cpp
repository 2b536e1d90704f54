#include "haptic/drivers/found_device.h"

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
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::drivers {
namespace {

// Greatest number of exchanges with zero force. The device must answer two of them.
constexpr int kZeroExchanges = 5;

constexpr std::array kFalconIds{UsbId{0x0403, 0xcb48}};

std::string why_not(const UsbDeviceInfo& usb) {
    return usb.permitted ? phrase("device.cannot_open", {{"reason", usb.problem}}) : permission_advice();
}

std::string place_of(const UsbDeviceInfo& usb) {
    return phrase("device.usb_place", {{"bus", usb.bus}, {"device", usb.address}});
}

// Returns the first valid firmware file, or an empty path if there is none.
std::filesystem::path falcon_firmware_file() {
    for (const std::filesystem::path& file : falcon_firmware_files())
        if (falcon_firmware_is_sound(file)) return file;
    return {};
}

// Queries a Falcon by one or two neutral frames. Sends no force and no firmware.
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
    const std::filesystem::path file = running ? std::filesystem::path() : falcon_firmware_file();
    found.usable = running || !file.empty();
    found.firmware = running ? phrase("device.firmware_running")
                     : !file.empty()
                         ? phrase("device.firmware_not_running", {{"file", file.string()}})
                         : phrase("device.firmware_missing", {{"folder", falcon_firmware_folder().string()}});
    if (!found.usable) found.problem = phrase("device.firmware_lacks", {{"folder", falcon_firmware_folder().string()}});
    const int legs = std::popcount(static_cast<unsigned>(falcon.homed_legs()));
    found.needs_calibration = !running || legs != 3;
    found.calibration = !running    ? phrase("device.falcon_asleep")
                        : legs == 3 ? phrase("device.falcon_homed", {{"newtons", found.spec->peak_force_n}})
                                    : phrase("device.falcon_not_homed", {{"legs", legs}});
}

void find_falcons(std::vector<FoundDevice>& found) {
    const auto plugged = list_usb_devices(kFalconIds);
    if (!plugged) return;
    for (const UsbDeviceInfo& usb : *plugged) {
        FoundDevice device;
        device.name = "falcon";
        device.model = "Novint Falcon";
        device.driver = phrase("device.own_driver", {{"library", "libusb"}});
        device.connection = place_of(usb);
        device.serial = usb.serial;
        device.spec = *device::find_device_spec("falcon");
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
    device.calibration = phrase("device.no_calibration");
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

// Adds the HID devices to `found`. Returns true if there is at least one.
bool find_hid_devices(std::vector<FoundDevice>& found) {
    const std::size_t before = found.size();
    for (const HidDeviceInfo& hid : list_hid_devices()) {
        const auto pad = playstation_pad(hid.vendor, hid.product);
        const bool puck = is_space_mouse(hid);
        if (!pad && !puck) continue;
        FoundDevice device;
        device.driver = phrase("device.own_driver", {{"library", "hidapi"}});
        device.connection = (hid.bluetooth ? "Bluetooth, " : "USB, ") + hid.path;
        device.serial = hid.serial;
        device.usable = hid.permitted;
        if (!hid.permitted) device.problem = permission_advice();
        if (puck) {
            device.name = "spacemouse";
            device.model = hid.product_name.empty() ? "SpaceMouse" : hid.product_name;
            device.kind = DeviceKind::Navigation;
            device.rate_hz = 125.0;
            device.calibration = phrase("device.no_calibration");
        } else {
            look_at_pad(hid, *pad, device);
        }
        found.push_back(std::move(device));
    }
    return found.size() > before;
}

// A device that only its maker's library can control. Its USB numbers show whether one is plugged in. Only the guard
// loads the library itself, when the person chooses the device.
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
    std::vector<std::string> folders{"/usr/lib", "/usr/lib64", "/usr/lib/x86_64-linux-gnu", "/usr/local/lib",
                                     "/lib/x86_64-linux-gnu"};
    const char* named = std::getenv("LD_LIBRARY_PATH");
    for (std::string rest = named ? named : ""; !rest.empty();) {
        const std::size_t end = rest.find(':');
        folders.push_back(rest.substr(0, end));
        rest = end == std::string::npos ? std::string() : rest.substr(end + 1);
    }
    std::error_code ec;
    return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        return std::any_of(maker.libraries.begin(), maker.libraries.end(), [&](std::string_view library) {
            return !library.empty() && !folder.empty() &&
                   std::filesystem::exists(std::filesystem::path(folder) / library, ec);
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
            device.spec = *device::find_device_spec(device.name);
            device.model = std::string(maker.name) + " " +
                           (usb.product_name.empty() ? device.spec->spoken_name() : usb.product_name);
            device.driver = phrase("device.makers_library", {{"library", maker.libraries.front()}});
            device.connection = place_of(usb);
            device.serial = usb.serial;
            device.firmware = phrase("device.own_firmware");
            device.calibration = phrase("device.calibration_later");
            device.rate_hz = 1000.0;
            device.usable = library_lies_somewhere(maker);
            if (!device.usable)
                device.problem =
                    phrase("device.no_library", {{"library", maker.libraries.front()}, {"maker", maker.name}});
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
    device.driver = phrase("device.makers_service");
    device.connection = phrase("device.port", {{"address", "127.0.0.1"}, {"port", kHaplyPort}});
    device.serial = facts->device_id;
    device.firmware = facts->firmware.empty() ? phrase("device.own_firmware") : facts->firmware;
    device.needs_calibration = !facts->calibrated;
    device.calibration = phrase(facts->calibrated ? "device.calibrated" : "device.not_calibrated");
    device.spec = *device::find_device_spec("inverse3");
    device.rate_hz = 1000.0;
    found.push_back(std::move(device));
}

// Adds force-feedback event nodes to `found`. A pad that one of our drivers controls over hidapi also has an event
// node. If such a pad was found, `known` is true and its event node is skipped, so that the pad is reported only once.
void find_ff_devices(std::vector<FoundDevice>& found, bool known) {
    for (const FfDeviceInfo& ff : list_ff_devices()) {
        const bool stick = ff.abilities.constant && ff.abilities.stick;
        if (!stick && known && is_event_node_of_a_playstation_pad(ff.name)) continue;
        FoundDevice device;
        device.name = stick ? "force-stick" : "rumble-pad";
        device.model = ff.name.empty() ? device.name : ff.name;
        device.kind = stick ? DeviceKind::Kinesthetic : DeviceKind::Cues;
        device.driver = phrase("device.kernels_driver");
        device.connection = ff.path;
        device.calibration = phrase("device.no_calibration");
        if (stick) device.spec = *device::find_device_spec("force-stick");
        device.rate_hz = stick ? 250.0 : 20.0;
        found.push_back(std::move(device));
    }
}

Result<std::unique_ptr<device::HapticDevice>> open_force_stick() {
    for (const FfDeviceInfo& ff : list_ff_devices()) {
        if (!ff.abilities.constant || !ff.abilities.stick) continue;
        auto link = open_ff_link(ff.path);
        if (!link) return tl::unexpected(link.error());
        auto device = std::make_unique<ForceStick>(std::move(*link));
        if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
        return std::unique_ptr<device::HapticDevice>(std::move(device));
    }
    return fail(phrase("drivers.no_force_stick"));
}

// Opens a Falcon. If `firmware_files` is empty, it opens only a Falcon whose firmware already runs.
Result<std::unique_ptr<device::HapticDevice>> open_falcon(std::string_view serial, Clock& clock,
                                                          std::vector<std::filesystem::path> firmware_files,
                                                          const std::function<void(const std::string&)>& report) {
    const auto plugged = list_usb_devices(kFalconIds);
    if (!plugged) return tl::unexpected(plugged.error());
    const auto wanted = std::find_if(plugged->begin(), plugged->end(),
                                     [&](const UsbDeviceInfo& usb) { return serial.empty() || usb.serial == serial; });
    if (wanted == plugged->end()) return fail(phrase("drivers.no_falcon"));
    if (!wanted->problem.empty()) return fail(why_not(*wanted));
    auto link = open_usb_link(*wanted);
    if (!link) return tl::unexpected(link.error());
    FalconOptions options;
    options.firmware_files = std::move(firmware_files);
    options.report = report;
    auto device = std::make_unique<FalconDevice>(std::move(*link), clock, std::move(options));
    if (const auto opened = device->open(); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<device::HapticDevice>(std::move(device));
}

}  // namespace

std::string_view device_state(const FoundDevice& device) {
    if (!device.usable) return "cannot be used yet";
    return device.needs_calibration ? "needs calibration" : "ready";
}

std::string spoken_device_state(const FoundDevice& device) {
    if (!device.usable) return phrase("device.state_not_usable");
    return phrase(device.needs_calibration ? "device.state_needs_calibration" : "device.state_ready");
}

std::vector<FoundDevice> find_devices() {
    std::vector<FoundDevice> found;
    find_falcons(found);
    find_makers_devices(found);
    find_inverse3(found);
    const bool over_hid = find_hid_devices(found);
    find_ff_devices(found, over_hid);
    return found;
}

std::vector<PluggedHand> plugged_hands() {
    std::vector<PluggedHand> hands;
    const auto add_usb = [&](std::span<const UsbId> ids, auto&& name_of) {
        const auto plugged = list_usb_devices(ids);
        if (!plugged) return;
        for (const UsbDeviceInfo& usb : *plugged) {
            const device::DeviceSpec& spec = *device::find_device_spec(name_of(usb));
            hands.push_back({std::string(spec.name), spec.spoken_name(), place_of(usb),
                             usb.problem.empty() ? std::string() : why_not(usb)});
        }
    };
    add_usb(kFalconIds, [](const UsbDeviceInfo&) { return std::string_view("falcon"); });
    for (const Maker& maker : kMakers)
        add_usb(std::span(&maker.id, 1), [&](const UsbDeviceInfo& usb) { return model_of(maker, usb); });
    for (const FfDeviceInfo& ff : list_ff_devices())
        if (ff.abilities.constant && ff.abilities.stick)
            hands.push_back({"force-stick",
                             ff.name.empty() ? device::find_device_spec("force-stick")->spoken_name() : ff.name,
                             ff.path,
                             {}});
    return hands;
}

std::string permission_advice() { return phrase("device.permission", {{"rule", kUdevRule}}); }

bool is_meant(const FoundDevice& device, std::string_view name_or_serial) {
    return device.name == lower_ascii(name_or_serial) || (!device.serial.empty() && device.serial == name_or_serial);
}

std::vector<std::string> openable_device_names() {
    return {"falcon", "touch",  "omni",  "phantom-desktop", "phantom-premium", "omega",
            "sigma",  "lambda", "delta", "inverse3",        "force-stick"};
}

bool is_found_only_by_opening(std::string_view name) {
    return name == "touch" || name == "omni" || name.starts_with("phantom-");
}

Result<std::unique_ptr<device::HapticDevice>> open_device(std::string_view name, std::string_view serial, Clock& clock,
                                                          const std::function<void(const std::string&)>& report) {
    if (name == "falcon") return open_falcon(serial, clock, falcon_firmware_files(), report);
    if (is_found_only_by_opening(name)) return open_hd_device();
    if (name == "omega" || name == "sigma" || name == "lambda" || name == "delta") return open_dhd_device();
    if (name == "inverse3") return open_haply_device(clock);
    if (name == "force-stick") return open_force_stick();
    return fail(phrase("drivers.no_driver", {{"device", name}}));
}

Result<void> zero_device(std::string_view name, std::string_view serial, Clock& clock) {
    // A Falcon gets no firmware here: without firmware it gives no force, and sending would take seconds.
    auto device = name == "falcon" ? open_falcon(serial, clock, {}, nullptr)
                                   : open_device(name, serial, clock, [](const std::string&) {});
    if (!device) return tl::unexpected(device.error());
    device::DeviceSample sample;
    for (int i = 0; i < kZeroExchanges && !(sample.connected && sample.fresh && i > 0); ++i) {
        (*device)->write({});
        sample = (*device)->read(clock.now_s());
    }
    const bool taken = sample.connected && sample.fresh;
    (*device)->close();
    if (!taken) return fail(phrase("drivers.zero_not_taken", {{"device", (*device)->spec().spoken_name()}}));
    return {};
}

}  // namespace handrail::drivers
