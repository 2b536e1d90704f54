// Implements the common part of the two guard processes: their command line, the mailbox that they map, and their
// protection from the rest of the machine.
//   handrail-guard hold    MAILBOX_FD LIFE_FD WAKE_FD  LANGUAGE FOLDER NAME [SERIAL]
//   handrail-guard relieve MAILBOX_FD LIFE_FD GUARD_FD LANGUAGE FOLDER NAME [SERIAL]
// The guards write their sentences in LANGUAGE. FOLDER may contain texts of that language (see worlds/base/language.h).
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
                                                                const std::function<void(const std::string&)>& report)>
        open;
    // Opens the device, sends zero force and closes it. Succeeds only if the device accepted the zero.
    std::function<Result<void>(const std::string& name, const std::string& serial)> zero;
    // Returns the permissions for opening the device, also after it was unplugged and plugged in again.
    std::function<confine::Permissions(const std::string& name)> permissions;
};

// Returns the functions for the devices that the drivers find. Each device gets the permissions that its driver needs.
NamedDevices devices_of_this_machine(Clock& clock);

inline constexpr const char* kHoldRole = "hold";
inline constexpr const char* kRelieveRole = "relieve";

// Runs the whole process. Returns its exit status; 2 if the command line does not come from the program.
// Before it uses a device, the process
// - leaves the program's process group and ignores the signals that end programs,
// - gives up core dumps and the right to gain privileges, and limits its own descriptors, file sizes and memory,
// - locks its memory, asks the kernel to spare it when memory runs out, and requests real-time scheduling.
// If the system refuses to lock the memory or to spare the process, the process records that in the mailbox, so that
// the program can report it. Then the process confines itself to what the device needs (worlds/confine).
int guard_process(int argc, char** argv, const NamedDevices& devices);

}  // namespace handrail::drivers
