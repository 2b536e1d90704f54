// Sees the stop key, and the loss of the keyboard, as soon as the display reports them, on a separate thread that the
// app thread cannot delay. From the key to the call it takes the display's own delay and a thread's waking, well below
// a millisecond on an idle machine. Without it, keys are seen when the app next polls, up to a sixtieth of a second
// later, or after a slow picture. The app thread constructs and destroys it while the window exists. The calls come on
// the watch's thread.
#pragma once

#include <functional>
#include <string>

namespace handrail::window {

struct KeyWatchCalls {
    // Is given a key's name as in KeyEvent::key. Called at each press; on X11 also when a held key repeats.
    std::function<bool(const std::string&)> is_wanted;
    std::function<void()> pressed;      // a wanted key went down
    std::function<void(bool)> focused;  // the window got the keyboard, or lost it
};

class KeyWatch {
public:
    virtual ~KeyWatch() = default;
    KeyWatch(const KeyWatch&) = delete;
    KeyWatch& operator=(const KeyWatch&) = delete;

protected:
    KeyWatch() = default;
};

}  // namespace handrail::window
