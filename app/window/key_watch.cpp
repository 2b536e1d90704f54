#include "app/window/key_watch.h"

#include <X11/Xlib.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/window/keys.h"
#include "worlds/base/descriptor.h"

namespace handrail {
namespace {

constexpr std::size_t kKeyCodes = 256;  // of the X protocol

// X key code -> GLFW's key token, 0 where GLFW has none. Modifiers are left out: alone they mean something only when
// they come up again.
std::array<int, kKeyCodes> glfw_keys() {
    std::array<int, kKeyCodes> keys{};
    for (int key = GLFW_KEY_SPACE; key < GLFW_KEY_LEFT_SHIFT; ++key) {
        const int code = glfwGetKeyScancode(key);
        if (code > 0 && code < static_cast<int>(kKeyCodes)) keys[static_cast<std::size_t>(code)] = key;
    }
    return keys;
}

int glfw_modifiers(unsigned state) {
    return ((state & ShiftMask) ? GLFW_MOD_SHIFT : 0) | ((state & ControlMask) ? GLFW_MOD_CONTROL : 0) |
           ((state & Mod1Mask) ? GLFW_MOD_ALT : 0);
}

}  // namespace

class KeyWatch::Impl {
public:
    Impl(Display* display, unsigned long window, KeyWatchCalls calls)
        : display_(display), calls_(std::move(calls)), keys_(glfw_keys()), wake_(::eventfd(0, EFD_CLOEXEC)) {
        XSetIOErrorExitHandler(
            display_, [](Display*, void* self) { static_cast<Impl*>(self)->lost_ = true; }, this);
        // Any number of clients may ask for the same window's keys; each gets them all.
        XSelectInput(display_, window, KeyPressMask | FocusChangeMask);
        XSync(display_, False);
        thread_ = std::thread([this] { run(); });
    }
    ~Impl() {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
        thread_.join();
        // A connection that broke stays locked, and closing it would wait for ever; the program is about to end anyway.
        if (!lost_ && !broken()) XCloseDisplay(display_);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

private:
    // The server has hung up, whether anybody has noticed yet or not.
    bool broken() const {
        pollfd connection{ConnectionNumber(display_), POLLIN, 0};
        if (::poll(&connection, 1, 0) < 0 || (connection.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) return true;
        char next = 0;
        return (connection.revents & POLLIN) != 0 && ::recv(connection.fd, &next, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
    }

    void run() {
        std::array<pollfd, 2> watched{pollfd{ConnectionNumber(display_), POLLIN, 0}, pollfd{wake_.get(), POLLIN, 0}};
        while (!lost_) {
            while (!lost_ && XPending(display_) > 0) take_event();
            if (lost_ || ::poll(watched.data(), watched.size(), -1) < 0 || watched[1].revents != 0) break;
        }
    }

    void take_event() {
        XEvent event;
        XNextEvent(display_, &event);
        if (lost_) return;
        if (event.type == KeyPress) {
            const int key = keys_[event.xkey.keycode % kKeyCodes];
            const auto name = key != 0 ? key_name(key, glfw_modifiers(event.xkey.state)) : std::nullopt;
            if (name && calls_.is_wanted(*name)) calls_.pressed();
        } else if ((event.type == FocusIn || event.type == FocusOut) && event.xfocus.mode != NotifyGrab &&
                   event.xfocus.mode != NotifyUngrab) {
            calls_.focused(event.type == FocusIn);
        }
    }

    Display* display_;  // the watch's thread, from its start to its end
    KeyWatchCalls calls_;
    std::array<int, kKeyCodes> keys_;
    Descriptor wake_;
    std::atomic<bool> lost_{false};  // the display is gone
    std::thread thread_;
};

KeyWatch::KeyWatch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
KeyWatch::~KeyWatch() = default;

std::unique_ptr<KeyWatch> KeyWatch::start(const char* display_name, unsigned long window, KeyWatchCalls calls) {
    Display* display = XOpenDisplay(display_name);
    if (!display) return nullptr;
    return std::unique_ptr<KeyWatch>(new KeyWatch(std::make_unique<Impl>(display, window, std::move(calls))));
}

}  // namespace handrail
