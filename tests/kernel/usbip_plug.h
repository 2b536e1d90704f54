// Plugs an emulated USB device into the running kernel. The kernel module vhci-hcd is a host controller whose cable is
// a socket; this class answers every transfer on the socket. The class needs root rights and the module. It has its own
// thread; `lock` guards the emulator. Source: the USB/IP protocol, Documentation/usb/usbip_protocol.rst of Linux.
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <mutex>
#include <thread>

#include "tests/emulators/usb_function.h"
#include "tests/support/names.h"

namespace handrail::test {

class UsbIpPlug {
public:
    enum class Speed : std::uint8_t { Full = 2, High = 3 };

    // Plugs `function` into port `port` of the controller, from 0 to 7. Each port accepts one device at a time. Throws
    // if the kernel refuses the device.
    UsbIpPlug(UsbFunction& function, int port, Speed speed);
    ~UsbIpPlug();
    UsbIpPlug(const UsbIpPlug&) = delete;
    UsbIpPlug& operator=(const UsbIpPlug&) = delete;

    // Pulls the device out. The kernel notices it immediately.
    void unplug();

    std::mutex lock;
    std::atomic<std::uint64_t> transfers{0};

private:
    struct Waiting {
        std::uint32_t number, room;
        std::chrono::steady_clock::time_point since;
    };
    void run();
    bool take_one();
    void submitted(std::span<const std::uint32_t, 12> header);
    void unlinked(std::span<const std::uint32_t, 12> header);
    void serve_waiting();
    void answer(std::uint32_t number, int status, std::size_t length, std::span<const std::uint8_t> data);

    UsbFunction& function_;
    int port_, socket_ = -1;
    std::deque<Waiting> waiting_;
    std::thread thread_;
};

}  // namespace handrail::test
