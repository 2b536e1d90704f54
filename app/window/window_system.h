// The display that GLFW has opened, X11 or Wayland, and the differences that GLFW does not hide. X11 is preferred:
// there the stop key has a separate connection, and braille displays know which window has the keyboard. The window
// owns it and destroys it after everything else of GLFW. App thread only. Opening takes about 20 ms.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/key_watch.h"
#include "worlds/base/result.h"

struct GLFWwindow;

namespace handrail::window {

// The meaning of a key in the person's layout, in the terms of X and of screen readers.
struct KeySymbol {
    unsigned keysym = 0;  // 0: none
    std::string name;     // "Return", "exclam"
};

class WindowSystem {
public:
    // Initialises GLFW. Fails with one sentence: there is no display, or it is a Wayland session and this GLFW supports
    // only X11.
    static Result<std::unique_ptr<WindowSystem>> open();
    virtual ~WindowSystem() = default;  // terminates GLFW
    WindowSystem(const WindowSystem&) = delete;
    WindowSystem& operator=(const WindowSystem&) = delete;

    // The number by which other programs know the window; 0 if it has none, as on Wayland.
    virtual unsigned number_of(GLFWwindow* window) const = 0;
    virtual KeySymbol symbol_of(int scancode, bool shift) = 0;
    // The code of the key in X and for screen readers.
    virtual unsigned x_key_code(int scancode) const = 0;
    // See KeyWatch. The window and this object outlive the watch. Returns null if the display allows no watch.
    virtual std::unique_ptr<KeyWatch> watch_keys(GLFWwindow* window, KeyWatchCalls calls) = 0;
    // True if the display has gone away; then nothing may be drawn any more.
    virtual bool lost() const = 0;

protected:
    WindowSystem() = default;
};

// GLFW's last error message.
std::string glfw_problem();

// GLFW has been initialised; each returns null unless it runs on that system.
std::unique_ptr<WindowSystem> x11_system();
std::unique_ptr<WindowSystem> wayland_system();

}  // namespace handrail::window
