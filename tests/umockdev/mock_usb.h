// Makes a USB device in umockdev. It answers usbfs requests as the kernel would, for any device of
// tests/emulators/usb_function.h. The testbed answers on its own thread, and `lock` guards the emulator.
#pragma once

#include <umockdev.h>

#include <chrono>
#include <deque>
#include <mutex>

#include "tests/emulators/usb_function.h"
#include "tests/support/names.h"

namespace handrail::test {

class MockUsbDevice {
public:
    static constexpr int kBus = 1;

    MockUsbDevice(UMockdevTestbed* bed, UsbFunction& function, int address);
    ~MockUsbDevice();
    MockUsbDevice(const MockUsbDevice&) = delete;
    MockUsbDevice& operator=(const MockUsbDevice&) = delete;

    std::mutex lock;
    bool unplugged = false;  // if true, every request fails with ENODEV

private:
    struct Urb {
        UMockdevIoctlData* urb;
        UMockdevIoctlData* buffer;
        const void* client;  // the client that made the request
        std::chrono::steady_clock::time_point since;
    };
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    gboolean answer(UMockdevIoctlClient* client);
    void submit(UMockdevIoctlData* data, const void* client);
    void control(const Urb& urb);
    void serve_waiting();
    void forget_requests_of_others(const void* client);
    void finish(const Urb& urb, int status, std::size_t length);

    UsbFunction& function_;
    UMockdevIoctlBase* handler_ = nullptr;
    std::deque<Urb> waiting_, done_;
};

// A bus with one Falcon connected to it.
class MockFalconBus : public FalconAndItsChip, public MockUsbDevice {
public:
    static constexpr int kAddress = 7;
    explicit MockFalconBus(UMockdevTestbed* bed) : MockUsbDevice(bed, chip, kAddress) {}
};

}  // namespace handrail::test
