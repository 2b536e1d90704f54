// handrail-guard: the small processes that hold a real device and take its force away when the program dies, or one
// another. Started by the program alone; see haptic/drivers/guard_process.h.
#include "haptic/drivers/found_device.h"
#include "haptic/drivers/guard_process.h"
#include "worlds/base/clock.h"

int main(int argc, char** argv) {
    handrail::SteadyClock clock;
    const handrail::NamedDevices devices{
        [&](const std::string& name, const std::string& serial, const std::function<void(const std::string&)>& tell) {
            return handrail::open_device(name, serial, clock, tell);
        },
        [&](const std::string& name, const std::string& serial) { return handrail::zero_device(name, serial, clock); },
    };
    return handrail::guard_process(argc, argv, devices);
}
