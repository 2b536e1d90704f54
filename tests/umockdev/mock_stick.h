// Makes an event node with force feedback in umockdev. It is a rumble pad, or a joystick with a constant force and a
// simulated hand on it. The testbed answers on its own thread. `lock` guards what the device has received and what it
// reports.
#pragma once

#include <linux/input.h>
#include <umockdev.h>

#include <deque>
#include <mutex>

#include "tests/support/names.h"

namespace handrail::test {

class MockStick {
public:
    // If `constant` is true, the device is a joystick with a constant force. Otherwise it is a pad that only rumbles.
    MockStick(UMockdevTestbed* bed, bool constant);
    ~MockStick();
    MockStick(const MockStick&) = delete;
    MockStick& operator=(const MockStick&) = delete;

    void send(std::uint16_t type, std::uint16_t code, int value);

    std::mutex lock;
    std::deque<input_event> events;
    ff_effect effect{};
    bool loaded = false, playing = false, unplugged = false;
    int uploads = 0, gain = -1, bad_uploads = 0;

private:
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);

    bool constant_;
    UMockdevIoctlBase* handler_ = nullptr;
};

}  // namespace handrail::test
