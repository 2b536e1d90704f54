// USB devices through libusb: lists which of the known ones are plugged in, and opens a ByteLink to one of them. Any
// one thread. Calls allocate and lock.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/drivers/byte_link.h"
#include "worlds/base/result.h"

namespace handrail::drivers {

struct UsbId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;  // 0: any product of the vendor
};

struct UsbDeviceInfo {
    UsbId id;
    int bus = 0, address = 0;
    std::string serial, product_name;  // empty if it may not be queried
    bool permitted = true;             // may be opened
    std::string problem;               // why it cannot be opened, in libusb's words; empty if it can
};

// The devices among `wanted` that are plugged in, by bus and address. Fails if USB cannot be queried at all.
Result<std::vector<UsbDeviceInfo>> list_usb_devices(std::span<const UsbId> wanted);

// Claims interface 0; bulk endpoints 0x02 out and 0x81 in, vendor requests to the device, as on the FTDI chips.
Result<std::unique_ptr<ByteLink>> open_usb_link(const UsbDeviceInfo& device);

}  // namespace handrail::drivers
