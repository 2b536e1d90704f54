#include "tests/umockdev/mock_usb.h"
#include "tests/support/names.h"

#include <errno.h>
#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <signal.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <stdexcept>

namespace handrail::test {
namespace {

usbdevfs_urb& urb_of(UMockdevIoctlData* data) { return *reinterpret_cast<usbdevfs_urb*>(data->data); }

std::string hex(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) text += fmt::format("{:02X}", byte);
    return text;
}

}  // namespace

MockUsbDevice::MockUsbDevice(UMockdevTestbed* bed, UsbFunction& function, int address) : function_(function) {
    // Umockdev may write answers to processes that tests have killed, which would end this process.
    ::signal(SIGPIPE, SIG_IGN);
    const std::vector<std::uint8_t> numbers = function.device_descriptor();
    const std::string node = fmt::format("bus/usb/{:03}/{:03}", kBus, address);
    const std::string device = fmt::format(
        "P: /devices/pci0000:00/usb{0}/{0}-{1}\nN: {2}\nE: DEVNAME=/dev/{2}\nE: DEVTYPE=usb_device\nE: "
        "SUBSYSTEM=usb\nE: BUSNUM={0:03}\n"
        "E: DEVNUM={1:03}\nE: MAJOR=189\nE: MINOR={3}\nA: busnum={0}\\n\nA: devnum={1}\\n\nA: speed=12\\n\nA: "
        "idVendor={4:04x}\\n\n"
        "A: idProduct={5:04x}\\n\nA: bConfigurationValue=1\\n\nA: bNumConfigurations=1\\n\nA: devpath={1}\\n\nH: "
        "descriptors={6}{7}\n",
        kBus, address, node, address - 1, numbers[8] | numbers[9] << 8, numbers[10] | numbers[11] << 8, hex(numbers),
        hex(function.configuration_descriptor()));
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(bed, device.c_str(), &error)) throw std::runtime_error(error->message);
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    if (!umockdev_testbed_attach_ioctl(bed, ("/dev/" + node).c_str(), handler_, &error))
        throw std::runtime_error(error->message);
}

MockUsbDevice::~MockUsbDevice() {
    g_signal_handlers_disconnect_by_data(handler_, this);
    g_object_unref(handler_);
}

gboolean MockUsbDevice::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& bus = *static_cast<MockUsbDevice*>(self);
    const std::lock_guard guard(bus.lock);
    return bus.answer(client);
}

void MockUsbDevice::finish(const Urb& urb, int status, std::size_t length) {
    urb_of(urb.urb).status = status;
    urb_of(urb.urb).actual_length = static_cast<int>(length);
    done_.push_back(urb);
}

// Completes the waiting transfers to the host if the device now has data for them.
void MockUsbDevice::serve_waiting() {
    const auto now = std::chrono::steady_clock::now();
    while (!waiting_.empty()) {
        const Urb urb = waiting_.front();
        const auto room = static_cast<std::size_t>(urb_of(urb.urb).buffer_length);
        const auto packet = function_.in(room, std::chrono::duration_cast<std::chrono::milliseconds>(now - urb.since));
        if (!packet) return;
        waiting_.pop_front();
        std::copy_n(packet->begin(), std::min(packet->size(), room), urb.buffer->data);
        finish(urb, 0, std::min(packet->size(), room));
    }
}

// Executes a control transfer. Its buffer has eight set-up bytes, then the data in either direction.
void MockUsbDevice::control(const Urb& urb) {
    constexpr std::size_t kSetup = 8;
    std::uint8_t* bytes = urb.buffer->data;
    const auto room = static_cast<std::size_t>(urb_of(urb.urb).buffer_length);
    if (room < kSetup) return finish(urb, -EPIPE, 0);
    const UsbSetup setup = usb_setup({bytes, kSetup});
    std::vector<std::uint8_t> data;
    if (!setup.to_host()) data.assign(bytes + kSetup, bytes + std::min<std::size_t>(room, kSetup + setup.length));
    if (!function_.answer(setup, data)) return finish(urb, -EPIPE, 0);
    const std::size_t size = std::min<std::size_t>({data.size(), setup.length, room - kSetup});
    if (setup.to_host()) std::copy_n(data.begin(), size, bytes + kSetup);
    finish(urb, 0, size);
}

void MockUsbDevice::submit(UMockdevIoctlData* data, const void* client) {
    usbdevfs_urb& urb = urb_of(data);
    UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer),
                                                            static_cast<gsize>(urb.buffer_length), nullptr);
    const Urb held{static_cast<UMockdevIoctlData*>(g_object_ref(data)),
                   buffer ? static_cast<UMockdevIoctlData*>(g_object_ref(buffer)) : nullptr, client,
                   std::chrono::steady_clock::now()};
    if (!buffer) {
        finish(held, -EPIPE, 0);
    } else if (urb.type == USBDEVFS_URB_TYPE_CONTROL) {
        control(held);
    } else if (urb.endpoint & 0x80) {
        waiting_.push_back(held);
    } else {
        function_.out({buffer->data, static_cast<std::size_t>(urb.buffer_length)});
        finish(held, 0, static_cast<std::size_t>(urb.buffer_length));
    }
    serve_waiting();
}

// Drops the requests of all other clients, as the kernel drops the requests of a process that ends.
void MockUsbDevice::forget_requests_of_others(const void* client) {
    for (auto* queue : {&waiting_, &done_}) {
        for (auto it = queue->begin(); it != queue->end();) {
            if (it->client == client) {
                ++it;
                continue;
            }
            g_object_unref(it->urb);
            if (it->buffer) g_object_unref(it->buffer);
            it = queue->erase(it);
        }
    }
}

gboolean MockUsbDevice::answer(UMockdevIoctlClient* client) {
    UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
    const auto resolved = [&](std::size_t size) { return umockdev_ioctl_data_resolve(argument, 0, size, nullptr); };
    const auto complete = [&](long result, int error) {
        umockdev_ioctl_client_complete(client, result, error);
        return TRUE;
    };
    const auto request = static_cast<unsigned long>(umockdev_ioctl_client_get_request(client));
    if (unplugged && request != USBDEVFS_REAPURBNDELAY && request != USBDEVFS_REAPURB) return complete(-1, ENODEV);
    switch (request) {
        case USBDEVFS_GET_CAPABILITIES:
            if (!resolved(4)) return complete(-1, EFAULT);
            *reinterpret_cast<std::uint32_t*>(resolved(4)->data) =
                USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM;
            return complete(0, 0);
        case USBDEVFS_DISCONNECT_CLAIM:
        case USBDEVFS_CLAIMINTERFACE:
            forget_requests_of_others(client);
            return complete(0, 0);
        case USBDEVFS_RELEASEINTERFACE:
        case USBDEVFS_CLEAR_HALT:
        case USBDEVFS_RESET:
        case USBDEVFS_SETINTERFACE:
            return complete(0, 0);
        case USBDEVFS_GETDRIVER:
        case USBDEVFS_IOCTL:
            return complete(-1, ENODATA);
        case USBDEVFS_SUBMITURB:
            if (UMockdevIoctlData* data = resolved(sizeof(usbdevfs_urb))) {
                submit(data, client);
                return complete(0, 0);
            }
            return complete(-1, EFAULT);  // the calling process died while its request waited
        case USBDEVFS_DISCARDURB: {
            const auto address = *reinterpret_cast<unsigned long*>(argument->data);
            for (auto it = waiting_.begin(); it != waiting_.end(); ++it)
                if (it->urb->client_addr == address) {
                    const Urb urb = *it;
                    waiting_.erase(it);
                    finish(urb, -ENOENT, 0);
                    return complete(0, 0);
                }
            return complete(-1, EINVAL);
        }
        case USBDEVFS_REAPURB:
        case USBDEVFS_REAPURBNDELAY: {
            if (unplugged)
                while (!waiting_.empty()) {
                    const Urb urb = waiting_.front();
                    waiting_.pop_front();
                    finish(urb, -ENODEV, 0);
                }
            serve_waiting();
            const auto mine =
                std::find_if(done_.begin(), done_.end(), [&](const Urb& urb) { return urb.client == client; });
            if (mine == done_.end()) return complete(-1, unplugged ? ENODEV : EAGAIN);
            const Urb urb = *mine;
            done_.erase(mine);
            if (UMockdevIoctlData* pointer = resolved(sizeof(void*))) umockdev_ioctl_data_set_ptr(pointer, 0, urb.urb);
            complete(0, 0);
            g_object_unref(urb.urb);
            if (urb.buffer) g_object_unref(urb.buffer);
            return TRUE;
        }
        default:
            return complete(-1, ENOTTY);
    }
}

}  // namespace handrail::test
