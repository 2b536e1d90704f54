#include "app/window/window.h"
#include "tests/support/child_process.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <atomic>
#include <chrono>
#include <cstdlib>

#include "app/window/window_layout.h"
#include "tests/support/names.h"
#include "tests/support/virtual_display.h"
#include "tests/window/small_room.h"

namespace handrail {

void PrintTo(const KeyEvent& event, std::ostream* out) {
    *out << event.key
         << (event.action == KeyAction::Press    ? " down"
             : event.action == KeyAction::Repeat ? " again"
                                                 : " up");
}

}  // namespace handrail

namespace handrail::test {
namespace window_test {

TEST(WindowOpen, reports_a_missing_display) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const auto window = Window::open();
    ASSERT_FALSE(window.has_value());
    EXPECT_TRUE(window.error().message.starts_with("There is no display, so no picture is shown"))
        << window.error().message;
}

TEST(WindowOpen, reports_a_display_that_does_not_answer_and_can_be_retried) {
    ::setenv("DISPLAY", ":65000", 1);
    for (int attempt = 0; attempt < 2; ++attempt) {
        const auto window = Window::open();
        ASSERT_FALSE(window.has_value());
        EXPECT_TRUE(window.error().message.starts_with("There is no display, so no picture is shown"))
            << window.error().message;
    }
}

class WindowTest : public ::testing::Test {
protected:
    void SetUp() override {
        display_ = VirtualDisplay::start();
        if (!display_) GTEST_SKIP() << "Xvfb or xdotool is not installed, so no window can be tried";
        if (!layout().empty() && !display_->run("setxkbmap " + layout())) GTEST_SKIP() << "setxkbmap is not installed";
        auto opened = Window::open();
        ASSERT_TRUE(opened.has_value()) << opened.error().sentence();
        window_ = std::move(*opened);
        // There is no window manager, so the test must give the window the keyboard focus.
        ASSERT_TRUE(display_->xdotool("search --sync --onlyvisible --name '^Handrail$' windowfocus --sync"));
        window_->poll();
    }

    virtual std::string layout() const { return {}; }

    // Collects events until the condition is true.
    template <class Condition>
    bool wait_for(Condition condition) {
        return eventually([&] {
            for (WindowEvent& event : window_->poll()) events_.push_back(std::move(event));
            return condition();
        });
    }

    std::vector<KeyEvent> keys() const {
        std::vector<KeyEvent> keys;
        for (const WindowEvent& event : events_)
            if (const auto* key = std::get_if<KeyEvent>(&event)) keys.push_back(*key);
        return keys;
    }

    template <class T>
    std::size_t count() const {
        return static_cast<std::size_t>(std::count_if(
            events_.begin(), events_.end(), [](const WindowEvent& e) { return std::holds_alternative<T>(e); }));
    }

    Vec3 hand_motion_m() const {
        Vec3 sum(0.0);
        for (const WindowEvent& event : events_)
            if (const auto* motion = std::get_if<HandDragged>(&event)) sum += motion->by_m;
        return sum;
    }

    std::unique_ptr<VirtualDisplay> display_;
    std::unique_ptr<Window> window_;
    std::vector<WindowEvent> events_;
};

// A second client of the X server, which sees the screen and acts like a desktop.
class Desktop {
public:
    Desktop() : display_(XOpenDisplay(nullptr)) {
        ::Window root = 0, parent = 0, *children = nullptr;
        unsigned count = 0;
        if (!display_ || !XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count)) return;
        for (unsigned i = 0; i < count; ++i) {
            char* name = nullptr;
            if (XFetchName(display_, children[i], &name) && name && std::string(name) == "Handrail")
                handrail_ = children[i];
            if (name) XFree(name);
        }
        if (children) XFree(children);
    }
    ~Desktop() {
        if (display_) XCloseDisplay(display_);
    }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    bool found() const { return handrail_ != 0; }

    void press_close_button() {
        XClientMessageEvent message{};
        message.type = ClientMessage;
        message.window = handrail_;
        message.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
        message.format = 32;
        message.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
        XEvent event{};
        event.xclient = message;
        XSendEvent(display_, handrail_, False, NoEventMask, &event);
        XFlush(display_);
    }

    void take_keyboard_away() {
        XSetInputFocus(display_, None, RevertToNone, CurrentTime);
        XSync(display_, False);
    }

    Picture what_stands_on_the_screen() {
        XWindowAttributes size{};
        XGetWindowAttributes(display_, handrail_, &size);
        XImage* image = XGetImage(display_, handrail_, 0, 0, static_cast<unsigned>(size.width),
                                  static_cast<unsigned>(size.height), AllPlanes, ZPixmap);
        Picture picture{size.width, size.height, {}};
        for (int y = 0; image && y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const unsigned long rgb = XGetPixel(image, x, y);
                for (const int shift : {16, 8, 0}) picture.rgb.push_back(static_cast<std::uint8_t>(rgb >> shift));
            }
        if (image) XDestroyImage(image);
        return picture;
    }

    // Sets the scale of the desktop for programs that start afterwards, as the settings of a desktop do.
    void set_scale(int percent) {
        const std::string resources = "Xft.dpi:\t" + std::to_string(96 * percent / 100) + "\n";
        XChangeProperty(display_, DefaultRootWindow(display_), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
        XSync(display_, False);
    }

    void resize(unsigned width, unsigned height) {
        XResizeWindow(display_, handrail_, width, height);
        XSync(display_, False);
    }

private:
    Display* display_ = nullptr;
    ::Window handrail_ = 0;
};

KeyEvent press(const char* key) { return {key, KeyAction::Press}; }
KeyEvent release(const char* key) { return {key, KeyAction::Release}; }

TEST_F(WindowTest, reads_keys_by_their_names) {
    ASSERT_TRUE(display_->xdotool("key Up F2 Prior f grave Escape Control_L shift+Left"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty() && keys().back() == release("Shift+Left"); }));
    EXPECT_EQ(keys(), (std::vector<KeyEvent>{press("Up"), release("Up"), press("F2"), release("F2"), press("PageUp"),
                                             release("PageUp"), press("F"), release("F"), press("Grave"),
                                             release("Grave"), press("Escape"), release("Escape"), press("Control"),
                                             release("Control"), press("Shift+Left"), release("Shift+Left")}));
}

TEST_F(WindowTest, distinguishes_key_repeats_from_presses_and_control_combinations_from_control_alone) {
    ASSERT_TRUE(display_->xdotool("keydown Up"));
    ASSERT_TRUE(wait_for([&] { return keys().size() >= 3; })) << "the server repeats after 0.66 s";
    ASSERT_TRUE(display_->xdotool("keyup Up key ctrl+c"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty() && keys().back() == release("Control+C"); }));
    const auto all = keys();
    EXPECT_EQ(all.front(), press("Up"));
    EXPECT_EQ(all[1], (KeyEvent{"Up", KeyAction::Repeat}));
    EXPECT_EQ(std::count(all.begin(), all.end(), press("Up")), 1);
    EXPECT_EQ(std::count(all.begin(), all.end(), release("Up")), 1);
    EXPECT_EQ(std::count(all.begin(), all.end(), press("Control")), 0);
}

TEST_F(WindowTest, survives_keys_without_a_name) {
    ASSERT_TRUE(display_->xdotool("key U263A Super_L F2"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty() && keys().back() == release("F2"); }));
    EXPECT_EQ(keys(), (std::vector<KeyEvent>{press("F2"), release("F2")}));
}

TEST_F(WindowTest, moves_the_simulated_hand_with_the_mouse) {
    ASSERT_TRUE(display_->xdotool("mousemove 400 400 mousedown 1 mousemove 500 350 mouseup 1 mousemove 600 600"));
    ASSERT_TRUE(wait_for([&] { return glm::length(hand_motion_m()) > 0.02; }));
    EXPECT_NEAR(hand_motion_m().x, 100 * kHandMetresPerPixel, 1e-9);
    EXPECT_NEAR(hand_motion_m().y, 50 * kHandMetresPerPixel, 1e-9);
    EXPECT_EQ(hand_motion_m().z, 0.0);
    events_.clear();
    ASSERT_TRUE(display_->xdotool("mousedown 3 mousemove 590 500 mouseup 3 click 4 click 4 click 5"));
    ASSERT_TRUE(wait_for([&] {
        return hand_motion_m().z > 100 * kHandMetresPerPixel + 0.5 * kHandMetresPerNotch && hand_motion_m().x < 0.0;
    }));
    EXPECT_NEAR(hand_motion_m().x, -10 * kHandMetresPerPixel, 1e-9);
    EXPECT_EQ(hand_motion_m().y, 0.0);
}

TEST_F(WindowTest, requests_closing_and_stays_open_until_it_is_released) {
    Desktop desktop;
    ASSERT_TRUE(desktop.found());
    desktop.press_close_button();
    ASSERT_TRUE(wait_for([&] { return count<CloseRequest>() == 1; }));
    window_->draw(view_in(small_room(), 3.5, 1.0, 0.0));
    EXPECT_TRUE(Desktop().found());
    window_.reset();
    EXPECT_FALSE(Desktop().found());
}

TEST_F(WindowTest, releases_held_keys_when_the_focus_is_lost_and_reports_its_return) {
    ASSERT_TRUE(display_->xdotool("keydown Up"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty(); }));
    Desktop().take_keyboard_away();
    ASSERT_TRUE(wait_for([&] { return count<FocusChange>() == 1 && keys().back() == release("Up"); }));
    const auto lost = std::find_if(events_.begin(), events_.end(),
                                   [](const WindowEvent& e) { return std::holds_alternative<FocusChange>(e); });
    EXPECT_FALSE(std::get<FocusChange>(*lost).focused);
    EXPECT_TRUE(std::holds_alternative<KeyEvent>(events_.back())) << "releases come after the news";
    ASSERT_TRUE(display_->xdotool("keyup Up search --name '^Handrail$' windowfocus --sync"));
    ASSERT_TRUE(wait_for([&] { return count<FocusChange>() == 2; }));
}

// This test never polls the window, but the calls must still be made.
TEST_F(WindowTest, reports_a_watched_key_and_the_loss_of_the_keyboard_without_polling) {
    std::atomic<int> stops{0}, others{0};
    std::atomic<bool> focused{true};
    ASSERT_TRUE(
        window_->watch_keys({[&](const std::string& key) { return ++others, key == "F12" || key == "Shift+Escape"; },
                             [&] { ++stops; }, [&](bool now) { focused = now; }}));
    ASSERT_TRUE(display_->xdotool("key F11 Escape Control_L F12"));
    EXPECT_TRUE(eventually([&] { return stops == 1; }));
    EXPECT_EQ(others, 3) << "a modifier alone is no key";
    ASSERT_TRUE(display_->xdotool("key shift+Escape"));
    EXPECT_TRUE(eventually([&] { return stops == 2; }));
    Desktop().take_keyboard_away();
    EXPECT_TRUE(eventually([&] { return !focused; }));
    ASSERT_TRUE(display_->xdotool("search --name '^Handrail$' windowfocus --sync"));
    EXPECT_TRUE(eventually([&] { return focused.load(); }));
    // poll() must still return all events of the window.
    EXPECT_TRUE(wait_for([&] { return count<FocusChange>() == 2; }));
    const auto all = keys();
    EXPECT_EQ(std::count(all.begin(), all.end(), press("F12")), 1);
}

TEST_F(WindowTest, a_key_watch_survives_the_end_of_the_display) {
    ASSERT_TRUE(window_->watch_keys({[](const std::string&) { return true; }, [] {}, [](bool) {}}));
    display_->kill();
    ASSERT_TRUE(wait_for([&] { return count<CloseRequest>() == 1; }));
    window_.reset();
}

TEST_F(WindowTest, shows_the_drawn_picture_and_follows_its_size) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.texts.messages = {"North wall, plaster."};
    view.show_hand = true;
    view.proxy_m = {3.6, 2.0, 1.4};
    Desktop desktop;
    ASSERT_TRUE(desktop.found());
    const auto shown = [&](const ViewState& wanted) {
        // Draw repeatedly, because a frame needs a moment to reach the screen.
        return wait_for([&] {
            window_->draw(wanted);
            const Picture screen = desktop.what_stands_on_the_screen();
            return screen.rgb == window_->picture(wanted).rgb && !screen.rgb.empty();
        });
    };
    EXPECT_TRUE(shown(view));
    const Picture first = desktop.what_stands_on_the_screen();
    EXPECT_EQ(first.width, 1024) << "as wide as the screen";
    view.touching = true;
    view.texts.messages = {"East wall, brick."};
    EXPECT_TRUE(shown(view));
    EXPECT_NE(desktop.what_stands_on_the_screen().rgb, first.rgb);
    view.pictures = Pictures::Plan;
    EXPECT_TRUE(shown(view));
    const Picture plan = desktop.what_stands_on_the_screen();
    EXPECT_TRUE(shown(two_rooms_on_the_plan()));
    EXPECT_NE(desktop.what_stands_on_the_screen().rgb, plan.rgb);
    desktop.resize(600, 500);
    EXPECT_TRUE(shown(view));
    EXPECT_EQ(desktop.what_stands_on_the_screen().width, 600);
}

TEST_F(WindowTest, has_the_title_of_the_view) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.texts.title = "School, Routes – Handrail";
    window_->draw(view);
    EXPECT_TRUE(display_->xdotool("search --sync --onlyvisible --name '^School, Routes – Handrail$'"));
}

TEST_F(WindowTest, fills_the_screen_and_returns_to_where_it_was) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    Desktop desktop;
    ASSERT_TRUE(desktop.found());
    EXPECT_EQ(window_->place(), "1024x768+0+0") << "without a wanted place, it is as large as the screen";
    ASSERT_TRUE(display_->xdotool("search --onlyvisible --name '^Handrail$' windowsize 700 500 windowmove 30 40"));
    const auto has_place = [&](const std::string& place) {
        return wait_for([&] {
            window_->draw(view);
            return window_->place() == place;
        });
    };
    EXPECT_TRUE(has_place("700x500+30+40")) << window_->place();
    const auto has_width = [&](int width) {
        return wait_for([&] {
            window_->draw(view);
            return window_->picture(view).width == width;
        });
    };
    view.display.full_screen = true;
    EXPECT_TRUE(has_width(1024));
    EXPECT_EQ(window_->place(), "") << "a window that fills the screen has no place to remember";
    view.display.full_screen = false;
    EXPECT_TRUE(has_width(700));
    EXPECT_TRUE(has_place("700x500+30+40")) << window_->place();
    // It opens there again. A place that is not on the screen is ignored.
    for (const auto& [wanted, place] :
         {std::pair("700x500+30+40", "700x500+30+40"), std::pair("700x500+900+40", "1024x768+0+0")}) {
        window_.reset();
        auto opened = Window::open({.place = window_place(wanted)});
        ASSERT_TRUE(opened) << opened.error().sentence();
        window_ = std::move(*opened);
        EXPECT_TRUE(has_place(place)) << window_->place();
    }
}

// A place is in pixels, as the window reports it. Scaling it again would make the window grow each time it is opened.
TEST_F(WindowTest, opens_in_its_place_on_a_desktop_with_any_scale_and_fills_the_same_part_with_text) {
    const ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    const auto picture_in_place = [&](const char* place) {
        window_.reset();
        auto opened = Window::open({.place = window_place(place)});
        EXPECT_TRUE(opened) << opened.error().sentence();
        window_ = std::move(*opened);
        EXPECT_TRUE(wait_for([&] {
            window_->draw(view);
            return window_->place() == place;
        })) << window_->place();
        return window_->picture(view);
    };
    Desktop desktop;
    ASSERT_TRUE(desktop.found());
    const Picture usual = picture_in_place("400x300+30+40");
    desktop.set_scale(200);
    const Picture scaled = picture_in_place("400x300+30+40");
    EXPECT_EQ(scaled.width, 400);
    EXPECT_EQ(scaled.rgb, usual.rgb);
}

TEST_F(WindowTest, changes_its_picture_at_most_twice_a_second_with_reduced_motion) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.display.reduced_motion = true;
    Desktop desktop;
    ASSERT_TRUE(desktop.found());
    const auto begin = std::chrono::steady_clock::now();
    int pictures = 0;
    Picture last;
    // Draws until four different pictures were on the screen. The three pauses between them take more than a second.
    EXPECT_TRUE(wait_for([&] {
        view.heading_rad += 0.01;
        window_->draw(view);
        if (Picture screen = desktop.what_stands_on_the_screen(); screen.rgb != last.rgb) {
            last = std::move(screen);
            ++pictures;
        }
        return pictures >= 4;
    }));
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST_F(WindowTest, shows_an_open_list_in_black_and_white) {
    ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    view.texts.messages = {"Menu. What you can do, 1 of 3"};
    view.dialogue.kind = DialogueView::Kind::List;
    view.dialogue.title = "Menu";
    view.dialogue.items = {{"What you can do", "", false}, {"Worlds", "", false}, {"Settings", "", false}};
    Desktop desktop;
    ASSERT_TRUE(desktop.found());
    Picture screen;
    const auto shown = [&] {
        return wait_for([&] {
            window_->draw(view);
            screen = desktop.what_stands_on_the_screen();
            return screen.rgb == window_->picture(view).rgb && !screen.rgb.empty();
        });
    };
    EXPECT_TRUE(shown());
    const Picture first = screen;
    // To the right of the text, the bar of the chosen item must be as high as a line of text.
    int bar = 0;
    const WindowLayout layout = lay_out_window({screen.width, screen.height}, view.pictures, 1.0);
    const int bottom = static_cast<int>(layout.pictures.max_px.y);
    for (int y = 95; y < bottom; ++y) bar += screen.at(850, y)[0] > 250;
    EXPECT_EQ(bar, static_cast<int>(layout.line_px));
    view.dialogue.at = 1;
    EXPECT_TRUE(shown());
    EXPECT_NE(screen.rgb, first.rgb);
    view.dialogue = {};
    EXPECT_TRUE(shown());
    bool grey = false;  // true if the room is visible again
    for (int y = 95; y < bottom; ++y) grey |= screen.at(850, y)[0] > 40 && screen.at(850, y)[0] < 215;
    EXPECT_TRUE(grey);
}

TEST_F(WindowTest, survives_the_end_of_its_display_and_requests_closing) {
    const ViewState view = view_in(small_room(), 3.5, 1.0, 0.0);
    window_->draw(view);
    ASSERT_TRUE(display_->xdotool("keydown Up"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty(); }));
    display_->kill();
    ASSERT_TRUE(wait_for([&] { return count<CloseRequest>() == 1; }));
    EXPECT_EQ(keys().back(), release("Up"));
    ViewState other = view;
    other.touching = true;
    window_->draw(other);
    EXPECT_TRUE(window_->poll().empty()) << "told once";
    window_.reset();
}

class WindowOnALayout : public WindowTest, public ::testing::WithParamInterface<const char*> {
protected:
    std::string layout() const override { return GetParam(); }
};

// In an earlier version, letter keys acted by their place on an American keyboard, although help and documents name
// keys by their letters.
TEST_P(WindowOnALayout, reads_letters_by_their_key_labels_and_digits_by_their_place) {
    ASSERT_TRUE(display_->xdotool("key a q z y w m s F2"));
    ASSERT_TRUE(wait_for([&] { return keys().size() >= 16; }));
    std::vector<KeyEvent> wanted;
    for (const char* key : {"A", "Q", "Z", "Y", "W", "M", "S", "F2"})
        for (const KeyEvent& event : {press(key), release(key)}) wanted.push_back(event);
    EXPECT_EQ(keys(), wanted);
    events_.clear();
    ASSERT_TRUE(display_->run("xdotool key 10"));  // the code of the key to the left of the 2, whatever its label is
    ASSERT_TRUE(wait_for([&] { return keys().size() >= 2; }));
    EXPECT_EQ(keys().front(), press("1"));
}

INSTANTIATE_TEST_SUITE_P(Layouts, WindowOnALayout, ::testing::Values("fr", "de", "us -variant dvorak"));
}  // namespace window_test
}  // namespace handrail::test
