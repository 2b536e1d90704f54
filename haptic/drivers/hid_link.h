// Defines the interface to a device that exchanges HID reports. Drivers use HidLink for hidapi; an emulator can
// implement it, too. Byte 0 of each report is the report's number. One thread at a time. Private to haptic/drivers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::drivers {

class HidLink {
public:
    static constexpr int kLost = -1;  // result of a call if the device is gone

    virtual ~HidLink() = default;
    // Writes the whole report. Returns false if nothing was written.
    virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
    // Reads one report. Returns the report's size, 0 if none came in time, or kLost.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
    // Requests the feature report whose number is in room[0]. Returns the report's size, or kLost if the device
    // refused.
    virtual int feature(std::span<std::uint8_t> room) noexcept = 0;
};

struct HidDeviceInfo {
    std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;
    bool bluetooth = false;
    bool permitted = true;  // true if this process may open the device
    std::string path, serial, product_name;
};

// Lists every HID device that is connected by cable or Bluetooth, sorted by path. Both functions may be called from any
// thread.
std::vector<HidDeviceInfo> list_hid_devices();
Result<std::unique_ptr<HidLink>> open_hid_link(const HidDeviceInfo& device);

}  // namespace handrail::drivers
