// What both guards are as processes: their command line, the mailbox they map, and what protects them from the rest of
// the machine.
//   handrail-guard hold    MAILBOX_FD LIFE_FD WAKE_FD  LANGUAGE FOLDER NAME [SERIAL]
//   handrail-guard relieve MAILBOX_FD LIFE_FD GUARD_FD LANGUAGE FOLDER NAME [SERIAL]
// What they tell the program, they tell in LANGUAGE, of whose texts some may stand in FOLDER (see
// worlds/base/language.h).
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"
#include "worlds/confine/confine.h"

namespace handrail {

struct NamedDevices {
    // Finds and opens a device; what goes on is told in sentences.
    std::function<Result<std::unique_ptr<HapticDevice>>(const std::string& name, const std::string& serial,
                                                        const std::function<void(const std::string&)>& tell)>
        open;
    // Opens it, sends zero, closes it; success only when the device took the zero.
    std::function<Result<void>(const std::string& name, const std::string& serial)> zero;
    // What opening it needs, also when it is plugged in again.
    std::function<Permissions(const std::string& name)> permissions;
};

// Those that the drivers find, each with the permissions that its driver needs.
NamedDevices devices_of_this_machine(Clock& clock);

inline constexpr const char* kHoldRole = "hold";
inline constexpr const char* kRelieveRole = "relieve";

// The whole process. Returns its exit status; 2 where it was not started by the program.
// Before it touches a device it leaves the program's group and ignores the signals that end programs, may gain no
// privileges, gives up core dumps and bounds its own descriptors, file sizes and memory, locks its memory, asks to be
// spared when memory runs out, and asks for real time. What it may not have of the last three is noted in the mailbox,
// for the program to tell. Then it confines itself to what the device needs (worlds/confine).
int guard_process(int argc, char** argv, const NamedDevices& devices);

}  // namespace handrail
