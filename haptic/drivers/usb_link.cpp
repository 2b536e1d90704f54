#include "haptic/drivers/usb_link.h"

#include <libusb-1.0/libusb.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/language.h"

namespace handrail::drivers {
namespace {

constexpr unsigned char kBulkOut = 0x02, kBulkIn = 0x81;
constexpr std::uint8_t kVendorRequestOut = 0x40;
constexpr unsigned kControlTimeoutMs = 1000;

struct ContextEnd {
    void operator()(libusb_context* context) const { libusb_exit(context); }
};
struct HandleEnd {
    void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using Context = std::unique_ptr<libusb_context, ContextEnd>;
using UsbHandle = std::unique_ptr<libusb_device_handle, HandleEnd>;

Context make_context() {
    libusb_context* context = nullptr;
    return Context(libusb_init(&context) == 0 ? context : nullptr);
}

// Calls visit(device, descriptor) for each device until visit returns true.
template <class Visit>
void for_each_device(libusb_context* context, Visit&& visit) {
    libusb_device** devices = nullptr;
    const ssize_t count = libusb_get_device_list(context, &devices);
    for (ssize_t i = 0; i < count; ++i) {
        libusb_device_descriptor descriptor{};
        if (libusb_get_device_descriptor(devices[i], &descriptor) == 0 && visit(devices[i], descriptor)) break;
    }
    if (count >= 0) libusb_free_device_list(devices, 1);
}

std::string text_of(libusb_device_handle* handle, std::uint8_t index) {
    std::array<unsigned char, 256> text{};
    if (index == 0) return {};
    const int length = libusb_get_string_descriptor_ascii(handle, index, text.data(), static_cast<int>(text.size()));
    return length > 0 ? std::string(text.begin(), text.begin() + length) : std::string();
}

// Returns the reason for a USB error. The usual reasons are translated; the others are in libusb's words.
std::string reason_of_usb(int status) {
    switch (status) {
        case LIBUSB_ERROR_IO:
            return phrase("drivers.usb_io");
        case LIBUSB_ERROR_ACCESS:
            return phrase("drivers.usb_access");
        case LIBUSB_ERROR_NO_DEVICE:
            return phrase("drivers.usb_gone");
        case LIBUSB_ERROR_NOT_FOUND:
            return phrase("drivers.usb_not_found");
        case LIBUSB_ERROR_BUSY:
            return phrase("drivers.usb_busy");
        default:
            return libusb_strerror(static_cast<libusb_error>(status));
    }
}

unsigned milliseconds(double seconds) noexcept {
    // At least 1, because libusb waits for ever if it gets 0.
    return static_cast<unsigned>(std::clamp(std::ceil(seconds * 1000.0), 1.0, 10000.0));
}

class LibusbLink final : public ByteLink {
public:
    LibusbLink(Context context, UsbHandle handle) : context_(std::move(context)), handle_(std::move(handle)) {}
    ~LibusbLink() override { libusb_release_interface(handle_.get(), 0); }

    bool control(std::uint8_t request, std::uint16_t value) noexcept override {
        return libusb_control_transfer(handle_.get(), kVendorRequestOut, request, value, 0, nullptr, 0,
                                       kControlTimeoutMs) >= 0;
    }
    int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept override {
        // libusb does not modify the bytes that it writes.
        return bulk(kBulkOut, const_cast<unsigned char*>(bytes.data()), bytes.size(), timeout_s);
    }
    int read(std::span<std::uint8_t> room, double timeout_s) noexcept override {
        return bulk(kBulkIn, room.data(), room.size(), timeout_s);
    }

private:
    int bulk(unsigned char endpoint, unsigned char* bytes, std::size_t size, double timeout_s) noexcept {
        int done = 0;
        const int status = libusb_bulk_transfer(handle_.get(), endpoint, bytes, static_cast<int>(size), &done,
                                                milliseconds(timeout_s));
        if (status == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_.get(), endpoint);
        const bool goes_on = status == 0 || status == LIBUSB_ERROR_TIMEOUT || status == LIBUSB_ERROR_PIPE ||
                             status == LIBUSB_ERROR_OVERFLOW || status == LIBUSB_ERROR_INTERRUPTED;
        return goes_on ? done : kLost;
    }

    Context context_;  // must outlive the handle
    UsbHandle handle_;
};

}  // namespace

Result<std::vector<UsbDeviceInfo>> list_usb_devices(std::span<const UsbId> wanted) {
    const Context context = make_context();
    if (!context) return fail(phrase("drivers.no_usb"));
    std::vector<UsbDeviceInfo> found;
    for_each_device(context.get(), [&](libusb_device* device, const libusb_device_descriptor& descriptor) {
        const bool known = std::any_of(wanted.begin(), wanted.end(), [&](const UsbId& id) {
            return id.vendor == descriptor.idVendor && (id.product == 0 || id.product == descriptor.idProduct);
        });
        if (!known) return false;
        UsbDeviceInfo info;
        info.id = {descriptor.idVendor, descriptor.idProduct};
        info.bus = libusb_get_bus_number(device);
        info.address = libusb_get_device_address(device);
        libusb_device_handle* raw = nullptr;
        if (const int status = libusb_open(device, &raw); status != 0) {
            info.permitted = status != LIBUSB_ERROR_ACCESS;
            info.problem = reason_of_usb(status);
        } else {
            const UsbHandle handle(raw);
            info.serial = text_of(raw, descriptor.iSerialNumber);
            info.product_name = text_of(raw, descriptor.iProduct);
        }
        found.push_back(std::move(info));
        return false;
    });
    std::sort(found.begin(), found.end(), [](const UsbDeviceInfo& a, const UsbDeviceInfo& b) {
        return std::pair(a.bus, a.address) < std::pair(b.bus, b.address);
    });
    return found;
}

Result<std::unique_ptr<ByteLink>> open_usb_link(const UsbDeviceInfo& wanted) {
    Context context = make_context();
    if (!context) return fail(phrase("drivers.no_usb"));
    libusb_device_handle* raw = nullptr;
    int status = LIBUSB_ERROR_NO_DEVICE;
    for_each_device(context.get(), [&](libusb_device* device, const libusb_device_descriptor& descriptor) {
        if (descriptor.idVendor != wanted.id.vendor || descriptor.idProduct != wanted.id.product ||
            libusb_get_bus_number(device) != wanted.bus || libusb_get_device_address(device) != wanted.address)
            return false;
        status = libusb_open(device, &raw);
        return true;
    });
    if (status != 0) return fail(phrase("drivers.usb_cannot_open", {{"reason", reason_of_usb(status)}}));
    UsbHandle handle(raw);
    libusb_set_auto_detach_kernel_driver(raw, 1);
    if (status = libusb_claim_interface(raw, 0); status != 0)
        return fail(status == LIBUSB_ERROR_BUSY
                        ? phrase("drivers.usb_in_use")
                        : phrase("drivers.usb_cannot_use", {{"reason", reason_of_usb(status)}}));
    return std::unique_ptr<ByteLink>(std::make_unique<LibusbLink>(std::move(context), std::move(handle)));
}

}  // namespace handrail::drivers
