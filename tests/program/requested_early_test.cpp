// Tests that the program answers commands that a person types in the first second, before it knows the rooms of a
// world. If a command opens a list, the next line must answer the list and must not be a command.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"

namespace handrail::test {
namespace requested_early_test {

using testing::HasSubstr;
using testing::Not;

std::string said_of(const std::string& lines, const std::vector<std::string>& more = {}) {
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {test::bundled_world("school.map"), "--no-window", "--device", "none"};
    call.arguments.insert(call.arguments.end(), more.begin(), more.end());
    call.input = lines;
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return run.out;
}

TEST(RequestedEarly, route_commands_wait_for_the_rooms_and_then_use_the_typed_choice) {
    const std::string said = said_of("routes\nlibrary\nquit\n");
    EXPECT_THAT(said, HasSubstr("Route to which room. "));
    EXPECT_THAT(said, HasSubstr("To Library."));
    EXPECT_THAT(said, Not(HasSubstr("no command")));
    EXPECT_THAT(said, Not(HasSubstr("Ask again")));
}

TEST(RequestedEarly, a_command_and_its_choice_can_be_typed_on_one_line_in_either_language) {
    const std::string said = said_of("describe library\nquit\n");
    EXPECT_THAT(said, HasSubstr("Library: "));
    EXPECT_THAT(said, HasSubstr("exit"));
    EXPECT_THAT(said, Not(HasSubstr("no command")));
    EXPECT_THAT(said, Not(HasSubstr("may be followed")));
    const std::string german = said_of("beschreibe bücherei\nquit\n", {"--set", "speech.language=de"});
    EXPECT_THAT(german, HasSubstr("Bücherei: "));
    EXPECT_THAT(german, HasSubstr("Ausg"));
}

}  // namespace requested_early_test
}  // namespace handrail::test
