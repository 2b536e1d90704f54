// Runs the program in a Wayland session without X11. It must use its window if GLFW supports Wayland; otherwise it must
// use the terminal.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/wayland_session.h"

namespace handrail::test {
namespace wayland_test {

using testing::HasSubstr;
using testing::Not;

TEST(WithoutWayland, the_program_reports_what_is_missing_and_continues_in_the_terminal) {
    const TemporaryFolder nobody_listens_here;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"--device", "none"};
    call.environment["WAYLAND_DISPLAY"] = "wayland-0";
    call.environment["XDG_RUNTIME_DIR"] = nobody_listens_here.path().string();
    call.input = "where\nquit\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    if (std::string(glfwGetVersionString()).find("Wayland") == std::string::npos)
        EXPECT_THAT(run.out, HasSubstr("This is a Wayland session, but the installed GLFW library supports only X11"));
    else EXPECT_THAT(run.out, HasSubstr("There is no display, so no picture is shown"));
    EXPECT_THAT(run.out, HasSubstr("facing north"));
    EXPECT_THAT(run.out, HasSubstr("Ahead: "));
}

class ProgramOnWayland : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string reason = why_no_wayland(glfwGetVersionString()); !reason.empty())
            GTEST_SKIP() << "The program cannot be tried on Wayland: " << reason;
        session_ = WaylandSession::start();
        ASSERT_TRUE(session_);
        Environment environment = bare_environment(home_.path().string());
        environment["WAYLAND_DISPLAY"] = std::getenv("WAYLAND_DISPLAY");
        environment["ASAN_OPTIONS"] = "detect_leaks=0";  // Mesa leaks memory, which the sanitizer would report
        program_ = ChildProcess::start({test::built_program("handrail")}, environment, home_.path() / "said");
        ASSERT_TRUE(program_);
        ASSERT_TRUE(says("facing north")) << said();
    }
    std::string said() const { return content_of(home_.path() / "said"); }
    bool says(const std::string& words) {
        return eventually([&] { return said().find(words) != std::string::npos; });
    }
    // Presses `key` until the program says `words`. One press may not suffice, because the window receives the keyboard
    // focus a moment after the first announcement.
    bool answers(const std::string& key, const std::string& words) {
        return eventually([&] {
            return session_->xdotool("key " + key) &&
                   eventually([&] { return said().find(words) != std::string::npos; }, 2.0);
        });
    }

    TemporaryFolder home_;
    std::unique_ptr<WaylandSession> session_;
    std::unique_ptr<ChildProcess> program_;
};

TEST_F(ProgramOnWayland, speaks_walks_stops_the_force_and_quits_by_keys) {
    ASSERT_TRUE(answers("F2", "First room")) << said();
    ASSERT_TRUE(session_->xdotool("keydown Up"));
    EXPECT_TRUE(says("North wall, plaster")) << said();
    ASSERT_TRUE(session_->xdotool("keyup Up"));
    ASSERT_TRUE(session_->xdotool("key F12"));
    EXPECT_TRUE(says("alert: ")) << said();
    ASSERT_TRUE(session_->take_keyboard_away());
    ASSERT_TRUE(session_->xdotool("key F4"));
    ASSERT_TRUE(session_->give_keyboard());
    ASSERT_TRUE(session_->xdotool("key c"));
    EXPECT_TRUE(says("Facing north")) << said();
    EXPECT_THAT(said(), Not(HasSubstr("Walk: the workspace turns with you"))) << "a key for another program";
    ASSERT_TRUE(session_->xdotool("key Escape"));
    ASSERT_TRUE(says("Press Escape again")) << said();
    ASSERT_TRUE(session_->xdotool("key Escape"));
    EXPECT_EQ(program_->exit_status(), 0) << said();
    for (const char* complaint : {"ALSOFT", "ALSA", "pw.", "pipewire", "GLFW", "libEGL", "MESA"})
        EXPECT_THAT(said(), Not(HasSubstr(complaint)));
}

TEST_F(ProgramOnWayland, exits_cleanly_when_its_compositor_ends) {
    ASSERT_TRUE(answers("F2", "First room")) << said();
    session_->kill();
    EXPECT_EQ(program_->exit_status(), 0) << said();
}

}  // namespace wayland_test
}  // namespace handrail::test
