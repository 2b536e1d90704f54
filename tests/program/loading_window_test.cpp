// Tests the program's real window on a virtual display while a world is being read. The person must be able to leave
// without waiting for the world.
#include <X11/Xlib.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <future>

#include "tests/program/endless_world.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/virtual_display.h"

namespace handrail::test {
namespace loading_window_test {

namespace fs = std::filesystem;

class LoadingWindow : public testing::Test {
protected:
    void SetUp() override {
        display_ = VirtualDisplay::start();
        if (!display_) GTEST_SKIP() << "Xvfb or xdotool is not installed";
        endless_ = folder_.write("endless.obj", endless_obj());
        fs::copy_file(test::bundled_world("first_room.map"), folder_.path() / "first_room.map");
    }

    // If a test fails while the program is running, closing the display ends the program.
    void TearDown() override { display_.reset(); }

    void start(const fs::path& world) {
        ProgramCall call;
        call.program = "/bin/sh";
        call.arguments = {"-c",
                          R"(said=$1; shift; exec "$@" >"$said" 2>&1)",
                          "sh",
                          said_file().string(),
                          test::built_program("handrail"),
                          "--device",
                          "none",
                          world.string()};
        call.environment["DISPLAY"] = ::getenv("DISPLAY");
        call.environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
        call.environment["HANDRAIL_WORLDS"] = folder_.path().string();
        call.environment["ASAN_OPTIONS"] = "detect_leaks=0";  // Mesa leaks memory, which the sanitizer would report
        run_ = std::async(std::launch::async, [call] { return run_program(call); });
        ASSERT_TRUE(eventually([&] {
            return display_->xdotool("search --onlyvisible --name Handrail windowfocus --sync >/dev/null 2>&1");
        })) << said();
    }
    void press(const std::string& key) { ASSERT_TRUE(display_->xdotool("key " + key)) << key; }
    fs::path said_file() const { return folder_.path() / "said"; }
    std::string said() const {
        std::ifstream file(said_file());
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool says(const std::string& words) {
        return eventually([&] { return said().find(words) != std::string::npos; });
    }
    void expect_it_ends() {
        ASSERT_EQ(run_.wait_for(std::chrono::duration<double>(kPatience_s)), std::future_status::ready) << said();
        EXPECT_EQ(run_.get().exit_status, 0) << said();
        EXPECT_EQ(said().find("say: Endless. "), std::string::npos) << "it was never entered";
    }

    TemporaryFolder folder_;
    std::unique_ptr<VirtualDisplay> display_;
    fs::path endless_;
    std::future<ProgramRun> run_;
};

// Closes the window in the same way as the close button of a desktop.
bool close_window() {
    Display* display = XOpenDisplay(nullptr);
    if (!display) return false;
    ::Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    bool found = false;
    if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count))
        for (unsigned i = 0; i < count; ++i) {
            char* name = nullptr;
            if (!XFetchName(display, children[i], &name) || !name) continue;
            if (std::string(name) == "Handrail") {
                XEvent event{};
                event.xclient.type = ClientMessage;
                event.xclient.window = children[i];
                event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
                event.xclient.format = 32;
                event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
                found = XSendEvent(display, children[i], False, NoEventMask, &event) != 0;
            }
            XFree(name);
        }
    if (children) XFree(children);
    XCloseDisplay(display);
    return found;
}

TEST_F(LoadingWindow, escape_ends_the_program_during_the_loading_of_its_first_world) {
    start(endless_);
    press("Escape");
    expect_it_ends();
}

TEST_F(LoadingWindow, closing_it_ends_the_program_during_the_loading_of_its_first_world) {
    start(endless_);
    ASSERT_TRUE(close_window());
    expect_it_ends();
}

TEST_F(LoadingWindow, escape_cancels_the_loading_of_a_second_world_and_the_first_continues) {
    start(folder_.path() / "first_room.map");
    ASSERT_TRUE(says("facing north")) << said();
    press("Tab");
    ASSERT_TRUE(says("Menu")) << said();
    press("w");
    ASSERT_TRUE(says("Worlds")) << said();
    press("Return");
    ASSERT_TRUE(says("visited before")) << said();
    press("e");
    ASSERT_TRUE(says("Endless, comes with Handrail")) << said();
    press("Return");
    ASSERT_TRUE(says("Going to Endless.")) << said();
    press("Escape");
    ASSERT_TRUE(says("Reading Endless was stopped. You stay in First room.")) << said();
    press("c");
    ASSERT_TRUE(says("Facing north")) << said();
    press("Escape");
    ASSERT_TRUE(says("Press Escape again")) << said();
    press("Escape");
    expect_it_ends();
}

}  // namespace loading_window_test
}  // namespace handrail::test
