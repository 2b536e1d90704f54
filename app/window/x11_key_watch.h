// Makes a KeyWatch on X11. It opens a separate connection, on which the server reports the window's keys as it reports
// them to the window.
#pragma once

#include <memory>

#include "app/window/key_watch.h"

namespace handrail::window {

// Makes a KeyWatch. `display_name` and `window` are values of Xlib. Returns null if the display accepts no second
// connection. Call it on GLFW's thread.
std::unique_ptr<KeyWatch> x11_key_watch(const char* display_name, unsigned long window, KeyWatchCalls calls);

}  // namespace handrail::window
