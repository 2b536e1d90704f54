// Sees the stop key, and the keyboard going elsewhere, the moment the X server tells of them: on a connection and a
// thread of its own, whatever the app's thread is doing. From a key to the call: the server's own delay and a thread's
// waking, well below a millisecond on an idle machine; without it keys are seen when the app next polls, up to a
// sixtieth of a second later, or after a slow picture. App thread: construction and destruction, while the window
// exists. The calls come on the watch's thread.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace handrail {

struct KeyWatchCalls {
    std::function<bool(const std::string&)>
        is_wanted;                      // a key's name, as KeyEvent::key; asked at each press, repeats too
    std::function<void()> pressed;      // a wanted key went down
    std::function<void(bool)> focused;  // the window has the keyboard, or lost it
};

class KeyWatch {
public:
    // display_name and window: as Xlib has them. The key codes are asked of GLFW, so on its thread. Null when the
    // display takes no second connection.
    static std::unique_ptr<KeyWatch> start(const char* display_name, unsigned long window, KeyWatchCalls calls);
    ~KeyWatch();
    KeyWatch(const KeyWatch&) = delete;
    KeyWatch& operator=(const KeyWatch&) = delete;

private:
    class Impl;
    explicit KeyWatch(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail
