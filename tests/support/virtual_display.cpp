#include "tests/support/virtual_display.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail::test {

namespace {

// Starts a server for the display `display` and waits until it accepts connections. Returns the server's process, or -1
// if it cannot start, for instance because another server has that number.
pid_t serve(const std::string& display) {
    int ready[2];
    if (::pipe(ready) != 0) return -1;
    const pid_t parent = ::getpid();
    const pid_t server = ::fork();
    if (server == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // if the test dies, the kernel also ends the server
        if (::getppid() != parent) ::_exit(1);
        ::close(ready[0]);
        const std::string number_to = std::to_string(ready[1]);
        // Without -noreset, the server restarts whenever its last client leaves, and accepts no client meanwhile.
        // xdotool connects and leaves again and again.
        ::execlp("Xvfb", "Xvfb", display.c_str(), "-displayfd", number_to.c_str(), "-screen", "0", "1024x768x24",
                 "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::close(ready[1]);
    // Once the server accepts connections, it writes its display number and a line end. If it cannot start, it closes
    // the pipe.
    std::string number;
    for (char c = 0; ::read(ready[0], &c, 1) == 1 && c != '\n';) number += c;
    ::close(ready[0]);
    if (server > 0 && number.empty()) ::waitpid(server, nullptr, 0);
    return number.empty() ? -1 : server;
}

}  // namespace

std::unique_ptr<VirtualDisplay> VirtualDisplay::start() {
    if (!installed("Xvfb") || !installed("xdotool")) return nullptr;
    // The display number depends on this process. If two servers looked for a free number at the same time, both could
    // take the number of a server that was killed.
    for (int attempt = 0; attempt < 10; ++attempt) {
        const std::string number = std::to_string(100 + (::getpid() * 10 + attempt) % 50'000);
        const pid_t server = serve(":" + number);
        if (server <= 0) continue;
        std::unique_ptr<VirtualDisplay> display(new VirtualDisplay(server, number));
        ::setenv("DISPLAY", (":" + number).c_str(), 1);
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        return display;
    }
    return nullptr;
}

VirtualDisplay::~VirtualDisplay() { kill(); }

bool VirtualDisplay::run(const std::string& line) const {
    return std::system(("export DISPLAY=:" + number_ + "; timeout 300 " + line).c_str()) == 0;
}

void VirtualDisplay::kill() {
    if (server_ <= 0) return;
    ::kill(server_, SIGKILL);
    ::waitpid(server_, nullptr, 0);
    server_ = 0;
    ::unlink(("/tmp/.X" + number_ + "-lock").c_str());
    ::unlink(("/tmp/.X11-unix/X" + number_).c_str());
}

}  // namespace handrail::test
