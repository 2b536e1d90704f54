// Runs the program in a separate terminal, as a person uses it. Keys must act at once, and a colon must begin a typed
// command. However the program ends, it must restore the terminal.
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "tests/program/endless_world.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/pty_job.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace terminal_test {

// The program in a terminal. It runs until this object and its home folder are destroyed.
struct AtTerminal {
    TemporaryFolder home;
    std::unique_ptr<PtyJob> job;

    explicit AtTerminal(std::vector<std::string> arguments = {}, Environment more = {}) {
        Environment environment = bare_environment(home.path().string());
        environment["TERM"] = "xterm-256color";
        for (const auto& [name, value] : more) environment[name] = value;
        arguments.insert(arguments.begin(), {test::built_program("handrail"), "--no-window", "--device", "none"});
        job = PtyJob::start([arguments, environment] {
            for (const auto& [name, value] : environment) {
                if (value.empty()) ::unsetenv(name.c_str());
                else ::setenv(name.c_str(), value.c_str(), 1);
            }
            std::vector<char*> words;
            for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
            words.push_back(nullptr);
            ::execv(words[0], words.data());
            ::_exit(127);
        });
    }
    // Types `typed`. Returns true once the output after that contains `said`.
    bool after(const std::string& typed, const std::string& said) const {
        const std::size_t from = job->said().size();
        job->type(typed);
        return job->says(said, from);
    }
    bool in_first_room() const { return job && job->says("facing north"); }
};

TEST(Terminal, session_first_explains_how_to_act_and_names_keys_that_exist) {
    const AtTerminal at;
    ASSERT_TRUE(at.in_first_room()) << at.job->said();
    EXPECT_TRUE(at.job->gives_keys());
    const std::string& said = at.job->said();
    EXPECT_LT(
        said.find(
            "Handrail. Keys act immediately here. To type a command word, begin with a colon and end with Enter."),
        40U)
        << said;
    EXPECT_TRUE(at.job->says("Press Up to walk."));
    EXPECT_EQ(said.find("Type forward"), std::string::npos);
}

TEST(Terminal, keys_act_at_once_and_commands_are_typed_after_a_colon) {
    const AtTerminal at;
    ASSERT_TRUE(at.in_first_room()) << at.job->said();
    EXPECT_TRUE(at.after("\x1b[C", "North-north-east")) << "an arrow";
    EXPECT_TRUE(
        at.after(":hea\x7f"
                 "ading\r",
                 "Facing north"))
        << "a word";
    EXPECT_TRUE(at.after("\t", "1 of 13")) << "the menu";
    EXPECT_TRUE(at.after("\x1b[B", "2 of 13")) << "down the list";
    at.job->send(SIGTERM);
    EXPECT_EQ(at.job->ends(), 0);
    EXPECT_TRUE(at.job->as_before());
}

TEST(Terminal, digits_function_keys_space_and_escape_act_as_in_the_window) {
    const AtTerminal at;
    ASSERT_TRUE(at.in_first_room()) << at.job->said();
    EXPECT_TRUE(at.after("2", "Behind: ")) << "a digit: what is around";
    EXPECT_TRUE(at.after("\x1bOQ", "facing north")) << "F2: where am I";
    EXPECT_TRUE(at.after(" ", "facing north")) << "Space: the same again";
    EXPECT_TRUE(at.after("\x1b[1;2Q", "Turned to the nearest wall")) << "Shift+F2: I am lost";
    EXPECT_TRUE(at.after("\x1b[15;2~", "one storey")) << "Shift+F5: the building";
    EXPECT_TRUE(at.after("\x1b[1;2R", "Which room to describe")) << "Shift+F3: a room from afar";
    EXPECT_TRUE(at.after("\x1b", "Closed")) << "Escape closes a list,";
    EXPECT_TRUE(at.after("\x1b", "Press Escape again to leave.")) << "and asks before it leaves";
    EXPECT_TRUE(at.after(":exit\r", "Goodbye.")) << "the word is the same question, answered";
    EXPECT_EQ(at.job->ends(), 0);
    EXPECT_TRUE(at.job->as_before());
}

TEST(Terminal, of_an_unknown_type_works_with_typed_lines) {
    const AtTerminal at({}, {{"TERM", "dumb"}});
    ASSERT_TRUE(at.in_first_room()) << at.job->said();
    EXPECT_TRUE(at.job->as_before()) << "untouched";
    EXPECT_TRUE(at.job->says("Type forward to walk."));
    EXPECT_TRUE(at.after("heading\n", "Facing north"));
    at.job->type("quit\n");
    EXPECT_EQ(at.job->ends(), 0);
    EXPECT_TRUE(at.job->as_before());
}

TEST(Terminal, accepts_commands_while_the_first_world_is_read) {
    const TemporaryFolder folder;
    const std::string world = folder.write("endless.obj", endless_obj()).string();
    for (const auto& [terminal, word] : {std::pair("dumb", "quit\n"), std::pair("xterm-256color", ":quit\r")}) {
        const AtTerminal at({world}, {{"TERM", terminal}});
        ASSERT_TRUE(at.job && at.job->says("Handrail.")) << terminal;
        at.job->type(word);
        EXPECT_EQ(at.job->ends(), 0) << terminal;
        EXPECT_TRUE(at.job->as_before()) << terminal;
    }
}

TEST(Terminal, is_restored_after_any_end_of_the_program) {
    struct Way {
        std::string name;
        std::string typed;
        int signal;
        int status;
    };
    for (const Way& way : {Way{"Escape twice", "\x1b", 0, 0}, Way{"Ctrl+C", "\x03", 0, 0}, Way{"TERM", "", SIGTERM, 0},
                           Way{"HUP", "", SIGHUP, 0}, Way{"INT", "", SIGINT, 0}, Way{"QUIT", "\x1c", 0, 128 + SIGQUIT},
                           Way{"a crash", "", SIGSEGV, 128 + SIGSEGV}, Way{"abort", "", SIGABRT, 128 + SIGABRT}}) {
        const AtTerminal at;
        ASSERT_TRUE(at.in_first_room()) << at.job->said();
        ASSERT_TRUE(at.job->gives_keys()) << way.name;
        EXPECT_TRUE(way.name != "Escape twice" || at.after("\x1b", "again")) << at.job->said();
        if (way.signal != 0) at.job->send(way.signal);
        else at.job->type(way.typed);
        if (way.status > 128) expect_ended_by(way.status - 128, at.job->ends());
        else EXPECT_EQ(at.job->ends(), way.status) << way.name;
        EXPECT_TRUE(at.job->as_before()) << way.name;
    }
}

TEST(Terminal, is_restored_while_stopped_and_delivers_keys_again_after_resuming) {
    const AtTerminal at;
    ASSERT_TRUE(at.in_first_room()) << at.job->said();
    at.job->type("\x1a");
    ASSERT_TRUE(at.job->stops());
    EXPECT_TRUE(at.job->as_before());
    at.job->in_foreground();
    EXPECT_TRUE(eventually([&] { return at.job->gives_keys(); }));
    EXPECT_TRUE(at.after("c", "Facing north"));
    at.job->send(SIGTERM);
    EXPECT_EQ(at.job->ends(), 0);
    EXPECT_TRUE(at.job->as_before());
}

TEST(Terminal, survives_a_person_who_presses_every_key) {
    const AtTerminal at;
    ASSERT_TRUE(at.in_first_room()) << at.job->said();
    unsigned state = 12345;
    const auto next = [&state](unsigned below) { return (state = state * 1664525U + 1013904223U) / 65536U % below; };
    const char* kSequences[] = {"\x1b[A",
                                "\x1b[B",
                                "\x1b[C",
                                "\x1b[D",
                                "\x1b[1;2A",
                                "\x1b[1;5B",
                                "\x1bOP",
                                "\x1b[15~",
                                "\x1b[3~",
                                "\x1b[99~",
                                "\x1b[200~forward 2\n\x1b[201~",
                                ":where\r",
                                "\t",
                                "\x1b[24~"};
    const int inputs = scaled(20'000);
    for (int i = 0; i < inputs; ++i) {
        std::string bytes =
            next(3) == 0 ? kSequences[next(std::size(kSequences))] : std::string(1, static_cast<char>(32 + next(95)));
        at.job->type(bytes);
        if (i % 20 == 0) at.job->says("never said", 0, 0.02);
    }
    EXPECT_EQ(at.job->ends(0.5), -1) << "alive";
    at.job->send(SIGTERM);
    EXPECT_EQ(at.job->ends(), 0) << at.job->said().substr(at.job->said().size() > 2000 ? at.job->said().size() - 2000
                                                                                       : 0);
    EXPECT_TRUE(at.job->as_before());
}

}  // namespace terminal_test
}  // namespace handrail::test
