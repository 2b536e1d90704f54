// The real window: takes keys, mouse and focus, and shows a picture for people with low vision and sighted helpers.
// Everything in it is also available by touch, sound and terminal. App thread only, which GLFW requires to be the main
// thread; at most one Window at a time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/core/context/view.h"
#include "app/window/key_gate.h"
#include "app/window/key_watch.h"
#include "app/window/keys.h"
#include "app/window/picture.h"
#include "worlds/base/result.h"

namespace handrail::window {

// A mouse movement of the simulated hand, in hand metres to the right, forward and up. Dragging with the left button
// moves it in the level plane, with the right button to the right and up. A notch of the wheel is one
// kHandMetresPerNotch up.
struct HandDragged {
    Vec3 by_m{0.0};
};
inline constexpr double kHandMetresPerPixel = 0.0002;  // a device's workspace of 15 cm spans 750 pixels
inline constexpr double kHandMetresPerNotch = 0.005;

struct FocusChange {
    bool focused = false;
};

// Characters from the keyboard's layout; they come after the key's own event.
struct TextEvent {
    std::string utf8;
};

// The person closed the window, or the display went away. The window stays until it is destroyed.
struct CloseRequest {};

using WindowEvent = std::variant<KeyEvent, TextEvent, HandDragged, FocusChange, CloseRequest>;

struct WindowOptions {
    std::string title = "Handrail";
    int width = 960;  // inner size, in screen coordinates
    int height = 720;
};

class Window {
public:
    // Takes about 0.2 s. Fails with one sentence: "There is no display; ..." if none can be reached, else what the
    // graphics driver lacks.
    static Result<std::unique_ptr<Window>> open(const WindowOptions& options = {});
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // The events since the last call, in order. Never waits. If the focus is lost, releases of all held keys follow its
    // FocusChange.
    std::vector<WindowEvent> poll();

    // From now on a separate thread also reports keys and the loss of the keyboard, at once; see KeyWatch. poll() still
    // returns them all. Returns false if the display allows no second connection.
    bool watch_keys(KeyWatchCalls calls);

    // From now on a screen reader is offered each key first, except those for which `never_waits` is true. It is given
    // the name as in KeyEvent::key.
    void offer_keys(KeyReader reader, std::function<bool(const std::string&)> never_waits);

    // X's number of this window, from which other programs know which window has the keyboard. 0 on Wayland, which has
    // no such numbers.
    unsigned number() const;

    // Shows the view; call it each time round the loop. It never waits for the screen's refresh, because the same
    // thread also serves sound and hand. It costs nothing if neither view nor window has changed. If drawing is slow,
    // it skips pictures to take at most a third of the time; a later call shows what was skipped.
    void draw(const core::ViewState& view);

    // A picture of the view as draw() would show it.
    Picture picture(const core::ViewState& view);

private:
    class Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::window
