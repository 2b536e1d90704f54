// Sees the stop key, and the keyboard going elsewhere, the moment the display tells of them: on a thread of its own,
// whatever the app's thread is doing. From a key to the call: the display's own delay and a thread's waking, well below
// a millisecond on an idle machine; without it keys are seen when the app next polls, up to a sixtieth of a second
// later, or after a slow picture. App thread: construction and destruction, while the window exists. The calls come on
// the watch's thread.
#pragma once

#include <functional>
#include <string>

namespace handrail {

struct KeyWatchCalls {
    // A key's name, as KeyEvent::key; queried at each press, on X11 also when a held key repeats.
    std::function<bool(const std::string&)> is_wanted;
    std::function<void()> pressed;      // a wanted key went down
    std::function<void(bool)> focused;  // the window has the keyboard, or lost it
};

class KeyWatch {
public:
    virtual ~KeyWatch() = default;
    KeyWatch(const KeyWatch&) = delete;
    KeyWatch& operator=(const KeyWatch&) = delete;

protected:
    KeyWatch() = default;
};

}  // namespace handrail
