// handrail-guard: the small process that holds a real device and takes its force away when the program dies. Started by the program alone:
//   handrail-guard MAILBOX_FD WAKE_FD LIFE_FD LANGUAGE FOLDER NAME [SERIAL]
// What it tells the program, it tells in LANGUAGE, of whose texts some may stand in FOLDER (see worlds/base/language.h).
#include <cstdio>
#include <cstdlib>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/hand_guard.h"
#include "worlds/base/language.h"

int main(int argc, char** argv) {
    if (argc < 7) {
        std::fprintf(stderr, "%s\n", handrail::phrase("guard.started_by_handrail").c_str());
        return 2;
    }
    // The program has told what is wrong with that file; where it cannot be read any more, English is spoken.
    (void)handrail::speak_language(argv[4], argv[5]);
    const std::string name = argv[6], serial = argc > 7 ? argv[7] : "";
    handrail::SteadyClock clock;
    return handrail::run_guard_process(std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                                       [&](const std::function<void(const std::string&)>& tell) { return handrail::open_device(name, serial, clock, tell); });
}
