// KeyWatch on X11: opens a separate connection, on which the server reports the window's keys as it does to the window.
#pragma once

#include <memory>

#include "app/window/key_watch.h"

namespace handrail::window {

// `display_name` and `window` are Xlib's. Returns null if the display accepts no second connection. GLFW's thread.
std::unique_ptr<KeyWatch> x11_key_watch(const char* display_name, unsigned long window, KeyWatchCalls calls);

}  // namespace handrail::window
