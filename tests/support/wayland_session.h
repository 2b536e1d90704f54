// A Wayland session of the test's own: the compositor weston in a window of a virtual X display, whose hands press the
// keys. Without an X server weston would have no keyboard.
#pragma once

#include <memory>
#include <string>

#include "tests/support/child_process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/virtual_display.h"

namespace handrail::test {

// Why no window can be tried on Wayland: what GLFW or this machine lacks. Empty if it can.
std::string why_no_wayland(const std::string& glfw_version);

class WaylandSession {
public:
    // From now on this process and its children see the Wayland display alone, not the X display. Null if weston or the
    // virtual display did not start.
    static std::unique_ptr<WaylandSession> start();
    ~WaylandSession();
    WaylandSession(const WaylandSession&) = delete;
    WaylandSession& operator=(const WaylandSession&) = delete;

    // As VirtualDisplay::xdotool; keys go to what has the keyboard in the session.
    bool xdotool(const std::string& words) const { return display_->xdotool(words); }
    // Gives the session the keyboard, or takes it away, as a person does who turns to another program.
    bool give_keyboard() const;
    bool take_keyboard_away() const;
    // Ends the compositor as a log-out does.
    void kill() { weston_.reset(); }
    // A picture of the whole session as a PNG file, by ImageMagick.
    bool save_picture(const std::string& file) const;

private:
    WaylandSession() = default;
    TemporaryFolder folder_;
    std::unique_ptr<VirtualDisplay> display_;
    std::unique_ptr<ChildProcess> weston_;
};

}  // namespace handrail::test
