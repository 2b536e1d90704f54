#include "tests/umockdev/mock_stick.h"

#include <errno.h>
#include <sys/ioctl.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include "tests/support/names.h"
#include "tests/umockdev/completed.h"

namespace handrail::test {
MockStick::MockStick(UMockdevTestbed* bed, bool constant) : constant_(constant) {
    const std::string device =
        "P: /devices/virtual/input/input5/event5\nN: input/event5\nE: DEVNAME=/dev/input/event5\nE: "
        "SUBSYSTEM=input\nE: MAJOR=13\nE: MINOR=69\n";
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(bed, device.c_str(), &error)) throw std::runtime_error(error->message);
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    g_signal_connect(handler_, "handle-read", G_CALLBACK(on_read), this);
    g_signal_connect(handler_, "handle-write", G_CALLBACK(on_write), this);
    if (!umockdev_testbed_attach_ioctl(bed, "/dev/input/event5", handler_, &error))
        throw std::runtime_error(error->message);
}

MockStick::~MockStick() {
    g_signal_handlers_disconnect_by_data(handler_, this);
    g_object_unref(handler_);
}

void MockStick::send(std::uint16_t type, std::uint16_t code, int value) {
    const std::lock_guard guard(lock);
    input_event event{};
    event.type = type;
    event.code = code;
    event.value = value;
    events.push_back(event);
}

gboolean MockStick::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& stick = *static_cast<MockStick*>(self);
    const std::lock_guard guard(stick.lock);
    const auto request = static_cast<unsigned long>(umockdev_ioctl_client_get_request(client));
    if (_IOC_TYPE(request) != 'E') return FALSE;
    if (stick.unplugged) return complete(client, -1, ENODEV);
    const unsigned number = _IOC_NR(request);
    const std::size_t size = _IOC_SIZE(request);
    UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
    if (number == _IOC_NR(EVIOCRMFF)) {
        stick.loaded = stick.playing = false;
        return complete(client, 0, 0);
    }
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(argument, 0, size, nullptr);
    if (!data) return complete(client, -1, EFAULT);
    if (number == 0x20 + EV_FF) {
        std::memset(data->data, 0, size);
        const auto set = [&](unsigned bit) {
            data->data[bit / 8] = static_cast<guint8>(data->data[bit / 8] | 1U << (bit % 8));
        };
        set(FF_RUMBLE);
        if (stick.constant_) set(FF_CONSTANT);
        set(FF_GAIN);
        return complete(client, static_cast<long>(size), 0);
    }
    if (number == 0x40 + ABS_X || number == 0x40 + ABS_Y) {
        if (!stick.constant_) return complete(client, -1, EINVAL);
        input_absinfo axis{};
        axis.minimum = -512;
        axis.maximum = 512;
        std::memcpy(data->data, &axis, sizeof axis);
        return complete(client, 0, 0);
    }
    if (number == 0x06) {
        std::memcpy(data->data, "Test Stick", 11);
        return complete(client, 11, 0);
    }
    if (number == _IOC_NR(EVIOCSFF)) {
        ff_effect wanted{};
        std::memcpy(&wanted, data->data, sizeof wanted);
        if (wanted.id < -1 || wanted.id > 0 || (wanted.id == 0 && !stick.loaded)) {
            ++stick.bad_uploads;
            return complete(client, -1, EINVAL);
        }
        wanted.id = 0;
        stick.effect = wanted;
        stick.loaded = true;
        ++stick.uploads;
        std::memcpy(data->data, &wanted, sizeof wanted);
        return complete(client, 0, 0);
    }
    return complete(client, -1, EINVAL);
}

gboolean MockStick::on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& stick = *static_cast<MockStick*>(self);
    UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    const std::lock_guard guard(stick.lock);
    if (stick.unplugged) return complete(client, -1, ENODEV);
    if (stick.events.empty()) return complete(client, -1, EAGAIN);
    std::size_t size = 0;
    for (; !stick.events.empty() && size + sizeof(input_event) <= static_cast<std::size_t>(data->data_len);
         size += sizeof(input_event)) {
        std::memcpy(data->data + size, &stick.events.front(), sizeof(input_event));
        stick.events.pop_front();
    }
    return complete(client, static_cast<long>(size), 0);
}

gboolean MockStick::on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& stick = *static_cast<MockStick*>(self);
    UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    const std::lock_guard guard(stick.lock);
    if (stick.unplugged) return complete(client, -1, ENODEV);
    input_event event{};
    std::memcpy(&event, data->data, sizeof event);
    if (event.type == EV_FF && event.code == FF_GAIN) stick.gain = event.value;
    else if (event.type == EV_FF && event.code == 0) stick.playing = event.value > 0;
    return complete(client, static_cast<long>(data->data_len), 0);
}

}  // namespace handrail::test
