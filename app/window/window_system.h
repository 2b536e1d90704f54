// Opens the display, X11 or Wayland, through GLFW. Hides the differences between the two that GLFW does not hide. X11
// is preferred, because there the stop key has a separate connection, and braille displays know which window has the
// keyboard. The window owns the object and destroys it after all other objects of GLFW. App thread only. Opening takes
// about 20 ms.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/window/key_watch.h"
#include "worlds/base/result.h"

struct GLFWwindow;

namespace handrail::window {

// What a key types in the person's layout, as X and screen readers express it.
struct KeySymbol {
    unsigned keysym = 0;  // keysym of X; 0: none
    std::string name;     // name of the keysym, such as "Return" or "exclam"
};

class WindowSystem {
public:
    // Initialises GLFW. Fails with one sentence if there is no display, or if it is a Wayland session and this GLFW
    // supports only X11.
    static Result<std::unique_ptr<WindowSystem>> open();
    virtual ~WindowSystem() = default;  // the destructor terminates GLFW
    WindowSystem(const WindowSystem&) = delete;
    WindowSystem& operator=(const WindowSystem&) = delete;

    // Returns the number by which other programs know the window; 0 if it has none, as on Wayland.
    virtual unsigned number_of(GLFWwindow* window) const = 0;
    virtual KeySymbol symbol_of(int scancode, bool shift) = 0;
    // Returns the code of the key for X and for screen readers.
    virtual unsigned x_key_code(int scancode) const = 0;
    // Makes a KeyWatch. The window and this object must outlive the KeyWatch. Returns null if the display allows none.
    virtual std::unique_ptr<KeyWatch> watch_keys(GLFWwindow* window, KeyWatchCalls calls) = 0;
    // Returns true if the display was lost. Nothing may then be drawn any more.
    virtual bool lost() const = 0;

protected:
    WindowSystem() = default;
};

// Returns GLFW's last error message.
std::string glfw_problem();

// Each function returns null unless GLFW uses that window system. GLFW must be initialised.
std::unique_ptr<WindowSystem> x11_system();
std::unique_ptr<WindowSystem> wayland_system();

}  // namespace handrail::window
