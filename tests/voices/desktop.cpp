#include "tests/voices/desktop.h"

#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

namespace fs = std::filesystem;

std::string Desktop::why_not() {
#if defined(HANDRAIL_SANITIZED)
    return "Orca, D-Bus and their libraries are not judged under the sanitizers";
#endif
    for (const char* program : {"orca", "dbus-daemon", "at-spi-bus-launcher", "speech-dispatcher", "Xvfb", "xdotool"})
        if (!installed(program)) return std::string(program) + " is not installed";
    return {};
}

Desktop::Desktop(const fs::path& folder, int word_ms) : folder_(folder) {
    fs::create_directories(folder_ / "session");
    fs::permissions(folder_ / "session", fs::perms::owner_all);
    display = VirtualDisplay::start();
    if (!display) return;
    bus_ = ChildProcess::start({"dbus-daemon", "--session", "--nofork", "--nopidfile",
                                "--address=unix:path=" + (folder_ / "session" / "bus").string()},
                               session(), folder_ / "bus.out");
    if (!eventually([&] { return fs::exists(folder_ / "session" / "bus"); })) return;
    speech = SpeechServer::start(folder_, word_ms);
}

Desktop::~Desktop() {
    // End the bus with SIGTERM, because only then does it also end everything that it has started.
    if (bus_) bus_->send(SIGTERM);
}

Environment Desktop::session() const {
    return {{"HOME", folder_.string()},
            {"XDG_RUNTIME_DIR", (folder_ / "session").string()},
            {"XDG_CONFIG_HOME", ""},
            {"XDG_DATA_HOME", ""},
            {"WAYLAND_DISPLAY", ""},
            {"GSETTINGS_BACKEND", "memory"},
            {"NO_AT_BRIDGE", ""},
            {"DBUS_SESSION_BUS_ADDRESS", "unix:path=" + (folder_ / "session" / "bus").string()}};
}

Environment Desktop::environment(bool speech_server) const {
    Environment all = session();
    all["DISPLAY"] = std::getenv("DISPLAY");
    all["LIBGL_ALWAYS_SOFTWARE"] = "1";
    if (speech_server) all.merge(speech->environment());
    return all;
}

// Orca does not start if the same user already runs one, even for another session. Such an Orca may be a developer's
// own, or that of another test. Orca checks this with pgrep, so in this test it gets a pgrep that finds no process.
std::string Desktop::without_other_orcas() const {
    const fs::path folder = folder_ / "programs";
    fs::create_directories(folder);
    std::ofstream(folder / "pgrep") << "#!/bin/sh\nexit 1\n";
    fs::permissions(folder / "pgrep", fs::perms::owner_all);
    return folder.string();
}

bool Desktop::start_orca(const Environment& braille) {
    const auto began = static_cast<std::ptrdiff_t>(speech->recorded().size());
    Environment environment = session();
    environment.merge(speech->environment());
    for (const auto& [name, value] : braille) environment[name] = value;
    // The system's Python has the modules that Orca needs.
    environment["PATH"] = without_other_orcas() + ":/usr/bin:/bin";
    // Orca 43 quits if it has not started within 10 s, which it may not manage on a busy machine. Orca runs this file
    // before that check, so the file can extend the limit.
    fs::create_directories(folder_ / "orca");
    std::ofstream(folder_ / "orca" / "orca-customizations.py")
        << "import signal\nfrom orca import settings\nsettings.timeoutTime = 0\nsignal.alarm(0)\n";
    orca_ = ChildProcess::start(
        {"orca", braille.empty() ? "-d" : "-e", "braille", "-e", "speech", "-u", (folder_ / "orca").string()},
        environment, folder_ / "orca.out");
    return orca_ && eventually([&] {
               const auto all = speech->recorded();
               return std::any_of(all.begin() + began, all.end(), [](const Recorded& entry) {
                   return entry.words.find("Screen reader on") != std::string::npos;
               });
           });
}

bool Desktop::focus_window() const {
    return eventually([&] {
        return display->xdotool("search --onlyvisible --name '^Handrail$' windowfocus --sync >/dev/null 2>&1");
    });
}

std::string Desktop::objects() const {
    static constexpr const char* kDump = R"(
import pyatspi
def dump(a, depth):
    print('  ' * depth + a.getRoleName() + ' "' + a.name + '"' +
          (' selected' if a.getState().contains(pyatspi.STATE_SELECTED) else '')
          + (' focused' if a.getState().contains(pyatspi.STATE_FOCUSED) else ''))
    for i in range(a.childCount):
        dump(a.getChildAtIndex(i), depth + 1)
for a in pyatspi.Registry.getDesktop(0):
    if a and a.name == 'Handrail':
        dump(a, 0)
)";
    return query_objects(kDump);
}

std::string Desktop::query_objects(const std::string& python) const {
    const fs::path out = folder_ / "objects";
    fs::remove(out);
    Environment environment = session();
    environment["PATH"] = "/usr/bin:/bin";
    // By default, pyatspi reports no children for a program that does not answer within 0.8 s, which happens on a busy
    // machine. So extend this limit.
    const std::string patient = "import pyatspi\npyatspi.setTimeout(120000, 120000)\n";
    const auto reader = ChildProcess::start({"python3", "-c", patient + python}, environment, out);
    if (reader) reader->exit_status();
    return content_of(out);
}

std::string Desktop::everything() const {
    return speech->everything() + "\nOrca:\n" + content_of(folder_ / "orca.out") + "\nbus:\n" +
           content_of(folder_ / "bus.out");
}

}  // namespace handrail::test
