// Tests a Bluetooth DualSense on the kernel's own HID core. /dev/uhid replaces the radio.
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "tests/emulators/hid_claims.h"
#include "tests/kernel/wait.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace bluetooth_test {

// A HID device whose reports this program sends and receives. A separate thread answers the kernel; `lock` guards the
// emulator.
class UserHid {
public:
    UserHid(test::HidEmulator& device, std::uint16_t product, const char* name)
        : device_(device), fd_(::open("/dev/uhid", O_RDWR | O_CLOEXEC)) {
        uhid_event create{};
        create.type = UHID_CREATE2;
        std::strncpy(reinterpret_cast<char*>(create.u.create2.name), name, sizeof create.u.create2.name - 1);
        const std::vector<std::uint8_t> descriptor = device.descriptor();
        create.u.create2.rd_size = static_cast<std::uint16_t>(descriptor.size());
        create.u.create2.bus = BUS_BLUETOOTH;
        create.u.create2.vendor = 0x054c;
        create.u.create2.product = product;
        std::copy(descriptor.begin(), descriptor.end(), create.u.create2.rd_data);
        if (fd_ < 0 || !send(create)) throw std::runtime_error("the kernel does not take a HID device from here");
        thread_ = std::thread([this] { run(); });
    }
    ~UserHid() {
        ended_ = true;
        thread_.join();
        ::close(fd_);
    }
    UserHid(const UserHid&) = delete;
    UserHid& operator=(const UserHid&) = delete;

    // Sends all reports that the emulator has queued to the kernel. The test must call this after the emulator has
    // queued reports.
    void ring() {
        const std::lock_guard guard(lock);
        for (; !device_.to_host.empty(); device_.to_host.pop_front()) {
            const std::vector<std::uint8_t>& report = device_.to_host.front();
            uhid_event input{};
            input.type = UHID_INPUT2;
            input.u.input2.size = static_cast<std::uint16_t>(report.size());
            std::copy(report.begin(), report.end(), input.u.input2.data);
            send(input);
        }
    }

    std::mutex lock;

private:
    bool send(const uhid_event& event) {
        return ::write(fd_, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
    }

    void run() {
        while (!ended_) {
            pollfd ready{fd_, POLLIN, 0};
            uhid_event event{};
            if (::poll(&ready, 1, 20) <= 0 || ::read(fd_, &event, sizeof event) <= 0) continue;
            const std::lock_guard guard(lock);
            if (event.type == UHID_OUTPUT) {
                device_.take({event.u.output.data, event.u.output.size});
            } else if (event.type == UHID_GET_REPORT) {
                const std::vector<std::uint8_t> report = device_.feature(event.u.get_report.rnum);
                uhid_event answer{};
                answer.type = UHID_GET_REPORT_REPLY;
                answer.u.get_report_reply.id = event.u.get_report.id;
                answer.u.get_report_reply.err = report.empty() ? EIO : 0;
                answer.u.get_report_reply.size = static_cast<std::uint16_t>(report.size());
                std::copy(report.begin(), report.end(), answer.u.get_report_reply.data);
                send(answer);
            }
        }
    }

    test::HidEmulator& device_;
    int fd_;
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

TEST(KernelBluetooth, loses_none_of_a_thousand_dual_sense_reports_with_checksums) {
    test::PadEmulator pad(true, true);
    UserHid radio(pad, 0x0ce6, "Wireless Controller");
    test::exchange_a_thousand_reports(test::open_hid(0x054c), PadBus::Bluetooth, pad, radio.lock,
                                      [&] { radio.ring(); });
}

}  // namespace bluetooth_test
}  // namespace handrail
