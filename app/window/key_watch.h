// Reports the stop key, and the loss of the keyboard, as soon as the display reports them. It uses a separate thread
// that the app thread cannot delay. The call follows the key after the delay of the display and the time until the
// thread wakes, well below a millisecond on an idle machine. Without this class, the program receives keys only when
// the app thread polls, up to a sixtieth of a second later, or after a slow picture. The app thread constructs and
// destroys the object while the window exists. The object makes its calls on its own thread.
#pragma once

#include <functional>
#include <string>

namespace handrail::window {

struct KeyWatchCalls {
    // Returns true if the key is the stop key. The argument is the key's name as in KeyEvent::key. Called at each
    // press; on X11 also when a held key repeats.
    std::function<bool(const std::string&)> is_wanted;
    std::function<void()> pressed;      // a key for which is_wanted returned true went down
    std::function<void(bool)> focused;  // true: the window received the keyboard; false: the window lost the keyboard
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
