// Starts a separate Wayland session for the test: the compositor weston in a window of a virtual X display, on which
// xdotool presses the keys. Without an X server, weston would have no keyboard.
#pragma once

#include <memory>
#include <string>

#include "tests/support/child_process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/virtual_display.h"

namespace handrail::test {

// Returns why a window cannot be tested on Wayland, because of GLFW or this machine, or an empty text if it can.
std::string why_no_wayland(const std::string& glfw_version);

class WaylandSession {
public:
    // Starts the session. From then on this process and its children see only the Wayland display, not the X display.
    // Returns null if weston or the virtual display did not start.
    static std::unique_ptr<WaylandSession> start();
    ~WaylandSession();
    WaylandSession(const WaylandSession&) = delete;
    WaylandSession& operator=(const WaylandSession&) = delete;

    // Does the same as VirtualDisplay::xdotool(). The keys go to the window that has the keyboard focus in the session.
    bool xdotool(const std::string& words) const { return display_->xdotool(words); }
    // Give the keyboard focus to the session or take it away, as when a person switches to another program.
    bool give_keyboard() const;
    bool take_keyboard_away() const;
    // Ends the compositor, as logging out does.
    void kill() { weston_.reset(); }
    // Saves a picture of the whole session as a PNG file, with ImageMagick.
    bool save_picture(const std::string& file) const;

private:
    WaylandSession() = default;
    TemporaryFolder folder_;
    std::unique_ptr<VirtualDisplay> display_;
    std::unique_ptr<ChildProcess> weston_;
};

}  // namespace handrail::test
