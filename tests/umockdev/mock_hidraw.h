// Makes a hidraw node in umockdev. The node leads to a HID emulator and preserves the boundaries of reports. The node
// itself is a terminal, which only signals that reports are waiting; this class answers the reads and writes. The
// testbed answers on its own thread, and `lock` guards the emulator.
#pragma once

#include <umockdev.h>

#include <mutex>
#include <string>

#include "tests/emulators/hid_emulators.h"

namespace handrail::test {

class MockHidraw {
public:
    struct Identity {
        int number;  // the N of /dev/hidrawN
        bool bluetooth;
        std::uint16_t vendor, product;
        std::string name;
    };
    MockHidraw(UMockdevTestbed* bed, HidEmulator& device, const Identity& identity);
    ~MockHidraw();
    MockHidraw(const MockHidraw&) = delete;
    MockHidraw& operator=(const MockHidraw&) = delete;

    // The test must call ring() after the emulator has queued reports.
    void ring();

    std::mutex lock;
    std::uint64_t reads = 0, writes = 0;

private:
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    void ring_locked();

    HidEmulator& device_;
    Identity identity_;
    std::vector<std::uint8_t> descriptor_;
    int doorbell_ = -1;
    bool rung_ = false;
    UMockdevIoctlBase* handler_ = nullptr;
};

}  // namespace handrail::test
