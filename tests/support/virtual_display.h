// An X server of the test's own (Xvfb) with software OpenGL, and hands that press its keys (xdotool).
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

namespace handrail::test {

class VirtualDisplay {
public:
    // Starts the server on a display number of its own and points DISPLAY at it. Null where Xvfb or xdotool is not
    // installed; the test then skips.
    static std::unique_ptr<VirtualDisplay> start();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    // Runs "xdotool WORDS"; false if it fails or takes longer than 5 min.
    bool xdotool(const std::string& words) const { return run("xdotool " + words); }
    // The same for a line of the shell.
    bool run(const std::string& line) const;
    // Ends the server as a log-out does.
    void kill();

private:
    VirtualDisplay(pid_t server, std::string number) : number_(std::move(number)), server_(server) {}
    std::string number_;
    pid_t server_ = 0;
};

}  // namespace handrail::test
