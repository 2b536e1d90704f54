// Provides functions that wait until asynchronous work of the kernel is done. Only the test thread uses them.
#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "haptic/drivers/hid_link.h"
#include "tests/support/names.h"

namespace handrail::test {

template <class Condition>
bool wait_until(Condition&& condition, std::chrono::seconds allowed = std::chrono::seconds(30)) {
    for (const auto end = std::chrono::steady_clock::now() + allowed; std::chrono::steady_clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds(20)))
        if (condition()) return true;
    return false;
}

// Waits for the first HID device of the maker `vendor` and opens it.
inline std::unique_ptr<HidLink> open_hid(std::uint16_t vendor) {
    std::unique_ptr<HidLink> link;
    wait_until([&] {
        for (const HidDeviceInfo& info : list_hid_devices())
            if (info.vendor == vendor)
                if (auto opened = open_hid_link(info)) link = std::move(*opened);
        return link != nullptr;
    });
    return link;
}

}  // namespace handrail::test
