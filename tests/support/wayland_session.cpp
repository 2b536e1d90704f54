#include "tests/support/wayland_session.h"
#include "tests/support/names.h"

#include <cstdlib>

namespace handrail::test {

std::string why_no_wayland(const std::string& glfw_version) {
    if (glfw_version.find("Wayland") == std::string::npos)
        return "GLFW " + glfw_version + " was built without Wayland; GLFW 3.4 as in Debian 13 has it";
    for (const char* needed : {"weston", "Xvfb", "xdotool"})
        if (!installed(needed)) return std::string(needed) + " is not installed";
    return {};
}

std::unique_ptr<WaylandSession> WaylandSession::start() {
    std::unique_ptr<WaylandSession> session(new WaylandSession);
    session->display_ = VirtualDisplay::start();
    if (!session->display_) return nullptr;
    const std::string folder = session->folder_.path().string();
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
    session->weston_ =
        ChildProcess::start({"weston", "--backend=x11-backend.so", "--use-pixman", "--width=1000", "--height=750",
                             "--socket=wayland-test", "--idle-time=0", "--no-config"},
                            {{"XDG_RUNTIME_DIR", folder}, {"WAYLAND_DISPLAY", ""}}, folder + "/weston.log");
    const auto has_socket = [&] { return std::filesystem::exists(folder + "/wayland-test"); };
    if (!session->weston_ || !eventually([&] { return has_socket() || !session->weston_->running(); })) return nullptr;
    if (!has_socket() || !session->give_keyboard()) return nullptr;
    ::setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
    ::setenv("WAYLAND_DISPLAY", "wayland-test", 1);
    ::unsetenv("DISPLAY");
    return session;
}

WaylandSession::~WaylandSession() { ::unsetenv("WAYLAND_DISPLAY"); }

// weston's window has no name. xdotool lists the root window first and then its only child, which is weston's window.
bool WaylandSession::give_keyboard() const {
    return eventually([&] {
        return display_->run(
            "xdotool windowfocus --sync $(xdotool search --onlyvisible --maxdepth 1 --class '.*' | sed -n 2p) "
            "2>/dev/null");
    });
}

// Gives the keyboard focus to the root window, where no program uses it. The pointer must leave weston's window as
// well, because weston would otherwise still get the keys.
bool WaylandSession::take_keyboard_away() const {
    return display_->run("xdotool mousemove 1020 765 windowfocus $(xdotool search --maxdepth 0 --class '.*')");
}

bool WaylandSession::save_picture(const std::string& file) const {
    return display_->run("import -window root '" + file + "'");
}

}  // namespace handrail::test
