// A USB bus in umockdev with one Falcon on it: usbfs answered by the emulator, as the kernel would. The bed answers on a thread of its own;
// `lock` guards the emulator.
#pragma once

#include <umockdev.h>

#include <chrono>
#include <deque>
#include <mutex>

#include "tests/emulators/falcon_emulator.h"

namespace handrail::test {

class MockFalconBus {
public:
    static constexpr int kBus = 1, kAddress = 7;

    explicit MockFalconBus(UMockdevTestbed* bed);
    ~MockFalconBus();
    MockFalconBus(const MockFalconBus&) = delete;
    MockFalconBus& operator=(const MockFalconBus&) = delete;

    std::mutex lock;
    FalconEmulator falcon;
    bool unplugged = false;  // every request fails with ENODEV from now on
    std::uint64_t requests = 0;

private:
    struct Urb {
        UMockdevIoctlData* urb;
        UMockdevIoctlData* buffer;
        std::chrono::steady_clock::time_point since;
    };
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    gboolean answer(UMockdevIoctlClient* client);
    void submit(UMockdevIoctlData* data);
    void serve_waiting();
    void finish(const Urb& urb, int status, int length);

    UMockdevIoctlBase* handler_ = nullptr;
    std::deque<Urb> waiting_, done_;
};

}  // namespace handrail::test
