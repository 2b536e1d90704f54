#include "app/window/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/window/key_codes.h"
#include "app/window/key_labels.h"
#include "app/window/renderer.h"
#include "app/window/window_system.h"
#include "worlds/base/language.h"

namespace handrail::window {
namespace {

// How many further frames are drawn after a change of size, because drivers may still present a buffer of the old size.
constexpr int kFramesToSettle = 3;

constexpr double kReducedMotion_s = 0.5;  // time between two pictures with reduced motion

// A screen and the part of it without the bars of the desktop.
struct Screen {
    GLFWmonitor* monitor = nullptr;
    WindowPlace free;
};

std::vector<Screen> screens() {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::vector<Screen> found;
    for (int i = 0; i < count; ++i) {
        Screen screen{monitors[i], {}};
        glfwGetMonitorWorkarea(monitors[i], &screen.free.x, &screen.free.y, &screen.free.width, &screen.free.height);
        if (screen.free.width > 0 && screen.free.height > 0) found.push_back(screen);
    }
    return found;
}

int overlap(int a, int a_size, int b, int b_size) { return std::min(a + a_size, b + b_size) - std::max(a, b); }

// Returns the screen that shows most of the window, or the first screen.
Screen screen_of(const WindowPlace& place) {
    Screen best;
    double most = -1.0;
    for (const Screen& screen : screens()) {
        const int wide = overlap(place.x, place.width, screen.free.x, screen.free.width),
                  high = overlap(place.y, place.height, screen.free.y, screen.free.height);
        const double shown = wide > 0 && high > 0 ? static_cast<double>(wide) * high : 0.0;
        if (shown > most) {
            most = shown;
            best = screen;
        }
    }
    return best;
}

// Returns the place if a screen shows it completely.
std::optional<WindowPlace> shown_completely(const std::optional<WindowPlace>& place) {
    if (!place) return {};
    const std::vector<Screen> all = screens();
    const bool shown = std::any_of(all.begin(), all.end(), [&](const Screen& screen) {
        return place->x >= screen.free.x && place->y >= screen.free.y &&
               place->x + place->width <= screen.free.x + screen.free.width &&
               place->y + place->height <= screen.free.y + screen.free.height;
    });
    return shown ? place : std::nullopt;
}

WindowPlace whole_screen() {
    const Screen screen = screen_of({});
    return screen.monitor ? screen.free : WindowPlace{};
}

// Returns the character in UTF-8. Returns an empty text for a code beyond Unicode, which GLFW never reports.
std::string utf8_of(unsigned int c) {
    const auto byte = [](unsigned int bits) { return static_cast<char>(bits); };
    if (c < 0x80) return {byte(c)};
    if (c < 0x800) return {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
    if (c < 0x10000) return {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
    if (c < 0x110000)
        return {byte(0xF0 | c >> 18), byte(0x80 | (c >> 12 & 0x3F)), byte(0x80 | (c >> 6 & 0x3F)),
                byte(0x80 | (c & 0x3F))};
    return {};
}

}  // namespace

class Window::Impl {
public:
    Result<void> open(const WindowOptions& options) {
        auto system = WindowSystem::open();
        if (!system) return tl::unexpected(system.error());
        system_ = std::move(*system);

        const std::optional<WindowPlace> wanted = shown_completely(options.place);
        const WindowPlace place = wanted.value_or(whole_screen());
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        // Try EGL as well, because some displays provide OpenGL only through EGL.
        for (const int way : {GLFW_NATIVE_CONTEXT_API, GLFW_EGL_CONTEXT_API}) {
            glfwWindowHint(GLFW_CONTEXT_CREATION_API, way);
            window_ = glfwCreateWindow(place.width, place.height, "Handrail", nullptr, nullptr);
            if (window_) break;
        }
        if (!window_) return fail(phrase("window.no_opengl", {{"reason", glfw_problem()}}));
        glfwSetWindowPos(window_, place.x, place.y);  // Wayland lets no program place its windows.
        // The hint GLFW_MAXIMIZED would do the same, but GLFW 3.4 then shows a picture of the wrong size first, for
        // which a Wayland compositor ends the connection.
        if (!wanted) glfwMaximizeWindow(window_);
        if (options.full_screen) fill_screen(true);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(0);
        auto renderer = Renderer::create();
        if (!renderer) return tl::unexpected(renderer.error());
        renderer_ = std::move(*renderer);

        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int code, int action, int mods) {
            self(w).take_key(key, code, action, mods);
        });
        glfwSetCharCallback(window_,
                            [](GLFWwindow* w, unsigned int character) { self(w).take_text(utf8_of(character)); });
        glfwSetWindowFocusCallback(window_,
                                   [](GLFWwindow* w, int focused) { self(w).take_focus(focused == GLFW_TRUE); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w).take_close(); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w).shown_.reset(); });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { self(w).keys_.other_input(); });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { self(w).take_cursor(x, y); });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double notches) { self(w).take_wheel(notches); });
        return {};
    }

    ~Impl() {
        watch_.reset();
        renderer_.reset();
        if (window_) glfwDestroyWindow(window_);
    }

    std::vector<WindowEvent> poll() {
        if (!system_->lost()) glfwPollEvents();
        take_decided_keys();
        if (system_->lost() && !loss_reported_) {
            loss_reported_ = true;
            for (KeyEvent& event : keys_.let_go()) events_.emplace_back(std::move(event));
            events_.emplace_back(CloseRequest{});
        }
        return std::exchange(events_, {});
    }

    unsigned number() const { return system_->number_of(window_); }

    std::string place() const {
        return system_->lost() || full_screen_ ? std::string{} : window_place_text(place_now());
    }

    bool watch_keys(KeyWatchCalls calls) {
        watch_ = system_->watch_keys(window_, std::move(calls));
        return watch_ != nullptr;
    }

    void offer_keys(KeyReader reader, std::function<bool(const std::string&)> never_waits) {
        gate_.set_reader(std::move(reader));
        never_waits_ = std::move(never_waits);
    }

    void draw(const core::ViewState& view) {
        if (system_->lost()) return;
        const PixelSize size = framebuffer_size();
        if (size != shown_size_) frames_in_size_ = 0;
        if (shown_ && *shown_ == view && frames_in_size_ >= kFramesToSettle) return;
        // Without a graphics card, drawing a picture can take longer than the time until the next frame. So skip
        // pictures.
        const double begin_s = glfwGetTime();
        if (begin_s < rest_until_s_) return;
        if (view.display.full_screen != full_screen_) fill_screen(view.display.full_screen);
        if (std::string title = view.texts.title.empty() ? "Handrail" : view.texts.title; title != title_) {
            glfwSetWindowTitle(window_, title.c_str());
            title_ = std::move(title);
        }
        renderer_->draw(view, size);
        glfwSwapBuffers(window_);
        const double end_s = glfwGetTime();
        rest_until_s_ = end_s + std::max(2.0 * (end_s - begin_s), view.display.reduced_motion ? kReducedMotion_s : 0.0);
        ++frames_in_size_;
        shown_ = view;
        shown_size_ = size;
    }

    Picture picture(const core::ViewState& view) {
        if (system_->lost()) return {};
        const PixelSize size = framebuffer_size();
        renderer_->draw(view, size);
        return Renderer::read_back(size);
    }

private:
    // Lets the window fill the screen on which most of it is, or puts it back where it was.
    void fill_screen(bool fill) {
        full_screen_ = fill;
        if (!fill) {
            glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width, windowed_.height,
                                 GLFW_DONT_CARE);
            return;
        }
        windowed_ = place_now();
        const Screen screen = screen_of(windowed_);
        if (!screen.monitor) return;
        if (const GLFWvidmode* mode = glfwGetVideoMode(screen.monitor))
            glfwSetWindowMonitor(window_, screen.monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

    WindowPlace place_now() const {
        WindowPlace place;
        glfwGetWindowPos(window_, &place.x, &place.y);
        glfwGetWindowSize(window_, &place.width, &place.height);
        return place;
    }

    static Impl& self(GLFWwindow* window) { return *static_cast<Impl*>(glfwGetWindowUserPointer(window)); }

    PixelSize framebuffer_size() const {
        PixelSize size;
        glfwGetFramebufferSize(window_, &size.width, &size.height);
        return size;
    }

    // Returns the token whose name the key gets. A held key keeps its name even if the layout changes in the meantime.
    // GLFW does not report changes of the layout, so this function reads GLFW's table at each key press.
    int named_key(int key, int action) {
        if (key < GLFW_KEY_SPACE || key > GLFW_KEY_WORLD_2) return key;
        if (action == GLFW_PRESS) {
            const std::map<int, int> named = keys_by_label(key_labels());
            const auto name = named.find(key);
            held_as_[key] = name == named.end() ? key : name->second;
        }
        const auto held = held_as_.find(key);
        return held == held_as_.end() ? key : held->second;
    }

    void take_key(int place, int code, int action, int mods) {
        const int key = named_key(place, action);
        if (!never_waits_) return act_on_key(key, action, mods);
        if (const auto name = key_name(key, mods); name && never_waits_(*name)) return act_on_key(key, action, mods);
        KeySymbol symbol = system_->symbol_of(code, (mods & GLFW_MOD_SHIFT) != 0);
        KeyStroke stroke;
        stroke.press = action != GLFW_RELEASE;
        stroke.state = modifier_bits(mods);
        stroke.keycode = system_->x_key_code(code);
        stroke.keysym = symbol.keysym;
        stroke.name = std::move(symbol.name);
        gate_.take({key, action, mods}, stroke, glfwGetTime());
    }

    void take_decided_keys() {
        for (const KeyGate::Passed& passed : gate_.decided(glfwGetTime())) {
            if (!passed.ours) {
                keys_.other_input();
                continue;
            }
            act_on_key(passed.key.glfw_key, passed.key.glfw_action, passed.key.glfw_modifiers);
            if (!passed.text.empty()) events_.emplace_back(TextEvent{passed.text});
        }
    }

    // Adds typed text. The text arrives directly after its key, and goes to whoever received that key: the screen
    // reader or the program.
    void take_text(std::string text) {
        if (!gate_.take_text(text)) events_.emplace_back(TextEvent{std::move(text)});
    }

    void act_on_key(int key, int action, int mods) {
        for (KeyEvent& event : keys_.take(key, action, mods)) events_.emplace_back(std::move(event));
    }

    void take_focus(bool focused) {
        events_.emplace_back(FocusChange{focused});
        if (focused) return;
        gate_.clear();
        // GLFW also reports these releases later. The tracker then ignores them, because none of its keys is down any
        // more.
        for (KeyEvent& event : keys_.let_go()) events_.emplace_back(std::move(event));
    }

    // Adds a CloseRequest. Does nothing if the display is lost, because poll() reports that loss once.
    void take_close() {
        if (!system_->lost()) events_.emplace_back(CloseRequest{});
    }

    void take_cursor(double x, double y) {
        const Vec2 from = std::exchange(cursor_, Vec2(x, y)).value_or(Vec2(x, y));
        const double right_m = kHandMetresPerPixel * (x - from.x), away_m = kHandMetresPerPixel * (from.y - y);
        if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) move_hand({right_m, away_m, 0.0});
        else if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) move_hand({right_m, 0.0, away_m});
    }

    void take_wheel(double notches) {
        keys_.other_input();
        move_hand({0.0, 0.0, kHandMetresPerNotch * notches});
    }

    // Adds a movement of the hand. Consecutive movements become one event.
    void move_hand(const Vec3& by_m) {
        if (!events_.empty())
            if (auto* last = std::get_if<HandDragged>(&events_.back())) {
                last->by_m += by_m;
                return;
            }
        events_.emplace_back(HandDragged{by_m});
    }

    std::unique_ptr<WindowSystem> system_;
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<KeyWatch> watch_;
    std::unique_ptr<Renderer> renderer_;
    KeyTracker keys_;
    std::map<int, int> held_as_;  // for each held key: from its token by place to its token by label
    KeyGate gate_;
    std::function<bool(const std::string&)> never_waits_;  // empty: keys are not offered to a screen reader
    std::vector<WindowEvent> events_;
    // Position in the last motion event. GLFW itself would only return the present position, which may be newer than
    // the event.
    std::optional<Vec2> cursor_;
    std::optional<core::ViewState> shown_;  // the view that the window shows; none if it must be drawn again
    PixelSize shown_size_;
    std::string title_ = "Handrail";
    bool full_screen_ = false;
    WindowPlace windowed_;  // where the window was before it filled the screen
    int frames_in_size_ = 0;
    double rest_until_s_ = 0.0;  // no picture is drawn before this time on GLFW's clock
    bool loss_reported_ = false;
};

std::optional<WindowPlace> window_place(std::string_view text) {
    WindowPlace place;
    std::size_t at = 0;
    const auto take = [&](int& number, char after) {
        const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
        if (error != std::errc{}) return false;
        at = static_cast<std::size_t>(end - text.data());
        if (after == 0) return at == text.size();
        return at < text.size() && text[at++] == after;
    };
    if (!take(place.width, 'x') || !take(place.height, '+') || !take(place.x, '+') || !take(place.y, 0)) return {};
    constexpr int kMost = 1 << 20;
    if (place.width < 1 || place.height < 1 ||
        std::max({place.width, place.height, std::abs(place.x), std::abs(place.y)}) > kMost)
        return {};
    return place;
}

std::string window_place_text(const WindowPlace& place) {
    return fmt::format("{}x{}+{}+{}", place.width, place.height, place.x, place.y);
}

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Window::~Window() = default;

Result<std::unique_ptr<Window>> Window::open(const WindowOptions& options) {
    auto impl = std::make_unique<Impl>();
    if (auto opened = impl->open(options); !opened) return tl::unexpected(opened.error());
    return std::unique_ptr<Window>(new Window(std::move(impl)));
}

std::vector<WindowEvent> Window::poll() { return impl_->poll(); }
unsigned Window::number() const { return impl_->number(); }
bool Window::watch_keys(KeyWatchCalls calls) { return impl_->watch_keys(std::move(calls)); }
void Window::offer_keys(KeyReader reader, std::function<bool(const std::string&)> never_waits) {
    impl_->offer_keys(std::move(reader), std::move(never_waits));
}
std::string Window::place() const { return impl_->place(); }
void Window::draw(const core::ViewState& view) { impl_->draw(view); }
Picture Window::picture(const core::ViewState& view) { return impl_->picture(view); }

}  // namespace handrail::window
