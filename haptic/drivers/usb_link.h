// Lists which of the known USB devices are plugged in, through libusb, and opens a ByteLink to one of them. Any one
// thread. Calls allocate and lock.
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
    std::uint16_t product = 0;  // product number; 0: any product of the vendor
};

struct UsbDeviceInfo {
    UsbId id;
    int bus = 0, address = 0;
    std::string serial, product_name;  // empty if the device may not be queried
    bool permitted = true;             // true if this process may open the device
    std::string problem;               // why this process cannot open the device, in libusb's words; empty if it can
};

// Returns the devices in `wanted` that are plugged in, sorted by bus and address. Fails if USB cannot be queried at
// all.
Result<std::vector<UsbDeviceInfo>> list_usb_devices(std::span<const UsbId> wanted);

// Opens the device and claims interface 0. The link uses the bulk endpoints 0x02 out and 0x81 in, and vendor requests
// to the device, as on the FTDI chips.
Result<std::unique_ptr<ByteLink>> open_usb_link(const UsbDeviceInfo& device);

}  // namespace handrail::drivers
