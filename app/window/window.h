// Opens the program's window, receives keys, mouse and focus, and shows a picture for people with low vision and
// sighted helpers. Everything in the window is also available by touch, sound and terminal. Only the app thread uses
// it, which must be the main thread, as GLFW requires. There is at most one Window at a time.
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

// A mouse movement that moves the simulated hand, in hand metres to the right, forwards and up. Dragging with the left
// button moves the hand horizontally. Dragging with the right button moves it to the right and up. Each notch of the
// wheel moves it up by kHandMetresPerNotch.
struct HandDragged {
    Vec3 by_m{0.0};
};
inline constexpr double kHandMetresPerPixel = 0.0002;  // at this scale, a workspace of 15 cm spans 750 pixels
inline constexpr double kHandMetresPerNotch = 0.005;

struct FocusChange {
    bool focused = false;
};

// Characters that the last key typed in the keyboard's layout. They follow the KeyEvent of that key.
struct TextEvent {
    std::string utf8;
};

// The person closed the window, or the display was lost. The Window object still exists until its owner destroys it.
struct CloseRequest {};

using WindowEvent = std::variant<KeyEvent, TextEvent, HandDragged, FocusChange, CloseRequest>;

// The place of a window's content on the screens, in screen coordinates.
struct WindowPlace {
    int x = 0, y = 0, width = 960, height = 720;

    bool operator==(const WindowPlace&) const = default;
};
// Reads a place such as "1280x720+100+50", as the setting display.place has it. Returns no value for any other text.
std::optional<WindowPlace> window_place(std::string_view text);
std::string window_place_text(const WindowPlace& place);

struct WindowOptions {
    // No value, or a place that no screen shows completely: the window is as large as the screen without its bars.
    std::optional<WindowPlace> place = {};
    bool full_screen = false;
};

class Window {
public:
    // Opens the window, which takes about 0.2 s. Fails with one sentence: "There is no display; ..." if no display can
    // be reached, otherwise what the graphics driver lacks.
    static Result<std::unique_ptr<Window>> open(const WindowOptions& options = {});
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Returns the events since the last call, in their order. Never waits. If the window loses the focus, releases of
    // all held keys follow the FocusChange.
    std::vector<WindowEvent> poll();

    // From now on, a separate thread also reports keys, and the loss of the keyboard, at once; see KeyWatch. poll()
    // still returns all of them. Returns false if the display does not allow a KeyWatch.
    bool watch_keys(KeyWatchCalls calls);

    // From now on, offers each key to a screen reader first. Does not offer a key if `never_waits` returns true for its
    // name, which is as in KeyEvent::key.
    void offer_keys(KeyReader reader, std::function<bool(const std::string&)> never_waits);

    // Returns X's number of this window, by which other programs know which window has the keyboard. Returns 0 on
    // Wayland, which has no such numbers.
    unsigned number() const;

    // Returns the place of the window for the setting display.place. The text is empty if the window fills the screen
    // or the system does not tell the place.
    std::string place() const;

    // Shows the view with its title, and fills the screen if the view's settings say so. Call it once a frame. It never
    // waits for the refresh of the screen, because the app thread also serves sound and hand. It costs nothing if
    // neither view nor window has changed. If drawing is slow, the function skips pictures, so that drawing takes at
    // most a third of the time. A later call then shows the newest view.
    void draw(const core::ViewState& view);

    // Returns a picture of the view as draw() would show it.
    Picture picture(const core::ViewState& view);

private:
    class Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::window
