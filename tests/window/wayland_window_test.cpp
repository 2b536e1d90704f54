// Tests the window on Wayland, without any X display.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <thread>

#include "app/window/window.h"
#include "tests/support/names.h"
#include "tests/support/wayland_session.h"
#include "tests/window/small_room.h"

namespace handrail::test {
namespace wayland_window_test {

class WaylandWindow : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string reason = why_no_wayland(glfwGetVersionString()); !reason.empty())
            GTEST_SKIP() << "No window can be tried on Wayland: " << reason;
        session_ = WaylandSession::start();
        ASSERT_TRUE(session_);
        auto opened = Window::open();
        ASSERT_TRUE(opened.has_value()) << opened.error().sentence();
        window_ = std::move(*opened);
        // Draw a picture first, because Wayland shows a window only after its first picture.
        ASSERT_TRUE(wait_for([&] { return has_focus() == true; }));
        events_.clear();
    }
    void TearDown() override { window_.reset(); }

    template <class Condition>
    bool wait_for(Condition condition) {
        return eventually([&] {
            for (WindowEvent& event : window_->poll()) events_.push_back(std::move(event));
            window_->draw(view_in(small_room(), 3.5, 1.0, 0.0));
            return condition();
        });
    }
    // Returns the latest focus event; empty if there was none.
    std::optional<bool> has_focus() const {
        std::optional<bool> focused;
        for (const WindowEvent& event : events_)
            if (const auto* change = std::get_if<FocusChange>(&event)) focused = change->focused;
        return focused;
    }
    // Returns the names of pressed keys, and those of released keys with a minus in front.
    std::vector<std::string> keys() const {
        std::vector<std::string> names;
        for (const WindowEvent& event : events_)
            if (const auto* key = std::get_if<KeyEvent>(&event); key && key->action != KeyAction::Repeat)
                names.push_back((key->action == KeyAction::Press ? "" : "-") + key->key);
        return names;
    }
    std::string text() const {
        std::string all;
        for (const WindowEvent& event : events_)
            if (const auto* typed = std::get_if<TextEvent>(&event)) all += typed->utf8;
        return all;
    }
    std::size_t close_requests() const {
        return static_cast<std::size_t>(std::count_if(events_.begin(), events_.end(), [](const WindowEvent& event) {
            return std::holds_alternative<CloseRequest>(event);
        }));
    }

    std::unique_ptr<WaylandSession> session_;
    std::unique_ptr<Window> window_;
    std::vector<WindowEvent> events_;
};

TEST_F(WaylandWindow, reads_keys_by_name_and_the_text_of_shifted_ones) {
    ASSERT_TRUE(session_->xdotool("key Up F2 Control_L shift+Left shift+1"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty() && keys().back() == "-Shift+1"; }));
    EXPECT_EQ(keys(), (std::vector<std::string>{"Up", "-Up", "F2", "-F2", "Control", "-Control", "Shift+Left",
                                                "-Shift+Left", "Shift+1", "-Shift+1"}));
    EXPECT_EQ(text(), "!");
    EXPECT_EQ(window_->number(), 0U) << "Wayland has no numbers for windows";
}

TEST_F(WaylandWindow, releases_held_keys_when_the_keyboard_is_lost_and_reports_its_return) {
    ASSERT_TRUE(session_->xdotool("keydown Up"));
    ASSERT_TRUE(wait_for([&] { return !keys().empty(); }));
    ASSERT_TRUE(session_->take_keyboard_away());
    ASSERT_TRUE(wait_for([&] { return has_focus() == false; }));
    EXPECT_EQ(keys().back(), "-Up");
    ASSERT_TRUE(session_->xdotool("keyup Up"));
    ASSERT_TRUE(session_->give_keyboard());
    EXPECT_TRUE(wait_for([&] { return has_focus() == true; }));
}

// This test never polls the window, but the calls must still be made.
TEST_F(WaylandWindow, reports_a_watched_key_and_the_loss_of_the_keyboard_without_polling) {
    std::atomic<int> stops{0}, others{0};
    std::atomic<bool> focused{true};
    ASSERT_TRUE(
        window_->watch_keys({[&](const std::string& key) { return ++others, key == "F12" || key == "Shift+Escape"; },
                             [&] { ++stops; }, [&](bool now) { focused = now; }}));
    ASSERT_TRUE(session_->xdotool("key F11 Escape Control_L F12"));
    EXPECT_TRUE(eventually([&] { return stops == 1; }));
    EXPECT_EQ(others, 3) << "a modifier alone is no key";
    ASSERT_TRUE(session_->xdotool("key shift+Escape"));
    EXPECT_TRUE(eventually([&] { return stops == 2; }));
    ASSERT_TRUE(session_->take_keyboard_away());
    EXPECT_TRUE(eventually([&] { return !focused; }));
    ASSERT_TRUE(session_->give_keyboard());
    EXPECT_TRUE(eventually([&] { return focused.load(); }));
    // poll() must still return all events of the window.
    EXPECT_TRUE(wait_for([&] { return has_focus() == true && keys().size() >= 8; }));
    const auto all = keys();
    EXPECT_EQ(std::count(all.begin(), all.end(), "F12"), 1);
}

TEST_F(WaylandWindow, offers_keys_to_a_screen_reader_under_their_x11_names) {
    std::vector<KeyStroke> offered;
    window_->offer_keys({[&](const KeyStroke& stroke) { return offered.push_back(stroke), std::uint64_t{1}; },
                         [](std::uint64_t) { return KeyVerdict::Ours; }},
                        [](const std::string& key) { return key == "F12"; });
    ASSERT_TRUE(session_->xdotool("key F12 shift+1 Return"));
    ASSERT_TRUE(wait_for([&] { return !offered.empty() && offered.back().name == "Return" && !offered.back().press; }));
    const auto one = std::find_if(offered.begin(), offered.end(), [](const KeyStroke& s) { return s.keycode == 10; });
    ASSERT_NE(one, offered.end());
    EXPECT_EQ(one->name, "exclam");
    EXPECT_EQ(one->keysym, 0x21U);
    EXPECT_EQ(one->state, 1U);
    for (const KeyStroke& stroke : offered) EXPECT_NE(stroke.name, "F12") << "the stop key waits for nobody";
}

TEST_F(WaylandWindow, survives_the_end_of_its_compositor_and_requests_closing_once) {
    ASSERT_TRUE(window_->watch_keys({[](const std::string&) { return true; }, [] {}, [](bool) {}}));
    session_->kill();
    ASSERT_TRUE(wait_for([&] { return close_requests() > 0; }));
    for (int i = 0; i < 10; ++i)
        for (WindowEvent& event : window_->poll()) events_.push_back(std::move(event));
    EXPECT_EQ(close_requests(), 1U);
    window_.reset();
}

}  // namespace wayland_window_test
}  // namespace handrail::test
