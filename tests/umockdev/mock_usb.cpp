#include "tests/umockdev/mock_usb.h"

#include <errno.h>
#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <signal.h>
#include <sys/ioctl.h>

#include <stdexcept>

namespace handrail::test {
namespace {

usbdevfs_urb& urb_of(UMockdevIoctlData* data) { return *reinterpret_cast<usbdevfs_urb*>(data->data); }

// Device and configuration of an FT232-class chip with the Falcon's numbers: one interface, bulk in 0x81, bulk out 0x02.
std::string descriptors() {
    static constexpr std::uint8_t kBytes[] = {18,   1,  0x00, 0x02, 0, 0, 0, 8,    0x03, 0x04, 0x48, 0xcb, 0x00, 0x04, 0, 0,  0, 1, 9, 2, 32,   0, 1,  1, 0,
                                              0x80, 45, 9,    4,    0, 0, 2, 0xff, 0xff, 0xff, 0,    7,    5,    0x81, 2, 64, 0, 0, 7, 5, 0x02, 2, 64, 0, 0};
    std::string text;
    for (const std::uint8_t byte : kBytes) text += fmt::format("{:02X}", byte);
    return text;
}

}  // namespace

MockFalconBus::MockFalconBus(UMockdevTestbed* bed) {
    ::signal(SIGPIPE, SIG_IGN);  // umockdev answers processes that tests have killed
    const std::string device =
        "P: /devices/pci0000:00/usb1/1-1\nN: bus/usb/001/007\nE: DEVNAME=/dev/bus/usb/001/007\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\n"
        "E: BUSNUM=001\nE: DEVNUM=007\nE: MAJOR=189\nE: MINOR=6\nA: busnum=1\\n\nA: devnum=7\\n\nA: speed=12\\n\nA: idVendor=0403\\n\n"
        "A: idProduct=cb48\\n\nA: bConfigurationValue=1\\n\nA: bNumConfigurations=1\\n\nA: devpath=1\\n\nH: descriptors=" +
        descriptors() + "\n";
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(bed, device.c_str(), &error)) throw std::runtime_error(error->message);
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    if (!umockdev_testbed_attach_ioctl(bed, "/dev/bus/usb/001/007", handler_, &error)) throw std::runtime_error(error->message);
}

MockFalconBus::~MockFalconBus() {
    g_signal_handlers_disconnect_by_data(handler_, this);
    g_object_unref(handler_);
}

gboolean MockFalconBus::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& bus = *static_cast<MockFalconBus*>(self);
    const std::lock_guard guard(bus.lock);
    return bus.answer(client);
}

void MockFalconBus::finish(const Urb& urb, int status, int length) {
    urb_of(urb.urb).status = status;
    urb_of(urb.urb).actual_length = length;
    done_.push_back(urb);
}

// IN transfers wait until the chip has bytes, or its latency timer sends two status bytes alone.
void MockFalconBus::serve_waiting() {
    const auto now = std::chrono::steady_clock::now();
    while (!waiting_.empty() && (falcon.has_payload() || now - waiting_.front().since >= std::chrono::milliseconds(falcon.latency_ms))) {
        const Urb urb = waiting_.front();
        waiting_.pop_front();
        const auto room = static_cast<std::size_t>(urb_of(urb.urb).buffer_length);
        finish(urb, 0, static_cast<int>(falcon.in(urb.buffer->data, room)));
    }
}

void MockFalconBus::submit(UMockdevIoctlData* data) {
    usbdevfs_urb& urb = urb_of(data);
    UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urb.buffer_length), nullptr);
    const Urb held{static_cast<UMockdevIoctlData*>(g_object_ref(data)), buffer ? static_cast<UMockdevIoctlData*>(g_object_ref(buffer)) : nullptr,
                   std::chrono::steady_clock::now()};
    if (urb.type == USBDEVFS_URB_TYPE_CONTROL && buffer) {
        const std::uint8_t* setup = buffer->data;
        const bool taken = setup[0] == 0x40 && falcon.control(setup[1], static_cast<std::uint16_t>(setup[2] | setup[3] << 8));
        finish(held, taken ? 0 : -EPIPE, 0);
    } else if (urb.endpoint == 0x02 && buffer) {
        falcon.out(buffer->data, static_cast<std::size_t>(urb.buffer_length));
        finish(held, 0, urb.buffer_length);
    } else if (urb.endpoint == 0x81 && buffer) {
        waiting_.push_back(held);
    } else {
        finish(held, -EPIPE, 0);
    }
    serve_waiting();
}

gboolean MockFalconBus::answer(UMockdevIoctlClient* client) {
    ++requests;
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
            *reinterpret_cast<std::uint32_t*>(resolved(4)->data) = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM;
            return complete(0, 0);
        case USBDEVFS_DISCONNECT_CLAIM:
        case USBDEVFS_CLAIMINTERFACE:
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
                submit(data);
                return complete(0, 0);
            }
            return complete(-1, EFAULT);  // the caller died while it was asking
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
            if (done_.empty()) return complete(-1, unplugged ? ENODEV : EAGAIN);
            const Urb urb = done_.front();
            done_.pop_front();
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
