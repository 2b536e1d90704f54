// Follows the keyboard of a Wayland session, as the compositor reports it to this program's window. The object has its
// own event queue on GLFW's connection, so it needs neither GLFW's thread nor its key table. Only one thread uses an
// object; two objects on two threads do not affect each other.
#pragma once

#include <wayland-client.h>
#include <xkbcommon/xkbcommon.h>

#include <functional>
#include <memory>

#include "app/window/window_system.h"

namespace handrail::window {

struct FreeKeymap {
    void operator()(xkb_keymap* keymap) const { xkb_keymap_unref(keymap); }
};
using Keymap = std::unique_ptr<xkb_keymap, FreeKeymap>;

// Returns what the key types in the given `layout`, alone or with Shift. If the layout has no second level for the key,
// `shift` has no effect.
KeySymbol key_symbol(xkb_keymap& keymap, int scancode, unsigned layout, bool shift);

// Returns X's code for a kernel key code. X adds 8 to the kernel's codes.
constexpr unsigned x_code_of(int scancode) { return static_cast<unsigned>(scancode) + 8; }

class WaylandKeyboard {
public:
    struct Calls {
        std::function<void(int scancode, unsigned modifiers)> pressed;  // `modifiers` has the bits of key_codes.h
        std::function<void(bool)> focused;
    };

    // Waits until the compositor has reported whether there is a keyboard, and which layout it has; this takes about 1
    // ms.
    WaylandKeyboard(wl_display* display, Calls calls);
    ~WaylandKeyboard();
    WaylandKeyboard(const WaylandKeyboard&) = delete;
    WaylandKeyboard& operator=(const WaylandKeyboard&) = delete;

    // Reports all events that have arrived, by the functions in `calls`. Never waits for events.
    void take_pending();
    // Waits for events, or until `wake` is readable. Returns false if `wake` is readable, or if the connection is
    // broken.
    bool wait(int wake);

    KeySymbol symbol_of(int scancode, bool shift) const;

private:
    struct Listeners;

    void bind_seat(wl_registry* registry, std::uint32_t name, std::uint32_t version);
    void take_capabilities(std::uint32_t capabilities);
    void take_keymap(std::uint32_t format, int fd, std::uint32_t size);
    void let_go_of_keyboard();

    wl_display* display_;
    Calls calls_;
    wl_event_queue* queue_ = nullptr;
    wl_registry* registry_ = nullptr;
    wl_seat* seat_ = nullptr;
    wl_keyboard* keyboard_ = nullptr;
    Keymap keymap_;
    unsigned layout_ = 0;
    unsigned modifiers_ = 0;
};

}  // namespace handrail::window
