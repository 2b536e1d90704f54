#include <sys/eventfd.h>
#include <unistd.h>

#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/window/key_codes.h"
#include "app/window/keys.h"
#include "app/window/wayland_keyboard.h"
#include "app/window/window_system.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/executor.h"

// A weak symbol, because neither GLFW before 3.4 nor a GLFW that was built only for X11 has this function.
extern "C" __attribute__((weak)) wl_display* glfwGetWaylandDisplay();

namespace handrail::window {
namespace {

class WaylandKeyWatch final : public KeyWatch {
public:
    WaylandKeyWatch(wl_display* display, KeyWatchCalls calls)
        : calls_(std::move(calls)),
          keys_(keys_by_code()),
          keyboard_(display, {[this](int code, unsigned modifiers) { take_key(code, modifiers); }, calls_.focused}),
          wake_(::eventfd(0, EFD_CLOEXEC)) {
        thread_ = std::thread([this] {
            name_this_thread("key-watch");
            while (keyboard_.wait(wake_.get())) {
            }
        });
    }
    ~WaylandKeyWatch() override {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
        thread_.join();
    }

private:
    void take_key(int code, unsigned modifiers) {
        const int key = code > 0 && code < static_cast<int>(keys_.size()) ? keys_[static_cast<std::size_t>(code)] : 0;
        const auto name = key != 0 ? key_name(key, glfw_modifiers(modifiers)) : std::nullopt;
        if (name && calls_.is_wanted(*name)) calls_.pressed();
    }

    KeyWatchCalls calls_;
    KeysByCode keys_;
    WaylandKeyboard keyboard_;  // while the key watch runs, only its thread uses this
    Descriptor wake_;
    std::thread thread_;
};

class WaylandSystem final : public WindowSystem {
public:
    explicit WaylandSystem(wl_display* display) : display_(display), keyboard_(std::in_place, display, kNoCalls) {}
    ~WaylandSystem() override {
        keyboard_.reset();
        glfwTerminate();
    }

    unsigned number_of(GLFWwindow*) const override { return 0; }

    KeySymbol symbol_of(int scancode, bool shift) override {
        keyboard_->take_pending();
        return keyboard_->symbol_of(scancode, shift);
    }

    unsigned x_key_code(int scancode) const override { return x_code_of(scancode); }

    std::unique_ptr<KeyWatch> watch_keys(GLFWwindow*, KeyWatchCalls calls) override {
        return std::make_unique<WaylandKeyWatch>(display_, std::move(calls));
    }

    bool lost() const override { return wl_display_get_error(display_) != 0; }

private:
    static inline const WaylandKeyboard::Calls kNoCalls{};
    wl_display* display_;
    std::optional<WaylandKeyboard> keyboard_;
};

}  // namespace

std::unique_ptr<WindowSystem> wayland_system() {
    wl_display* display = glfwGetWaylandDisplay ? glfwGetWaylandDisplay() : nullptr;
    if (!display) return nullptr;
    return std::make_unique<WaylandSystem>(display);
}

}  // namespace handrail::window
