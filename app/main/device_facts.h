// Describes the connected devices in sentences. `handrail devices` prints them, and a session announces them on
// request. A session must not wait while devices are searched.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "haptic/drivers/found_device.h"
#include "worlds/base/background_task.h"

namespace handrail::program {

// The sentences about one device; the main one comes first.
std::vector<std::string> device_sentences(const drivers::FoundDevice& device);
// The sentences about all devices, or that there is none. The simulated devices come last, as they are always there.
std::vector<std::string> device_sentences(std::span<const drivers::FoundDevice> devices);

// Used by the app thread. Searches on a background thread, for up to half a second.
class DeviceFacts {
public:
    // Once a frame.
    void answer(core::Session& app, double now_s);

private:
    BackgroundTask<std::vector<std::string>> looking_{on_threads(), "devices"};
};

}  // namespace handrail::program
