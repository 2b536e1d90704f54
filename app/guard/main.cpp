// Runs handrail-guard. Several of these small processes together hold a real device. They remove its force when the
// main program, or another of these processes, dies. Only the main program starts handrail-guard; see
// haptic/drivers/guard_process.h.
#include "haptic/drivers/guard_process.h"
#include "worlds/base/clock.h"

int main(int argc, char** argv) {
    handrail::SteadyClock clock;
    return handrail::drivers::guard_process(argc, argv, handrail::drivers::devices_of_this_machine(clock));
}
