#include "app/window/x11_key_watch.h"

#include <X11/Xlib.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <thread>

#include "app/window/key_codes.h"
#include "app/window/keys.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/executor.h"

namespace handrail::window {
namespace {

class X11KeyWatch final : public KeyWatch {
public:
    X11KeyWatch(Display* display, unsigned long window, KeyWatchCalls calls)
        : display_(display), calls_(std::move(calls)), keys_(keys_by_code()), wake_(::eventfd(0, EFD_CLOEXEC)) {
        XSetIOErrorExitHandler(
            display_, [](Display*, void* self) { static_cast<X11KeyWatch*>(self)->lost_ = true; }, this);
        // Selecting the keys here does not affect the window itself: any number of programs may select them, and each
        // receives all keys.
        XSelectInput(display_, window, KeyPressMask | FocusChangeMask);
        XSync(display_, False);
        thread_ = std::thread([this] {
            name_this_thread("key-watch");
            run();
        });
    }
    ~X11KeyWatch() override {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
        thread_.join();
        // Xlib keeps a broken connection locked, so closing the connection would wait for ever. Leave it open, because
        // the program is about to end.
        if (!lost_ && !broken()) XCloseDisplay(display_);
    }

private:
    // Returns true if the server has closed the connection, even if Xlib has not noticed it yet.
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
            const int key = keys_[event.xkey.keycode % keys_.size()];
            const auto name = key != 0 ? key_name(key, glfw_modifiers(event.xkey.state)) : std::nullopt;
            if (name && calls_.is_wanted(*name)) calls_.pressed();
        } else if ((event.type == FocusIn || event.type == FocusOut) && event.xfocus.mode != NotifyGrab &&
                   event.xfocus.mode != NotifyUngrab) {
            calls_.focused(event.type == FocusIn);
        }
    }

    Display* display_;  // while the key watch runs, only its thread uses this
    KeyWatchCalls calls_;
    KeysByCode keys_;
    Descriptor wake_;
    std::atomic<bool> lost_{false};  // true if the display was lost
    std::thread thread_;
};

}  // namespace

std::unique_ptr<KeyWatch> x11_key_watch(const char* display_name, unsigned long window, KeyWatchCalls calls) {
    Display* display = XOpenDisplay(display_name);
    if (!display) return nullptr;
    return std::make_unique<X11KeyWatch>(display, window, std::move(calls));
}

}  // namespace handrail::window
