#include "tests/emulators/usb_function.h"
#include "tests/support/names.h"

#include <algorithm>

namespace handrail::test {
namespace {

constexpr std::uint8_t kGetDescriptor = 6, kGetStatus = 0, kGetConfiguration = 8;
constexpr std::uint8_t kDevice = 1, kConfiguration = 2, kString = 3, kReport = 0x22;
constexpr std::uint8_t kGetReport = 1, kSetReport = 9;
constexpr std::uint8_t kTypeStandard = 0x00, kTypeClass = 0x20, kTypeMaker = 0x40, kTypeMask = 0x60;

std::uint8_t low(unsigned value) { return static_cast<std::uint8_t>(value & 0xff); }
std::uint8_t high(unsigned value) { return static_cast<std::uint8_t>(value >> 8 & 0xff); }

std::vector<std::uint8_t> string_descriptor(const std::string& text) {
    std::vector<std::uint8_t> bytes{low(static_cast<unsigned>(2 + 2 * text.size())), kString};
    for (const char letter : text) bytes.insert(bytes.end(), {static_cast<std::uint8_t>(letter), 0});
    return bytes;
}

}  // namespace

UsbSetup usb_setup(std::span<const std::uint8_t> bytes) {
    const auto word = [&](std::size_t at) { return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8); };
    return {bytes[0], bytes[1], word(2), word(4), word(6)};
}

bool UsbFunction::answer(const UsbSetup& setup, std::vector<std::uint8_t>& data) {
    if ((setup.type & kTypeMask) != kTypeStandard) return control(setup, data);
    if (!setup.to_host()) return true;  // the host sets a configuration or an interface, or ends a halt
    if (setup.request == kGetStatus) data = {1, 0};
    else if (setup.request == kGetConfiguration) data = {1};
    else if (setup.request != kGetDescriptor) return false;
    else if (setup.value >> 8 == kDevice) data = device_descriptor();
    else if (setup.value >> 8 == kConfiguration) data = configuration_descriptor();
    else if (setup.value >> 8 != kString) return control(setup, data);
    else if (low(setup.value) == 0) data = {4, kString, 9, 4};  // string 0 lists the languages: English
    else data = string_descriptor(low(setup.value) == 2 ? product() : low(setup.value) == 3 ? "SN1" : "Test");
    return true;
}

std::vector<std::uint8_t> FalconOnUsb::device_descriptor() const {
    return {18, 1, 0x00, 0x02, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xcb, 0x00, 0x04, 1, 2, 0, 1};
}

std::vector<std::uint8_t> FalconOnUsb::configuration_descriptor() const {
    return {9,    2, 32, 0, 1,    1, 0,  0x80, 45, 9, 4, 0,    0, 2,  0xff, 0xff,
            0xff, 0, 7,  5, 0x81, 2, 64, 0,    0,  7, 5, 0x02, 2, 64, 0,    0};
}

bool FalconOnUsb::control(const UsbSetup& setup, std::vector<std::uint8_t>&) {
    return setup.type == kTypeMaker && falcon_.control(setup.request, setup.value);
}

std::optional<std::vector<std::uint8_t>> FalconOnUsb::in(std::size_t room, std::chrono::milliseconds waited) {
    if (!falcon_.has_payload() && waited < std::chrono::milliseconds(falcon_.latency_ms)) return std::nullopt;
    std::vector<std::uint8_t> packet(room);
    packet.resize(falcon_.in(packet.data(), packet.size()));
    return packet;
}

std::vector<std::uint8_t> HidOnUsb::device_descriptor() const {
    return {
        18,   1,    0x00, 0x02, 0, 0, 0, 64, low(vendor_), high(vendor_), low(product_number_), high(product_number_),
        0x00, 0x01, 1,    2,    3, 1};
}

std::vector<std::uint8_t> HidOnUsb::configuration_descriptor() const {
    const auto length = static_cast<unsigned>(device_.descriptor().size());
    return {9,    2,    41,   0, 1, 1, 0,       0xc0,        0xfa,         9, 4, 0,    0, 2,  3, 0, 0, 0,
            9,    0x21, 0x11, 1, 0, 1, kReport, low(length), high(length), 7, 5, 0x84, 3, 64, 0, 1, 7, 5,
            0x03, 3,    64,   0, 1};
}

bool HidOnUsb::control(const UsbSetup& setup, std::vector<std::uint8_t>& data) {
    if (setup.type == 0x81 && setup.request == kGetDescriptor && setup.value >> 8 == kReport) {
        data = device_.descriptor();
        return true;
    }
    if ((setup.type & kTypeMask) != kTypeClass) return false;
    if (setup.to_host() && setup.request == kGetReport) {
        data = device_.feature(low(setup.value));
        return !data.empty();
    }
    if (!setup.to_host() && setup.request == kSetReport) return device_.take(data);
    return !setup.to_host();  // the host sets the idle rate or the protocol, which have no effect here
}

std::optional<std::vector<std::uint8_t>> HidOnUsb::in(std::size_t room, std::chrono::milliseconds) {
    if (device_.to_host.empty()) return std::nullopt;
    std::vector<std::uint8_t> packet = std::move(device_.to_host.front());
    device_.to_host.pop_front();
    packet.resize(std::min(packet.size(), room));
    return packet;
}

}  // namespace handrail::test
