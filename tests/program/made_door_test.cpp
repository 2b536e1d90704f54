// A door that is missing in a world's file: made from the list of faults, walked through in the same session and the
// next, and taken away again; the file itself stays as it is.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace made_door_test {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kText =
    "Building: Two rooms.\n\nRoom: Hall, 4 by 6 metres. Door outside in the south wall.\n\n"
    "Room: Kitchen, 4 by 4 metres, east of Hall. Stove in the north-east corner, landmark.\n";

class MadeDoor : public testing::Test {
protected:
    std::string said_of(const std::string& lines) const {
        ProgramCall call;
        call.program = HANDRAIL_PROGRAM;
        call.arguments = {world_.string(), "--no-window", "--device", "none"};
        call.input = lines + "quit\n";
        const ProgramRun run = run_program(call);
        EXPECT_EQ(run.exit_status, 0) << run.err;
        return run.out;
    }
    // The list opens once it is known what is in it.
    static std::string a_moment() { return "back 2\nforward 2\n"; }
    int check() const {
        ProgramCall call;
        call.program = HANDRAIL_PROGRAM;
        call.arguments = {"check", world_.string()};
        return run_program(call).exit_status;
    }
    const TemporaryFolder folder_;
    const std::filesystem::path world_ = folder_.write("two.rooms", kText);
};

TEST_F(MadeDoor, is_there_at_once_and_in_the_next_session_until_it_is_taken_away) {
    EXPECT_EQ(check(), 1) << "the kitchen cannot be reached";
    EXPECT_THAT(said_of("describe kitchen\n"), HasSubstr("No exits."));
    const std::string made = said_of("faults\n" + a_moment() + "kitchen cannot\n1\ndescribe kitchen\nroutes kitchen\n");
    EXPECT_THAT(made, HasSubstr("There is a door now between Kitchen, Hall."));
    EXPECT_THAT(made, HasSubstr("1 exit: opening to Hall"));
    EXPECT_THAT(made, HasSubstr("To Kitchen."));
    EXPECT_EQ(content_of(world_), kText) << "the source is as it was";
    EXPECT_THAT(content_of(folder_.path() / "two.rooms.handrail.toml"), HasSubstr("mended"));
    EXPECT_EQ(check(), 0);
    EXPECT_THAT(said_of("describe kitchen\n"), HasSubstr("1 exit: opening to Hall"));
    const std::string gone = said_of("faults\n" + a_moment() + "door made\ntake this door away\ndescribe kitchen\n");
    EXPECT_THAT(gone, HasSubstr("is a wall again."));
    EXPECT_THAT(gone, HasSubstr("No exits."));
    EXPECT_THAT(said_of("describe kitchen\n"), Not(HasSubstr("opening to Hall")));
}

}  // namespace made_door_test
}  // namespace handrail::test
