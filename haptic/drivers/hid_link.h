// A device that speaks in HID reports: what a driver needs of hidapi, and what an emulator can stand in for. Reports
// carry their number in byte 0. One thread at a time. Private to haptic/drivers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

class HidLink {
public:
    static constexpr int kLost = -1;  // the device is gone

    virtual ~HidLink() = default;
    // The whole report or nothing.
    virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
    // The bytes of one report; 0 when none came in time; kLost.
    virtual int read(std::span<std::uint8_t> room, double timeout_s) noexcept = 0;
    // Asks for the feature report whose number stands in room[0]; its length, or kLost when it was refused.
    virtual int feature(std::span<std::uint8_t> room) noexcept = 0;
};

struct HidDeviceInfo {
    std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;
    bool bluetooth = false;
    bool permitted = true;  // to open it
    std::string path, serial, product_name;
};

// Every HID device plugged in or connected, by path. Both functions may be called from any thread.
std::vector<HidDeviceInfo> list_hid_devices();
Result<std::unique_ptr<HidLink>> open_hid_link(const HidDeviceInfo& device);

}  // namespace handrail
