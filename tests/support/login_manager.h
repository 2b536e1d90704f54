// Starts a simulated logind (python3-dbusmock) on a separate system bus for the test.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/child_process.h"

namespace handrail::test {

class LoginManager {
public:
    // Returns why the simulated logind cannot run on this machine, or an empty text if it can.
    static std::string why_not();

    // `folder` receives the socket and the output of the bus.
    explicit LoginManager(std::filesystem::path folder);
    // Waits until the simulated logind answers.
    bool ready() const;
    // Returns the value for DBUS_SYSTEM_BUS_ADDRESS.
    std::string address() const;
    // Announces that the computer is about to sleep, or that it is awake again.
    void announce_sleep(bool begins) const;
    // Returns the present inhibitors, with a line like "sleep Handrail delay" for each.
    std::string inhibitors() const;

private:
    std::string query(const std::string& python) const;

    std::filesystem::path folder_;
    std::unique_ptr<ChildProcess> bus_, logind_;
};

}  // namespace handrail::test
