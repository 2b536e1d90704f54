// handrail-guard: the small processes that hold a real device and remove its force when the program, or another of
// them, dies. Started only by the program; see haptic/drivers/guard_process.h.
#include "haptic/drivers/guard_process.h"
#include "worlds/base/clock.h"

int main(int argc, char** argv) {
    handrail::SteadyClock clock;
    return handrail::drivers::guard_process(argc, argv, handrail::drivers::devices_of_this_machine(clock));
}
