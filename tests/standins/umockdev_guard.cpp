// Runs handrail-guard as it ships, but with access to the devices that umockdev emulates. Those devices are in a
// separate folder and behind a Unix socket, neither of which the shipped guard can reach.
#include <cstdlib>

#include "haptic/drivers/guard_process.h"
#include "tests/support/names.h"
#include "worlds/base/clock.h"

int main(int argc, char** argv) {
    handrail::SteadyClock clock;
    handrail::NamedDevices devices = handrail::devices_of_this_machine(clock);
    devices.permissions = [shipped = devices.permissions](const std::string& name) {
        handrail::Permissions permissions = shipped(name);
        permissions.unix_sockets = true;
        if (const char* played = std::getenv("UMOCKDEV_DIR")) permissions.read_and_write.emplace_back(played);
        return permissions;
    };
    return handrail::guard_process(argc, argv, devices);
}
