#include "haptic/drivers/hid_link.h"

#include <hidapi/hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

struct DeviceEnd {
    void operator()(hid_device* device) const { hid_close(device); }
};

class HidapiLink final : public HidLink {
public:
    explicit HidapiLink(hid_device* device) : device_(device) {}

    bool write(std::span<const std::uint8_t> report) noexcept override {
        return hid_write(device_.get(), report.data(), report.size()) == static_cast<int>(report.size());
    }
    int read(std::span<std::uint8_t> room, double timeout_s) noexcept override {
        const int size = hid_read_timeout(device_.get(), room.data(), room.size(),
                                          static_cast<int>(std::clamp(std::ceil(timeout_s * 1000.0), 0.0, 10000.0)));
        return size < 0 ? kLost : size;
    }
    int feature(std::span<std::uint8_t> room) noexcept override {
        const int size = hid_get_feature_report(device_.get(), room.data(), room.size());
        return size < 0 ? kLost : size;
    }

private:
    std::unique_ptr<hid_device, DeviceEnd> device_;
};

// Protects hidapi's functions for listing and opening devices, because hidapi stores its last error in one place for
// all threads.
std::mutex& hidapi_lock() {
    static std::mutex lock;
    return lock;
}

// Converts a device's name to ASCII for use in sentences. Any other character becomes a question mark.
std::string narrow(const wchar_t* text) {
    std::string out;
    for (; text && *text; ++text) out += *text >= 32 && *text < 127 ? static_cast<char>(*text) : '?';
    return out;
}

}  // namespace

std::vector<HidDeviceInfo> list_hid_devices() {
    const std::lock_guard guard(hidapi_lock());
    std::vector<HidDeviceInfo> found;
    hid_device_info* all = hid_enumerate(0, 0);
    for (const hid_device_info* at = all; at; at = at->next) {
        HidDeviceInfo info;
        info.vendor = at->vendor_id;
        info.product = at->product_id;
        info.usage_page = at->usage_page;
        info.usage = at->usage;
        info.path = at->path ? at->path : "";
        info.serial = narrow(at->serial_number);
        info.product_name = narrow(at->product_string);
        info.bluetooth = at->bus_type == HID_API_BUS_BLUETOOTH;
        info.permitted = ::access(info.path.c_str(), R_OK | W_OK) == 0;
        found.push_back(std::move(info));
    }
    hid_free_enumeration(all);
    std::sort(found.begin(), found.end(),
              [](const HidDeviceInfo& a, const HidDeviceInfo& b) { return a.path < b.path; });
    return found;
}

Result<std::unique_ptr<HidLink>> open_hid_link(const HidDeviceInfo& device) {
    const std::lock_guard guard(hidapi_lock());
    hid_device* opened = hid_open_path(device.path.c_str());
    if (!opened)
        return fail(device.product_name.empty() ? phrase("drivers.cannot_open_any")
                                                : phrase("drivers.cannot_open", {{"device", device.product_name}}));
    return std::unique_ptr<HidLink>(std::make_unique<HidapiLink>(opened));
}

}  // namespace handrail::drivers
