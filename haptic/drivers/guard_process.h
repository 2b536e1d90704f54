// The common part of both guards as processes: their command line, the mailbox that they map, and their protection from
// the rest of the machine.
//   handrail-guard hold    MAILBOX_FD LIFE_FD WAKE_FD  LANGUAGE FOLDER NAME [SERIAL]
//   handrail-guard relieve MAILBOX_FD LIFE_FD GUARD_FD LANGUAGE FOLDER NAME [SERIAL]
// Their sentences to the program are in LANGUAGE; FOLDER may contain some of its texts (see worlds/base/language.h).
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "haptic/device/haptic_device.h"
#include "worlds/base/clock.h"
#include "worlds/confine/confine.h"

namespace handrail::drivers {

struct NamedDevices {
    // Finds and opens a device, and reports progress in sentences.
    std::function<Result<std::unique_ptr<device::HapticDevice>>(const std::string& name, const std::string& serial,
                                                                const std::function<void(const std::string&)>& tell)>
        open;
    // Opens the device, sends zero and closes it; succeeds only if the device accepted the zero.
    std::function<Result<void>(const std::string& name, const std::string& serial)> zero;
    // The permissions for opening it, also when it is plugged in again.
    std::function<confine::Permissions(const std::string& name)> permissions;
};

// The devices that the drivers find, each with the permissions that its driver needs.
NamedDevices devices_of_this_machine(Clock& clock);

inline constexpr const char* kHoldRole = "hold";
inline constexpr const char* kRelieveRole = "relieve";

// Runs the whole process. Returns its exit status; 2 if the program did not start it.
// Before it touches a device it
// - leaves the program's group and ignores the signals that end programs,
// - gives up gaining privileges and core dumps, and limits its own descriptors, file sizes and memory,
// - locks its memory, asks to be spared when memory runs out, and requests real-time scheduling.
// If locking memory or being spared is refused, the mailbox notes it, for the program to report. Then it confines
// itself to what the device needs (worlds/confine).
int guard_process(int argc, char** argv, const NamedDevices& devices);

}  // namespace handrail::drivers
