// Tests that the program starts at a place that the command line or a link names.
#include <gmock/gmock.h>

#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace start_place_test {

using testing::HasSubstr;
using testing::Not;

// `exits` waits until the rooms are known, so that `where` can name the room.
ProgramRun started(std::vector<std::string> arguments, const std::string& input = "quit\nquit\n",
                   ProgramCall call = {}) {
    call.program = built_program("handrail");
    arguments.insert(arguments.end(), {"--no-window", "--device", "none"});
    call.arguments = std::move(arguments);
    call.input = input;
    return run_program(call);
}

TEST(StartPlace, by_name_is_a_room_and_the_base_stays_where_it_was) {
    const ProgramRun run = started({"house", "--at", "the kitchen"}, "exits\nwhere\nhome\nwhere\nquit\nquit\n");
    EXPECT_EQ(run.exit_status, 0) << run.err;
    const std::size_t room = run.out.find("Kitchen, facing"), home = run.out.find("Base. Facing", room);
    ASSERT_NE(room, std::string::npos) << run.out;
    ASSERT_NE(home, std::string::npos) << run.out;
    EXPECT_THAT(run.out.substr(home), HasSubstr("at the base")) << run.out;
    EXPECT_THAT(run.out.substr(0, room), Not(HasSubstr("at the base"))) << run.out;
}

TEST(StartPlace, may_be_a_thing_by_the_beginning_of_its_name) {
    const ProgramRun run = started({"house", "--at", "bath"}, "exits\nwhere\nquit\nquit\n");
    EXPECT_THAT(run.out, HasSubstr("Bathroom, facing")) << run.out;
}

TEST(StartPlace, is_named_at_once_while_the_rooms_are_still_being_searched) {
    EXPECT_THAT(started({"house", "--at", "the kitchen"}).out, HasSubstr("20 by 23 metres. Kitchen, facing north."));
}

TEST(StartPlace, that_no_world_has_is_reported_with_similar_names_and_status_2) {
    const ProgramRun run = started({"house", "--at", "Ketchin"});
    EXPECT_EQ(run.exit_status, 2);
    EXPECT_THAT(run.err,
                HasSubstr("There is no place called \"Ketchin\" in this world; the nearest names are Kitchen"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

TEST(StartPlace, is_found_in_a_link_and_the_command_line_overrides_it) {
    const TemporaryFolder folder;
    const auto link = folder.write("there.handrail", "world = \"house\"\nplace = \"Kitchen\"\n");
    EXPECT_THAT(started({link.string()}, "exits\nwhere\nquit\nquit\n").out, HasSubstr("Kitchen, facing"));
    EXPECT_THAT(started({link.string(), "--at", "Bathroom"}, "exits\nwhere\nquit\nquit\n").out,
                HasSubstr("Bathroom, facing"));
}

TEST(StartPlace, links_name_worlds_from_their_own_folder_and_faults_come_in_one_sentence) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(bundled_world("house.map"), folder.path() / "own.map");
    const auto link = folder.write("own.handrail", "world = \"own.map\"\nplace = \"Bathroom\"\n");
    EXPECT_THAT(started({link.string()}, "exits\nwhere\nquit\nquit\n").out, HasSubstr("Bathroom, facing"));
    for (const char* text :
         {"place = \"Kitchen\"\n", "world = 3\n", "world = \"\"\n", "world = \"house\"\nplace = 1\n"}) {
        const ProgramRun run = started({folder.write("bad.handrail", text).string()});
        EXPECT_EQ(run.exit_status, 1) << text;
        EXPECT_EQ(
            run.err,
            "bad.handrail: A link needs the name of a world, such as world = \"house\", and may have a place, such as "
            "place = \"Kitchen\".\n")
            << text;
    }
    const ProgramRun torn = started({folder.write("torn.handrail", "world = \"hou").string()});
    EXPECT_EQ(torn.exit_status, 1);
    EXPECT_THAT(torn.err, HasSubstr("torn.handrail, line 1"));
}

}  // namespace start_place_test
}  // namespace handrail::test
