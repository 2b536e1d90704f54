// handrail-guard: the small processes that hold a real device and take its force away when the program dies, or one
// another. Started by the program alone; see haptic/drivers/guard_process.h.
#include "haptic/drivers/guard_process.h"
#include "worlds/base/clock.h"

int main(int argc, char** argv) {
    handrail::SteadyClock clock;
    return handrail::guard_process(argc, argv, handrail::devices_of_this_machine(clock));
}
