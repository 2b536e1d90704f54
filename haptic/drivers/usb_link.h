// USB devices through libusb: which of the known ones are plugged in, and a ByteLink to one of them. Any one thread.
// Calls allocate and lock.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/drivers/byte_link.h"
#include "worlds/base/result.h"

namespace handrail {

struct UsbId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;  // 0: any of the vendor's
};

struct UsbDeviceInfo {
    UsbId id;
    int bus = 0, address = 0;
    std::string serial, product_name;  // empty where it may not be asked
    bool permitted = true;             // to open it
    std::string problem;               // why it cannot be opened, as libusb says it; empty when it can
};

// Those among `wanted` that are plugged in, by bus and address. Fails when USB cannot be looked at at all.
Result<std::vector<UsbDeviceInfo>> list_usb_devices(std::span<const UsbId> wanted);

// Claims interface 0; bulk endpoints 0x02 out and 0x81 in, vendor requests to the device, as the FTDI chips have them.
Result<std::unique_ptr<ByteLink>> open_usb_link(const UsbDeviceInfo& device);

}  // namespace handrail
