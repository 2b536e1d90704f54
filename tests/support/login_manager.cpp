#include "tests/support/login_manager.h"
#include "tests/support/names.h"

#include <fstream>
#include <iterator>

namespace handrail::test {
namespace {

// Debian's own Python, because other versions do not find Debian's packages. Python runs without the libraries that the
// test itself preloads.
const char* const kPython = "/usr/bin/python3";
const Environment kPlain{{"LD_PRELOAD", ""}};

bool has_dbusmock() {
    const auto python = ChildProcess::start({kPython, "-c", "import dbus, dbusmock"}, kPlain, "/dev/null");
    return python && python->exit_status() == 0;
}

}  // namespace

std::string LoginManager::why_not() {
#if defined(HANDRAIL_SANITIZED)
    return "D-Bus and Python are not judged under the sanitizers";
#endif
    if (!installed("dbus-daemon")) return "dbus-daemon is not installed";
    return has_dbusmock() ? "" : "python3-dbusmock is not installed";
}

LoginManager::LoginManager(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
    bus_ = ChildProcess::start({"dbus-daemon", "--session", "--nofork", "--nopidfile", "--address=" + address()},
                               kPlain, folder_ / "bus.out");
    if (!eventually([this] { return std::filesystem::exists(folder_ / "bus"); })) return;
    Environment environment = kPlain;
    environment["DBUS_SYSTEM_BUS_ADDRESS"] = address();
    logind_ =
        ChildProcess::start({kPython, "-m", "dbusmock", "--template", "logind"}, environment, folder_ / "logind.out");
}

std::string LoginManager::address() const { return "unix:path=" + (folder_ / "bus").string(); }

bool LoginManager::ready() const {
    return logind_ &&
           eventually([this] { return query("print(bus.name_has_owner('org.freedesktop.login1'))") == "True\n"; });
}

void LoginManager::announce_sleep(bool begins) const {
    query(std::string("logind.EmitSignal('org.freedesktop.login1.Manager', 'PrepareForSleep', 'b', [") +
          (begins ? "True" : "False") + "], dbus_interface='org.freedesktop.DBus.Mock')");
}

std::string LoginManager::inhibitors() const {
    return query(
        "for held in logind.ListInhibitors(dbus_interface='org.freedesktop.login1.Manager'):\n"
        "    print(held[0], held[1], held[3])");
}

std::string LoginManager::query(const std::string& python) const {
    const std::string whole = "import dbus, dbus.bus\nbus = dbus.bus.BusConnection('" + address() +
                              "')\nlogind = bus.get_object('org.freedesktop.login1', '/org/freedesktop/login1', "
                              "introspect=False) if bus.name_has_owner('org.freedesktop.login1') else None\n" +
                              python;
    const std::filesystem::path out = folder_ / "answer";
    std::filesystem::remove(out);  // removed first, because a child's output is appended
    if (const auto query_process = ChildProcess::start({kPython, "-c", whole}, kPlain, out))
        query_process->exit_status();
    std::ifstream answer(out);
    return {std::istreambuf_iterator<char>(answer), {}};
}

}  // namespace handrail::test
