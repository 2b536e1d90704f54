// The real window: keys, mouse and focus in, a picture out, for people with low vision and sighted helpers. Everything
// in it can also be had by touch, sound and the terminal. App thread only (GLFW wants the main one); at most one Window
// at a time.
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

namespace handrail {

// The simulated hand was moved with the mouse: hand metres to the right, forward and up. Dragging with the left button
// moves it in the level plane, with the right button right and up; a notch of the wheel is one kHandMetresPerNotch up.
struct HandDragged {
    Vec3 by_m{0.0};
};
inline constexpr double kHandMetresPerPixel = 0.0002;  // 15 cm, a device's reach, across 750 pixels
inline constexpr double kHandMetresPerNotch = 0.005;

struct FocusChange {
    bool focused = false;
};

// Characters as the keyboard's layout makes them, after the key's own event.
struct TextEvent {
    std::string utf8;
};

// The person closed the window, or the display went away. The window stays until it is destroyed.
struct CloseRequest {};

using WindowEvent = std::variant<KeyEvent, TextEvent, HandDragged, FocusChange, CloseRequest>;

struct WindowOptions {
    std::string title = "Handrail";
    int width = 960;  // of the inside, in screen coordinates
    int height = 720;
};

class Window {
public:
    // Fails with one sentence: "There is no display; ..." where none can be reached, else what the graphics driver
    // lacks. About 0.2 s.
    static Result<std::unique_ptr<Window>> open(const WindowOptions& options = {});
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // What happened since the last call, in order. Never waits. When the focus goes, releases of all held keys come
    // after its FocusChange.
    std::vector<WindowEvent> poll();

    // From now on keys and the keyboard's loss are told on a thread of their own too, at once; see KeyWatch. poll()
    // gives them all the same. False when the display allows no second connection.
    bool watch_keys(KeyWatchCalls calls);

    // From now on a screen reader has each key first, except those that are not to wait for it (by name, as
    // KeyEvent::key).
    void offer_keys(KeyReader reader, std::function<bool(const std::string&)> never_waits);

    // X's number of this window, by which other programs know which one has the keyboard. 0 on Wayland, which has none.
    unsigned number() const;

    // Shows the view; call it each time round the loop. The same thread also feeds ears and hand, so this does not wait
    // for the screen's refresh, costs nothing when neither view nor window changed, and where drawing is slow skips
    // pictures so as to take at most a third of the time; what was skipped is shown by a later call.
    void draw(const ViewState& view);

    // The view as draw() shows it.
    Picture picture(const ViewState& view);

private:
    class Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail
