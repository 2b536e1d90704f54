#include "tests/umockdev/mock_hidraw.h"

#include <errno.h>
#include <fmt/format.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "tests/support/names.h"
#include "tests/umockdev/completed.h"

namespace handrail::test {
namespace {

void add(UMockdevTestbed* bed, const std::string& description) {
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(bed, description.c_str(), &error)) throw std::runtime_error(error->message);
}

}  // namespace

MockHidraw::MockHidraw(UMockdevTestbed* bed, HidEmulator& device, const Identity& identity)
    : device_(device), identity_(identity), descriptor_(device.descriptor()) {
    const std::string id =
        fmt::format("{:04X}:{:08X}:{:08X}", identity.bluetooth ? 5 : 3, identity.vendor, identity.product);
    std::string above;
    if (identity.bluetooth) {
        above = fmt::format("/devices/bluetooth/hci0/hci0:{}", identity.number + 1);
        add(bed, fmt::format("P: {}\nE: SUBSYSTEM=bluetooth\nE: DEVTYPE=link\n\n", above));
    } else {
        const std::string usb = fmt::format("/devices/usb1/1-{}", identity.number + 2);
        add(bed, fmt::format("P: {}\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nE: DEVNAME=/dev/bus/usb/001/{:03}\nN: "
                             "bus/usb/001/{:03}\nA: idVendor={:04x}\\n\n"
                             "A: idProduct={:04x}\\n\nA: busnum=1\\n\nA: devnum={}\\n\nA: bcdDevice=0100\\n\nA: "
                             "manufacturer=Test\\n\nA: product={}\\n\n"
                             "A: serial=SN{}\\n\n\n",
                             usb, identity.number + 20, identity.number + 20, identity.vendor, identity.product,
                             identity.number + 20, identity.name, identity.number));
        above = fmt::format("{}/1-{}:1.3", usb, identity.number + 2);
        add(bed,
            fmt::format("P: {}\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=03\\n\n\n", above));
    }
    std::string bytes;
    for (const std::uint8_t byte : descriptor_) bytes += fmt::format("{:02X}", byte);
    add(bed, fmt::format("P: {}/{}\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID={}\nE: HID_NAME={}\nE: "
                         "HID_UNIQ=aa:bb:cc:00:00:{:02}\nE: HID_PHYS=x\n"
                         "H: report_descriptor={}\n\n",
                         above, id, id, identity.name, identity.number, bytes));
    add(bed, fmt::format("P: {0}/{1}/hidraw/hidraw{2}\nL: device=../..\nN: hidraw{2}\nE: DEVNAME=/dev/hidraw{2}\nE: "
                         "SUBSYSTEM=hidraw\nE: MAJOR=240\nE: MINOR={2}\n\n",
                         above, id, identity.number));
    const std::string node = fmt::format("/dev/hidraw{}", identity.number);
    doorbell_ = umockdev_testbed_get_dev_fd(bed, node.c_str());
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    g_signal_connect(handler_, "handle-read", G_CALLBACK(on_read), this);
    g_signal_connect(handler_, "handle-write", G_CALLBACK(on_write), this);
    GError* error = nullptr;
    if (!umockdev_testbed_attach_ioctl(bed, node.c_str(), handler_, &error)) throw std::runtime_error(error->message);
}

MockHidraw::~MockHidraw() {
    g_signal_handlers_disconnect_by_data(handler_, this);
    g_object_unref(handler_);
}

void MockHidraw::ring() {
    const std::lock_guard guard(lock);
    ring_locked();
}

// Makes sure that the terminal contains one byte while reports are waiting, and none otherwise.
void MockHidraw::ring_locked() {
    if (device_.to_host.empty() == !rung_) return;
    rung_ = !rung_;
    if (rung_) {
        const char bell = 1;
        [[maybe_unused]] const auto written = ::write(doorbell_, &bell, 1);
    } else {
        ::tcflush(doorbell_, TCOFLUSH);
    }
}

gboolean MockHidraw::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& node = *static_cast<MockHidraw*>(self);
    const auto request = static_cast<unsigned long>(umockdev_ioctl_client_get_request(client));
    if (_IOC_TYPE(request) != 'H') return FALSE;
    const std::lock_guard guard(node.lock);
    const std::size_t size = _IOC_SIZE(request);
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
    const auto answer = [&](const void* bytes, std::size_t length) {
        std::memcpy(data->data, bytes, std::min(length, size));
        return complete(client, static_cast<long>(std::min(length, size)), 0);
    };
    switch (_IOC_NR(request)) {
        case _IOC_NR(HIDIOCGRDESCSIZE): {
            const int length = static_cast<int>(node.descriptor_.size());
            std::memcpy(data->data, &length, sizeof length);
            return complete(client, 0, 0);
        }
        case _IOC_NR(HIDIOCGRDESC): {
            hidraw_report_descriptor descriptor{};
            descriptor.size = static_cast<std::uint32_t>(node.descriptor_.size());
            std::copy(node.descriptor_.begin(), node.descriptor_.end(), descriptor.value);
            std::memcpy(data->data, &descriptor, sizeof descriptor);
            return complete(client, 0, 0);
        }
        case _IOC_NR(HIDIOCGRAWINFO): {
            const hidraw_devinfo info{node.identity_.bluetooth ? 5U : 3U,
                                      static_cast<std::int16_t>(node.identity_.vendor),
                                      static_cast<std::int16_t>(node.identity_.product)};
            return answer(&info, sizeof info);
        }
        case 4:  // HIDIOCGRAWNAME with any length
            return answer(node.identity_.name.c_str(), node.identity_.name.size() + 1);
        case 7: {  // HIDIOCGFEATURE with any length
            const std::vector<std::uint8_t> report = node.device_.feature(data->data[0]);
            return report.empty() ? complete(client, -1, EPIPE) : answer(report.data(), report.size());
        }
        default:
            return complete(client, -1, EINVAL);
    }
}

gboolean MockHidraw::on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& node = *static_cast<MockHidraw*>(self);
    UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    const std::lock_guard guard(node.lock);
    ++node.reads;
    if (node.device_.unplugged) return complete(client, -1, EIO);
    if (node.device_.to_host.empty()) return complete(client, -1, EAGAIN);
    const std::vector<std::uint8_t> report = std::move(node.device_.to_host.front());
    node.device_.to_host.pop_front();
    const std::size_t size = std::min<std::size_t>(report.size(), data->data_len);
    std::copy_n(report.begin(), size, data->data);
    node.ring_locked();
    return complete(client, static_cast<long>(size), 0);
}

gboolean MockHidraw::on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& node = *static_cast<MockHidraw*>(self);
    UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    const std::lock_guard guard(node.lock);
    ++node.writes;
    const bool taken =
        !node.device_.unplugged && node.device_.take({data->data, static_cast<std::size_t>(data->data_len)});
    node.ring_locked();
    return taken ? complete(client, static_cast<long>(data->data_len), 0) : complete(client, -1, EIO);
}

}  // namespace handrail::test
