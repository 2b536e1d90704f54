// Runs the first start as a process and types lines, from the welcome to the choice. Checks that the key words of each
// step occur in order. Another test runs a script that does not expect the welcome.
#include <chrono>
#include <fstream>
#include <memory>
#include <thread>

#include "app/core/dialogue/command.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times_in.h"

namespace handrail::test {
namespace first_minutes_test {

using testing::HasSubstr;
using testing::Not;

class FirstMinutes : public testing::Test {
protected:
    ProgramRun run(std::vector<std::string> arguments, const std::string& lines) {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = std::move(arguments);
        for (const char* more : {"--no-window", "--set", "speech.through=text"})
            call.arguments.emplace_back(more);  // text output takes no time
        call.input = lines;
        call.first_start = true;
        call.environment["XDG_CONFIG_HOME"] = home_.path().string();
        return run_program(call);
    }
    static void expect_in_order(const std::string& text, std::initializer_list<const char*> wanted) {
        std::size_t from = 0;
        for (const char* words : wanted) {
            const std::size_t at = text.find(words, from);
            ASSERT_NE(at, std::string::npos) << "\"" << words << "\" is missing or not in its place:\n" << text;
            from = at + 1;
        }
    }
    const TemporaryFolder home_;
};

TEST_F(FirstMinutes, run_from_welcome_to_choice_with_the_keyboard_alone_and_never_start_again) {
    const ProgramRun first = run(
        {"--device", "none"},
        "space\n\nleft\n\nforward 6\nleft 4\nforward 3\nright 8\nforward 7\nhome\nlist\nexplore freely\nwhere\nquit\n");
    EXPECT_EQ(first.exit_status, 0) << first.err;
    expect_in_order(first.out, {"say: Welcome. Handrail is speaking with text alone. Type an empty line to begin, "
                                "space to hear this again, or escape to leave.",
                                "say: Welcome. Handrail is speaking with text alone. Type an empty line to begin, "
                                "space to hear this again, or escape to leave.",
                                "First, set up your headphones.",
                                "bell on your left",
                                "The set-up is complete.",
                                "You are in a small room, six by four metres",
                                "Type forward to walk",
                                "then north wall, plaster",
                                "That is your first wall.",
                                "radiator",
                                "Radiator",
                                "Well done, you found it.",
                                "then east wall, wood",
                                "Corner.",
                                "Now go back to the door: type home.",
                                "handle on your right",
                                "What to do next.",
                                "Real buildings",
                                "Saved. Next time you will start here.",
                                "facing north"});
    const ProgramRun second = run({"--device", "none"}, "where\nquit\n");
    EXPECT_THAT(second.out, Not(HasSubstr("Welcome.")));
    EXPECT_THAT(second.out, HasSubstr("First room, 6 by 4 metres."));
}

// Simulates a person with the simulated Touch, who waits for announced words and then types. If the machine was too
// busy for steady forces, the person follows the announced instructions and repeats the step.
class FirstMinutesWithTouch : public FirstMinutes {
protected:
    struct Step {
        const char* words;  // the person types the lines after these words were announced
        std::string lines;
        // Lines that the person types if the force was switched off before the program announced the next step's words.
        // In the set-up, a short stall has no consequences. In a world, the hand sinks into a wall meanwhile.
        std::string again{};
        bool in_world = false;
    };
    enum class Outcome : std::uint8_t { Done, NeverSaid, TooBusy };

    void SetUp() override {
        test::Environment environment = bare_environment(home_.path().string());
        environment["XDG_CONFIG_HOME"] = (home_.path() / "nothing").string();
        program_ = ChildProcess::start(
            {test::built_program("handrail"), "--device", "sim-t", "--no-window", "--set", "speech.through=text"},
            environment, output_);
        ASSERT_TRUE(program_);
    }
    std::string said() const { return content_of(output_); }
    Outcome take(std::initializer_list<Step> steps) {
        constexpr std::size_t kBusyEnough = 6;  // greatest number of repetitions; a real person would give up sooner
        std::size_t from = 0, busy = 0, stopped = 0;
        const Step* last = steps.begin();
        for (const Step& step : steps) {
            std::size_t at = std::string::npos;
            for (const auto end = Clock::now() + std::chrono::duration<double>(kPatience_s); at == std::string::npos;
                 std::this_thread::sleep_for(std::chrono::milliseconds(10))) {
                const std::string text = said();
                if (at = text.find(step.words, from); at != std::string::npos) break;
                const std::size_t is_busy = times_in(text, "too busy for steady touch");
                const std::size_t has_stopped = times_in(text, "The computer stopped for a moment");
                if (is_busy + has_stopped >= kBusyEnough) return Outcome::TooBusy;
                if (std::exchange(busy, is_busy) < is_busy) program_->type("forces\n" + last->again);
                else if (stopped < has_stopped && last->in_world) program_->type(last->again);
                stopped = has_stopped;
                if (Clock::now() > end) {
                    ADD_FAILURE() << "\"" << step.words << "\" was not said:\n" << text;
                    return Outcome::NeverSaid;
                }
            }
            from = at + 1;
            last = &step;
            program_->type(step.lines);
        }
        return Outcome::Done;
    }

    const std::filesystem::path output_ = home_.path() / "told";
    std::unique_ptr<ChildProcess> program_;

private:
    using Clock = std::chrono::steady_clock;
};

// In the first minutes, the person sets the device up in the same steps as in the wizard: pull, push, move to the left
// hand's side, feel a force, press on a wall.
TEST_F(FirstMinutesWithTouch, run_through_the_setup_to_the_first_wall_and_the_choice) {
    const std::string to_wall = "hand-forward 30\nhand-forward 30\n";
    const std::string to_radiator = "hand-left 20\nhand-down 10\nhand-left 10\nhand-up 10\n";
    // Move the hand back here. Otherwise it would already touch a wall of the room when the room begins, and the
    // program would name that wall too early.
    const std::string push = "hand-back 20\nhand-forward 20\nwait 1\nhand-back 20\n\n";
    // Touch the things in this order, because otherwise a wall would be between the hand and the next thing.
    const std::string anew = "hand-centre\nhome\n";
    const Outcome outcome = take({
        {"Type an empty line to begin", "space\n\n"},
        {"bell on your left", "left\n"},
        {"Is the bell on your right now?", "\n"},
        {"Pull it all the way", "hand-back 15\n"},
        {"Push the grip in", "hand-forward 30\n"},
        {"Which hand holds the grip?", "hand-left 12\n"},
        {"I will press", "wait 3\nbutton\n", "wait 3\nbutton\n"},
        {"Now you will feel a wall", "up\n", "up\n"},
        {"Normal, 2.5 newtons.", push, "up\n" + push},
        {"Bring your hand to the middle", "hand-centre\n", anew, true},
        {"Reach forward slowly.", to_wall, anew + to_wall, true},
        {"Slide left along the wall", to_radiator, anew + to_wall + to_radiator, true},
        {"Now slide right along the wall", "hand-right 30\nhand-right 40\n", anew + to_wall + "hand-right 40\n", true},
        {"type home", "home\n", anew, true},
        {"What to do next.", "list\nexplore freely\nwhere\nquit\n"},
    });
    if (outcome == Outcome::TooBusy) GTEST_SKIP() << "this machine is too busy to give a servo its rate";
    ASSERT_EQ(outcome, Outcome::Done);
    EXPECT_EQ(program_->exit_status(), 0) << said();
    // These lines omit the names of touched things. On a busy machine, the hand may move on before a name is announced,
    // and the session then drops that name. scenarios/first_minutes_sim_t.toml checks the names in virtual time.
    expect_in_order(said(), {"say: Welcome. Handrail is speaking with text alone. Type an empty line to begin, "
                             "space to hear this again, or escape to leave.",
                             "say: Welcome. Handrail is speaking with text alone. Type an empty line to begin, "
                             "space to hear this again, or escape to leave.",
                             "First, set up your headphones and the device in your hand.",
                             "bell on your left",
                             "Is the bell on your right now?",
                             "The simulated Touch is ready.",
                             "Take the grip in your hand. Pull it all the way towards you.",
                             "Good.",
                             "Push the grip in",
                             "Good.",
                             "Left hand.",
                             "I will press against your hand, lightly",
                             "You felt it at",
                             "Now you will feel a wall",
                             "Nothing will push with more than 2.5 newtons.",
                             "The set-up is complete.",
                             "Bring your hand to the middle",
                             "You are in a small room, six by four metres",
                             "Reach forward slowly.",
                             "That is your first wall.",
                             "Slide left along the wall",
                             "Well done, you found it.",
                             "Now slide right along the wall",
                             "Corner.",
                             "Now go back to the door: type home.",
                             "handle on your right",
                             "What to do next.",
                             "Explore freely",
                             "Walk along the walls",
                             "Find the clock",
                             "Play the hunt game",
                             "Real buildings",
                             "Settings",
                             "Saved. Next time you will start here.",
                             "facing north"});
}

// The choice must start a real activity. In this test, the activity is a hunt in the practice room, and then a hunt in
// the house, which the program reads first.
TEST_F(FirstMinutes, end_in_a_hunt_if_the_person_chooses_it) {
    const char* const kToChoice = "\nleft\n\nforward 6\nleft 4\nforward 3\nright 8\nforward 7\nhome\n";
    const ProgramRun here = run({"--device", "none"}, std::string(kToChoice) + "find\nwhere\nquit\n");
    expect_in_order(here.out,
                    {"What to do next.", "Saved.", "A clock is hidden here. It ticks fast and calls like a cuckoo.",
                     "Room with Radiator", "facing north"});
    const TemporaryFolder other;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"--no-window", "--device", "none", "--set", "speech.through=text"};
    call.input = std::string(kToChoice) + "hunt\nwhere\nquit\n";
    call.first_start = true;
    call.environment["XDG_CONFIG_HOME"] = other.path().string();
    const ProgramRun house = run_program(call);
    expect_in_order(house.out, {"What to do next.", "Saved.", "Going to House.", "say: House",
                                "A clock is hidden here. It ticks fast and calls like a cuckoo."});
}

TEST_F(FirstMinutes, resume_at_the_next_start) {
    const ProgramRun first = run({"--device", "none"}, "\nleft\n\nforward 6\nquit\n");
    EXPECT_THAT(first.out, HasSubstr("That is your first wall."));
    const ProgramRun second = run({"--device", "none"}, "quit\n");
    expect_in_order(second.out, {"Welcome back.", "radiator"});
    EXPECT_THAT(second.out, Not(HasSubstr("bell on your left")));
}

TEST_F(FirstMinutes, yield_to_a_script_without_knowledge_of_them_and_to_the_end_of_input) {
    const ProgramRun script = run({"--device", "none"}, "forward 5\nwhere\nquit\n");
    expect_in_order(script.out, {"Welcome.", "First room,", "then north wall, plaster", "close by"});
    const TemporaryFolder other;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.first_start = true;
    call.environment["XDG_CONFIG_HOME"] = other.path().string();
    const ProgramRun nobody = run_program(call);
    EXPECT_EQ(nobody.exit_status, 0) << nobody.err;
    expect_in_order(nobody.out, {"Welcome.", "First room,", "facing north"});
}

// Every command in the table of commands must have an effect or an answer when a person types its word at the terminal.
TEST(Terminal, every_command_of_the_table_works_when_its_word_is_typed) {
    std::string lines;
    for (const CommandInfo& row : command_table())
        if (row.command != Command::Leave && row.command != Command::Calibrate &&
            row.command != Command::FirstMinutes && row.command != Command::InputHelp)
            lines += std::string(row.word) +
                     "\ncancel\n";  // cancel closes a list if the command opened one; otherwise cancel has no effect
    lines += "input-help\nforward\ninput-help\nwelcome\nescape\ncalibrate\nquit\nwher\nleave\nleave\n";
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"--no-window", "--device", "sim-t", "--set", "speech.through=text"};
    call.input = lines;
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    for (const CommandInfo& row : command_table())
        EXPECT_THAT(run.out, Not(HasSubstr(fmt::format("There is no command \"{}\"", row.word))));
    EXPECT_THAT(run.out, HasSubstr("Did you mean \"where\"?"));
    for (const char* words : {"Facing north", "Speech level 3", "Menu.", "Forces", "Walk: the workspace turns with you",
                              "Room, ", "5 steps or 3.5 metres", "3 east", "1 of ", "Input help on.",
                              "forward: Walk one step forward", "Welcome.", "bell on your left", "Goodbye."})
        EXPECT_THAT(run.out, HasSubstr(words));
}

TEST(Terminal, worlds_are_chosen_from_lists_and_a_damaged_one_changes_nothing) {
    const TemporaryFolder folder;
    folder.write("broken.map", "{ \"classname\" \"worldspawn\" ");
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"--no-window", "--device", "none"};
    call.environment["XDG_STATE_HOME"] = folder.path().string();
    call.input = "forward\nmenu\nworlds\nanother\n" + (folder.path() / "broken.map").string() +
                 "\nheading\nmenu\nworlds\nhouse\nwhere\nmenu\nworlds\nlist\nescape\nescape\nquit\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    std::size_t from = 0;
    for (const char* words : {"First room,", "Going to Broken.", "broken.map", "You stay in First room.",
                              "Facing north", "Going to House.", "say: House", "facing", "House, visited before"}) {
        const std::size_t at = run.out.find(words, from);
        ASSERT_NE(at, std::string::npos) << words << "\n" << run.out;
        from = at + 1;
    }
}

TEST(Terminal, a_damaged_list_of_recent_worlds_is_set_aside_and_reported) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "handrail");
    folder.write("handrail/recent-worlds.txt", "\xff\xff");
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"--no-window", "--device", "none"};
    call.environment["XDG_STATE_HOME"] = folder.path().string();
    const ProgramRun run = run_program(call);
    EXPECT_THAT(run.out, HasSubstr("The list of your recent worlds is damaged. It was saved as "
                                   "recent-worlds.txt.damaged, and a new list starts empty."));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "handrail" / "recent-worlds.txt.damaged"));
}

}  // namespace first_minutes_test
}  // namespace handrail::test
