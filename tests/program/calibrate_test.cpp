// Runs `handrail calibrate` as a process. The tests type lines, compare the sentences that the program prints, and
// check the results in the settings.
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace calibrate_test {

using testing::HasSubstr;
using testing::Not;

class CalibrateProgram : public testing::Test {
protected:
    ProgramRun run(std::vector<std::string> arguments, const std::string& lines) {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = std::move(arguments);
        call.input = lines;
        call.environment["XDG_CONFIG_HOME"] = home_.path().string();
        return run_program(call);
    }
    std::string settings() { return run({"settings", "--explain"}, "").out; }
    static void expect_in_order(const std::string& text, std::initializer_list<const char*> wanted) {
        std::size_t from = 0;
        for (const char* words : wanted) {
            const std::size_t at = text.find(words, from);
            ASSERT_NE(at, std::string::npos) << "\"" << words << "\" is missing or not in its place:\n" << text;
            from = at;
        }
    }

    const TemporaryFolder home_;
};

constexpr const char* kSimulatedHand =
    "left\n\n"                                       // the bell is heard at both ears
    "hand-back 15\nhand-forward 30\nhand-left 12\n"  // the person pulls, pushes and moves to the left hand's side
    "wait 12\nbutton\n"                              // the force grows until the person feels it and presses the button
    "up\nhand-back 20\nhand-forward 20\nwait 1\n\n"  // the person chooses normal force and presses against the wall
    // The person moves to all sides of the workspace, accepts the scale and the rim, and types the length of a step.
    "hand-right 30\nhand-left 30\nhand-forward 30\nhand-back 30\n\n\n\n"
    "65\n";

TEST_F(CalibrateProgram, runs_from_start_to_end_with_a_simulated_touch) {
    const ProgramRun done = run({"calibrate", "--no-window", "--device", "sim-t"}, kSimulatedHand);
    EXPECT_EQ(done.exit_status, 0) << done.err;
    expect_in_order(done.out,
                    {"bell on your left", "The simulated Touch is ready.", "Take the grip in your hand", "Good.",
                     "Push the grip in", "Good.", "Left hand.", "I will press against your hand", "You felt it at",
                     "Now you will feel a wall", "Normal, 2.5 newtons.", "more than 2.5 newtons", "Your hand reaches",
                     "Your step is", "65 centimetres", "The set-up is complete."});
    const std::string stored = settings();
    EXPECT_THAT(stored, HasSubstr("profile.sim-t.ceiling_n = 2.5 newtons (0.5 to 40), from: your settings file"));
    EXPECT_THAT(stored, HasSubstr("profile.sim-t.hand = \"left\""));
    EXPECT_THAT(stored, HasSubstr("profile.sim-t.gentlest_n = "));
    EXPECT_THAT(stored, HasSubstr("profile.sim-t.width_m = 0.1"));
    EXPECT_THAT(stored, HasSubstr("walk.step_length_m = 0.65"));
}

TEST_F(CalibrateProgram, without_a_device_says_so_and_does_the_remaining_parts) {
    const ProgramRun done = run({"calibrate", "--no-window"}, "right\nleft\n\nrepeat\n0.8\n");
    EXPECT_EQ(done.exit_status, 0) << done.err;
    expect_in_order(done.out, {"bell on your left", "swapped", "on your right now?",
                               "There is no touch device. Everything works with keyboard and sound", "Your step is 70",
                               "Your step is 70", "80 centimetres", "The set-up is complete."});
    EXPECT_THAT(done.out, Not(HasSubstr("Take the grip")));
    EXPECT_THAT(settings(), HasSubstr("sound.swap_sides = true"));
    EXPECT_THAT(settings(), HasSubstr("walk.step_length_m = 0.8"));
}

TEST_F(CalibrateProgram, runs_single_parts_keeps_earlier_values_and_saves_what_was_done_before_an_early_end) {
    ASSERT_EQ(run({"calibrate", "--no-window", "--only", "step"}, "55\n").exit_status, 0);
    const ProgramRun parts =
        run({"calibrate", "--no-window", "--device", "sim-t", "--only", "hand,strongest"}, "left\n");
    EXPECT_EQ(parts.exit_status, 0) << parts.err;
    expect_in_order(parts.out, {"Which hand holds the grip?", "Left hand.", "Now you will feel a wall",
                                "Leaving the set-up. What you have set is kept."});
    EXPECT_THAT(settings(), HasSubstr("profile.sim-t.hand = \"left\""));
    EXPECT_THAT(settings(), Not(HasSubstr("profile.sim-t.ceiling_n")));
    EXPECT_THAT(settings(), HasSubstr("walk.step_length_m = 0.55"));
    const ProgramRun wrong = run({"calibrate", "--only", "headphone"}, "");
    EXPECT_EQ(wrong.exit_status, 2);
    EXPECT_THAT(wrong.err, HasSubstr("the nearest name is headphones"));
}

TEST_F(CalibrateProgram, the_same_wizard_runs_in_a_session_and_returns_to_the_world) {
    const ProgramRun done =
        run({"--no-window", "--device", "sim-t"}, "calibrate\n" + std::string(kSimulatedHand) + "where\nquit\n");
    EXPECT_EQ(done.exit_status, 0) << done.err;
    expect_in_order(done.out, {"First room,", "bell on your left", "The simulated Touch is ready.", "You felt it at",
                               "The set-up is complete.", "back in", "facing north"});
    EXPECT_THAT(settings(), HasSubstr("profile.sim-t.ceiling_n = 2.5"));
}

TEST_F(CalibrateProgram, a_damaged_profile_is_reported_at_the_start_and_stays_in_the_file) {
    std::filesystem::create_directories(home_.path() / "handrail");
    const auto file = home_.write("handrail/settings.toml", "[profile.sim-t]\nceiling_n = 900.0\nhand = \"left\"\n");
    const ProgramRun reported = run({"--no-window", "--device", "sim-t"}, "quit\n");
    EXPECT_EQ(reported.exit_status, 0) << reported.err;
    EXPECT_THAT(reported.out, HasSubstr("This profile is not used"));
    EXPECT_THAT(content_of(file), HasSubstr("ceiling_n = 900.0"));
    const ProgramRun anew = run({"calibrate", "--no-window", "--device", "sim-t", "--only", "strongest"}, "\n");
    EXPECT_EQ(anew.exit_status, 0) << anew.err;
    EXPECT_THAT(settings(), HasSubstr("profile.sim-t.ceiling_n = 1.2"));
}

}  // namespace calibrate_test
}  // namespace handrail::test
