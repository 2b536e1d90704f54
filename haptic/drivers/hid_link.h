// A device that exchanges HID reports: what a driver needs of hidapi, and what an emulator can replace. Reports have
// their number in byte 0. One thread at a time. Private to haptic/drivers.
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
    static constexpr int kLost = -1;  // the device is gone

    virtual ~HidLink() = default;
    // Writes the whole report or nothing.
    virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
    // Reads one report. Returns its size; 0 if none came in time; or kLost.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
    // Requests the feature report whose number is in room[0]. Returns its length, or kLost if it was refused.
    virtual int feature(std::span<std::uint8_t> room) noexcept = 0;
};

struct HidDeviceInfo {
    std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;
    bool bluetooth = false;
    bool permitted = true;  // may be opened
    std::string path, serial, product_name;
};

// Lists every HID device that is plugged in or connected, by path. Both functions may be called from any thread.
std::vector<HidDeviceInfo> list_hid_devices();
Result<std::unique_ptr<HidLink>> open_hid_link(const HidDeviceInfo& device);

}  // namespace handrail::drivers
