// Models a device as a USB bus sees it: descriptors, control requests and packets. The tests put such a device on two
// buses: usbfs of umockdev (tests/umockdev), and the kernel's own bus through USB/IP (tests/kernel). Not thread-safe;
// the bus locks a mutex around the device.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/emulators/falcon_emulator.h"
#include "tests/emulators/hid_emulators.h"
#include "tests/support/names.h"

namespace handrail::test {

// The eight set-up bytes before every control transfer.
struct UsbSetup {
    std::uint8_t type = 0, request = 0;
    std::uint16_t value = 0, index = 0, length = 0;
    bool to_host() const { return (type & 0x80) != 0; }
};
UsbSetup usb_setup(std::span<const std::uint8_t> bytes);

class UsbFunction {
public:
    virtual ~UsbFunction() = default;
    virtual std::vector<std::uint8_t> device_descriptor() const = 0;
    virtual std::vector<std::uint8_t> configuration_descriptor() const = 0;
    virtual std::string product() const = 0;
    // Handles requests of the device's class or maker. A request to the host fills `data`; a request from the host has
    // its data there. Returns false if the device refuses the request.
    virtual bool control(const UsbSetup& setup, std::vector<std::uint8_t>& data) = 0;
    virtual void out(std::span<const std::uint8_t> packet) = 0;
    // Returns one packet of at most `room` bytes. `waited` is how long the host has waited for it. If the function
    // returns no packet, the host continues to wait.
    virtual std::optional<std::vector<std::uint8_t>> in(std::size_t room, std::chrono::milliseconds waited) = 0;

    // Answers the control requests that every device knows, and passes the others to control().
    bool answer(const UsbSetup& setup, std::vector<std::uint8_t>& data);
};

// A Falcon's USB interface: an FT232-class chip with the Falcon's identifiers, bulk in 0x81, bulk out 0x02.
class FalconOnUsb final : public UsbFunction {
public:
    explicit FalconOnUsb(FalconEmulator& falcon) : falcon_(falcon) {}
    std::vector<std::uint8_t> device_descriptor() const override;
    std::vector<std::uint8_t> configuration_descriptor() const override;
    std::string product() const override { return "FALCON HAPTIC"; }
    bool control(const UsbSetup& setup, std::vector<std::uint8_t>& data) override;
    void out(std::span<const std::uint8_t> packet) override { falcon_.out(packet.data(), packet.size()); }
    // If the Falcon has no data, the chip returns only its two status bytes when the latency timer expires.
    std::optional<std::vector<std::uint8_t>> in(std::size_t room, std::chrono::milliseconds waited) override;

private:
    FalconEmulator& falcon_;
};

struct FalconAndItsChip {
    FalconEmulator falcon;
    FalconOnUsb chip{falcon};
};

// A HID device with one interface: interrupt in 0x84 and out 0x03.
class HidOnUsb final : public UsbFunction {
public:
    HidOnUsb(HidEmulator& device, std::uint16_t vendor, std::uint16_t product_number, std::string product_name)
        : device_(device), vendor_(vendor), product_number_(product_number), product_(std::move(product_name)) {}
    std::vector<std::uint8_t> device_descriptor() const override;
    std::vector<std::uint8_t> configuration_descriptor() const override;
    std::string product() const override { return product_; }
    bool control(const UsbSetup& setup, std::vector<std::uint8_t>& data) override;
    void out(std::span<const std::uint8_t> packet) override { device_.take(packet); }
    std::optional<std::vector<std::uint8_t>> in(std::size_t room, std::chrono::milliseconds waited) override;

private:
    HidEmulator& device_;
    std::uint16_t vendor_, product_number_;
    std::string product_;
};

}  // namespace handrail::test
