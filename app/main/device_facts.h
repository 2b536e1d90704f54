// Describes the connected devices in sentences. `handrail devices` prints these sentences. A session announces them on
// request, and uses DeviceFacts for that, because a session must not wait for the search for devices.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "haptic/drivers/found_device.h"
#include "worlds/base/background_task.h"

namespace handrail::program {

// Returns the sentences about one device; the most important one comes first.
std::vector<std::string> device_sentences(const drivers::FoundDevice& device);
// Returns the sentences about all devices, or a sentence that there is none. The simulated devices come last, because
// they are always present.
std::vector<std::string> device_sentences(std::span<const drivers::FoundDevice> devices);

// Answers a session's requests for facts about devices. The app thread owns and uses the object. It searches on a
// background thread, for up to half a second.
class DeviceFacts {
public:
    // Call once a frame. Starts a search if the session has requested one, and passes the result to the session.
    void answer(core::Session& app, double now_s);

private:
    BackgroundTask<std::vector<std::string>> looking_{on_threads(), "devices"};
};

}  // namespace handrail::program
