// What is plugged in, in sentences: printed by `handrail devices`, and told in a session that asks for it, where
// looking must not keep anybody waiting.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "haptic/drivers/found_device.h"
#include "worlds/base/background_task.h"

namespace handrail {

// Of one device, its first sentence first.
std::vector<std::string> device_sentences(const FoundDevice& device);
// Of all, or that there is none; and at last the simulated ones, which are always there.
std::vector<std::string> device_sentences(std::span<const FoundDevice> devices);

// App thread; looks in the background, for up to half a second.
class DeviceFacts {
public:
    // Once a frame.
    void answer(Session& app, double now_s);

private:
    BackgroundTask<std::vector<std::string>> looking_{on_threads(), "devices"};
};

}  // namespace handrail
