// logind on a system bus of the test's own, played by python3-dbusmock.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/child_process.h"

namespace handrail::test {

class LoginManager {
public:
    // Why it cannot be played here; empty where it can.
    static std::string why_not();

    // `folder` is for its socket and its output.
    explicit LoginManager(std::filesystem::path folder);
    // Waits until it answers.
    bool ready() const;
    // For DBUS_SYSTEM_BUS_ADDRESS.
    std::string address() const;
    // Announces that the computer is about to sleep, or that it is awake again.
    void announce_sleep(bool begins) const;
    // Who delays what: "sleep Handrail delay" and a new line for each.
    std::string inhibitors() const;

private:
    std::string ask(const std::string& python) const;

    std::filesystem::path folder_;
    std::unique_ptr<ChildProcess> bus_, logind_;
};

}  // namespace handrail::test
