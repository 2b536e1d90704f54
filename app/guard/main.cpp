// handrail-guard: the small process that holds a real device and takes its force away when the program dies. Started by the program alone:
//   handrail-guard MAILBOX_FD WAKE_FD LIFE_FD NAME [SERIAL]
#include <cstdio>
#include <cstdlib>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/hand_guard.h"

int main(int argc, char** argv) {
    if (argc < 5) {
        std::fputs("handrail-guard is started by handrail and does nothing by itself.\n", stderr);
        return 2;
    }
    const std::string name = argv[4], serial = argc > 5 ? argv[5] : "";
    handrail::SteadyClock clock;
    return handrail::run_guard_process(std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                                       [&](const std::function<void(const std::string&)>& tell) { return handrail::open_device(name, serial, clock, tell); });
}
