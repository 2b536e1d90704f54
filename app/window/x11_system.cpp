#include <X11/XKBlib.h>
#include <X11/Xlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/window/window_system.h"
#include "app/window/x11_key_watch.h"

// These functions are declared as in GLFW's own header for native access, which would require more X headers than this
// file needs. They are weak symbols, because a GLFW that was built only for Wayland does not have them.
extern "C" __attribute__((weak)) Display* glfwGetX11Display();
extern "C" __attribute__((weak)) XID glfwGetX11Window(GLFWwindow*);

namespace handrail::window {
namespace {

class X11System final : public WindowSystem {
public:
    explicit X11System(Display* display) : display_(display) {
        // By default, Xlib ends the whole program when the display is lost. The force on the hand would then end
        // abruptly, without a ramp. So replace Xlib's handlers.
        XSetIOErrorHandler([](Display*) { return 0; });
        XSetIOErrorExitHandler(
            display_, [](Display*, void* self) { static_cast<X11System*>(self)->lost_ = true; }, this);
    }
    ~X11System() override {
        glfwTerminate();
        XSetIOErrorHandler(nullptr);
    }

    unsigned number_of(GLFWwindow* window) const override { return static_cast<unsigned>(glfwGetX11Window(window)); }

    KeySymbol symbol_of(int scancode, bool shift) override {
        const KeySym symbol = XkbKeycodeToKeysym(display_, static_cast<KeyCode>(scancode), 0, shift ? 1 : 0);
        const char* name = XKeysymToString(symbol);
        return {static_cast<unsigned>(symbol), name ? name : ""};
    }

    unsigned x_key_code(int scancode) const override { return static_cast<unsigned>(scancode); }

    std::unique_ptr<KeyWatch> watch_keys(GLFWwindow* window, KeyWatchCalls calls) override {
        return x11_key_watch(XDisplayString(display_), glfwGetX11Window(window), std::move(calls));
    }

    bool lost() const override { return lost_; }

private:
    Display* display_;
    bool lost_ = false;
};

}  // namespace

std::unique_ptr<WindowSystem> x11_system() {
    Display* display = glfwGetX11Display ? glfwGetX11Display() : nullptr;
    if (!display) return nullptr;
    return std::make_unique<X11System>(display);
}

}  // namespace handrail::window
