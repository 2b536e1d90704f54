// Starts a separate X server for the test (Xvfb) with software OpenGL. Tests press keys through xdotool.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

class VirtualDisplay {
public:
    // Starts the server on a display number of this process and sets DISPLAY to it. Returns null if Xvfb or xdotool is
    // not installed; the test then skips.
    static std::unique_ptr<VirtualDisplay> start();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    // Runs "xdotool WORDS". Returns false if it fails or takes longer than 5 min.
    bool xdotool(const std::string& words) const { return run("xdotool " + words); }
    // Runs a shell command. Returns false if it fails or takes longer than 5 min.
    bool run(const std::string& line) const;
    // Ends the server, as logging out does.
    void kill();

private:
    VirtualDisplay(pid_t server, std::string number) : number_(std::move(number)), server_(server) {}
    std::string number_;
    pid_t server_ = 0;
};

}  // namespace handrail::test
