// KeyWatch on X11: a connection of its own, on which the server reports the window's keys as it does to the window.
#pragma once

#include <memory>

#include "app/window/key_watch.h"

namespace handrail {

// display_name and window: as Xlib has them. Null when the display takes no second connection. GLFW's thread.
std::unique_ptr<KeyWatch> x11_key_watch(const char* display_name, unsigned long window, KeyWatchCalls calls);

}  // namespace handrail
