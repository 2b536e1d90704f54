#include "app/window/wayland_keyboard.h"

#include <poll.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "app/window/key_codes.h"
#include "worlds/base/descriptor.h"

namespace handrail::window {
namespace {

constexpr std::uint32_t kSeatVersion = 5;  // first version of the interface in which a seat can be released

struct FreeContext {
    void operator()(xkb_context* context) const { xkb_context_unref(context); }
};

// Reads the compositor's description of the keyboard layout. Returns null if it cannot be read.
Keymap keymap_from(int fd, std::uint32_t size) {
    void* text = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (text == MAP_FAILED) return nullptr;
    const std::unique_ptr<xkb_context, FreeContext> context(xkb_context_new(XKB_CONTEXT_NO_DEFAULT_INCLUDES));
    Keymap keymap;
    const char* const begin = static_cast<const char*>(text);
    if (context)
        keymap.reset(xkb_keymap_new_from_buffer(context.get(), begin, ::strnlen(begin, size), XKB_KEYMAP_FORMAT_TEXT_V1,
                                                XKB_KEYMAP_COMPILE_NO_FLAGS));
    ::munmap(text, size);
    return keymap;
}

}  // namespace

KeySymbol key_symbol(xkb_keymap& keymap, int scancode, unsigned layout, bool shift) {
    const xkb_keycode_t code = x_code_of(scancode);
    const xkb_layout_index_t layouts = xkb_keymap_num_layouts_for_key(&keymap, code);
    if (layouts == 0) return {};
    const xkb_layout_index_t of_key = layout < layouts ? layout : 0;
    const bool second = shift && xkb_keymap_num_levels_for_key(&keymap, code, of_key) > 1;
    const xkb_keysym_t* symbols = nullptr;
    if (xkb_keymap_key_get_syms_by_level(&keymap, code, of_key, second ? 1 : 0, &symbols) < 1) return {};
    std::array<char, 64> name{};
    xkb_keysym_get_name(symbols[0], name.data(), name.size());
    return {symbols[0], name.data()};
}

struct WaylandKeyboard::Listeners {
    static WaylandKeyboard& self(void* data) { return *static_cast<WaylandKeyboard*>(data); }

    static constexpr wl_registry_listener kRegistry{
        .global =
            [](void* data, wl_registry* registry, std::uint32_t name, const char* interface, std::uint32_t version) {
                if (std::string_view(interface) == wl_seat_interface.name)
                    self(data).bind_seat(registry, name, version);
            },
        .global_remove = [](void*, wl_registry*, std::uint32_t) {}};

    static constexpr wl_seat_listener kSeat{
        .capabilities = [](void* data, wl_seat*,
                           std::uint32_t capabilities) { self(data).take_capabilities(capabilities); },
        .name = [](void*, wl_seat*, const char*) {}};

    static constexpr wl_keyboard_listener kKeyboard{
        .keymap = [](void* data, wl_keyboard*, std::uint32_t format, int fd,
                     std::uint32_t size) { self(data).take_keymap(format, fd, size); },
        .enter =
            [](void* data, wl_keyboard*, std::uint32_t, wl_surface*, wl_array*) {
                if (self(data).calls_.focused) self(data).calls_.focused(true);
            },
        .leave =
            [](void* data, wl_keyboard*, std::uint32_t, wl_surface*) {
                if (self(data).calls_.focused) self(data).calls_.focused(false);
            },
        .key =
            [](void* data, wl_keyboard*, std::uint32_t, std::uint32_t, std::uint32_t code, std::uint32_t state) {
                if (state == WL_KEYBOARD_KEY_STATE_PRESSED && self(data).calls_.pressed)
                    self(data).calls_.pressed(static_cast<int>(code), self(data).modifiers_);
            },
        .modifiers =
            [](void* data, wl_keyboard*, std::uint32_t, std::uint32_t held, std::uint32_t latched, std::uint32_t,
               std::uint32_t layout) {
                self(data).modifiers_ = held | latched;
                self(data).layout_ = layout;
            },
        .repeat_info = [](void*, wl_keyboard*, std::int32_t, std::int32_t) {}};
};

WaylandKeyboard::WaylandKeyboard(wl_display* display, Calls calls)
    : display_(display), calls_(std::move(calls)), queue_(wl_display_create_queue(display)) {
    // All objects that are made through this wrapper send their events to queue_.
    auto* own = static_cast<wl_display*>(wl_proxy_create_wrapper(display));
    wl_proxy_set_queue(reinterpret_cast<wl_proxy*>(own), queue_);
    registry_ = wl_display_get_registry(own);
    wl_proxy_wrapper_destroy(own);
    wl_registry_add_listener(registry_, &Listeners::kRegistry, this);
    // Wait in turn for the seat, for its keyboard and for the keyboard's layout.
    for (int answer = 0; answer < 3; ++answer)
        if (wl_display_roundtrip_queue(display_, queue_) < 0) return;
}

WaylandKeyboard::~WaylandKeyboard() {
    let_go_of_keyboard();
    if (seat_) wl_seat_release(seat_);
    wl_registry_destroy(registry_);
    wl_display_flush(display_);
    wl_event_queue_destroy(queue_);
}

void WaylandKeyboard::take_pending() { wl_display_dispatch_queue_pending(display_, queue_); }

bool WaylandKeyboard::wait(int wake) {
    while (wl_display_prepare_read_queue(display_, queue_) != 0)
        if (wl_display_dispatch_queue_pending(display_, queue_) < 0) return false;
    wl_display_flush(display_);
    std::array<pollfd, 2> watched{pollfd{wl_display_get_fd(display_), POLLIN, 0}, pollfd{wake, POLLIN, 0}};
    if (::poll(watched.data(), watched.size(), -1) < 0 || watched[1].revents != 0) {
        wl_display_cancel_read(display_);
        return false;
    }
    return wl_display_read_events(display_) == 0 && wl_display_dispatch_queue_pending(display_, queue_) >= 0;
}

KeySymbol WaylandKeyboard::symbol_of(int scancode, bool shift) const {
    return keymap_ ? key_symbol(*keymap_, scancode, layout_, shift) : KeySymbol{};
}

// Uses the first seat, which is the person's; GLFW does the same.
void WaylandKeyboard::bind_seat(wl_registry* registry, std::uint32_t name, std::uint32_t version) {
    if (seat_ || version < kSeatVersion) return;
    seat_ = static_cast<wl_seat*>(wl_registry_bind(registry, name, &wl_seat_interface, kSeatVersion));
    wl_seat_add_listener(seat_, &Listeners::kSeat, this);
}

// Called whenever a keyboard is connected to the seat or removed from it.
void WaylandKeyboard::take_capabilities(std::uint32_t capabilities) {
    const bool there = (capabilities & WL_SEAT_CAPABILITY_KEYBOARD) != 0;
    if (there && !keyboard_) {
        keyboard_ = wl_seat_get_keyboard(seat_);
        wl_keyboard_add_listener(keyboard_, &Listeners::kKeyboard, this);
    } else if (!there) {
        let_go_of_keyboard();
    }
}

void WaylandKeyboard::take_keymap(std::uint32_t format, int fd, std::uint32_t size) {
    const Descriptor owned(fd);
    keymap_ = format == WL_KEYBOARD_KEYMAP_FORMAT_XKB_V1 ? keymap_from(fd, size) : nullptr;
}

void WaylandKeyboard::let_go_of_keyboard() {
    if (keyboard_) wl_keyboard_release(std::exchange(keyboard_, nullptr));
}

}  // namespace handrail::window
