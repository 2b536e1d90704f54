// The display that GLFW has opened, X11 or Wayland, and what GLFW does not hide of the difference. X11 is preferred:
// there the stop key has a connection of its own, and braille displays know which window has the keyboard. The window
// owns it, and destroys it after everything else of GLFW. App thread only. Opening costs about 20 ms.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/key_watch.h"
#include "worlds/base/result.h"

struct GLFWwindow;

namespace handrail {

// What a key means in the person's layout, in the words of X and of screen readers.
struct KeySymbol {
    unsigned keysym = 0;  // 0: none
    std::string name;     // "Return", "exclam"
};

class WindowSystem {
public:
    // Initialises GLFW. Fails with one sentence: no display, or a Wayland session and a GLFW that has only X11.
    static Result<std::unique_ptr<WindowSystem>> open();
    virtual ~WindowSystem() = default;  // terminates GLFW
    WindowSystem(const WindowSystem&) = delete;
    WindowSystem& operator=(const WindowSystem&) = delete;

    // The number by which other programs know the window. 0: there is none, as on Wayland.
    virtual unsigned number_of(GLFWwindow* window) const = 0;
    virtual KeySymbol symbol_of(int scancode, bool shift) = 0;
    // The code by which X and screen readers know the key.
    virtual unsigned x_key_code(int scancode) const = 0;
    // See KeyWatch. The window and this object outlive the watch. Null if the display refuses it.
    virtual std::unique_ptr<KeyWatch> watch_keys(GLFWwindow* window, KeyWatchCalls calls) = 0;
    // The display has gone away; nothing may be drawn any more.
    virtual bool lost() const = 0;

protected:
    WindowSystem() = default;
};

// GLFW's last error in its own words.
std::string glfw_problem();

// GLFW is initialised for that system. Null if it is not, which tells the two apart.
std::unique_ptr<WindowSystem> x11_system();
std::unique_ptr<WindowSystem> wayland_system();

}  // namespace handrail
