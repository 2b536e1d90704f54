// Tests what a person can do if a world's file lacks a door. The person adds the door from the list of faults, walks
// through it in this session and the next, and removes it again. The world's file must stay unchanged.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <filesystem>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace made_door_test {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kText =
    "Building: Two rooms.\n\nRoom: Hall, 4 by 6 metres. Door outside in the south wall.\n\n"
    "Room: Kitchen, 4 by 4 metres, east of Hall. Stove in the north-east corner, landmark.\n";

// Types the lines into a session and ends it. Returns what the program printed.
std::string said_in(const std::filesystem::path& world, const std::string& lines) {
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {world.string(), "--no-window", "--device", "none"};
    call.input = lines + "quit\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return run.out;
}

class MadeDoor : public testing::Test {
protected:
    std::string said_of(const std::string& lines) const { return said_in(world_, lines); }
    int check() const {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = {"check", world_.string()};
        return run_program(call).exit_status;
    }
    const TemporaryFolder folder_;
    const std::filesystem::path world_ = folder_.write("two.rooms", kText);
};

TEST_F(MadeDoor, exists_at_once_and_in_the_next_session_until_it_is_removed) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "RequestedEarly.* runs the same threads";
    EXPECT_EQ(check(), 1) << "the kitchen cannot be reached";
    EXPECT_THAT(said_of("describe kitchen\n"), HasSubstr("No exits."));
    const std::string made = said_of("faults\nkitchen cannot\n1\ndescribe kitchen\nroutes kitchen\n");
    EXPECT_THAT(made, HasSubstr("There is now a door between Kitchen, Hall."));
    EXPECT_THAT(made, HasSubstr("1 exit: opening to Hall"));
    EXPECT_THAT(made, HasSubstr("To Kitchen."));
    EXPECT_EQ(content_of(world_), kText) << "the source is as it was";
    EXPECT_THAT(content_of(folder_.path() / "two.rooms.handrail.toml"), HasSubstr("mended"));
    EXPECT_EQ(check(), 0);
    EXPECT_THAT(said_of("describe kitchen\n"), HasSubstr("1 exit: opening to Hall"));
    const std::string gone = said_of("faults\ndoor added\nremove this door\ndescribe kitchen\n");
    EXPECT_THAT(gone, HasSubstr("is a wall again."));
    EXPECT_THAT(gone, HasSubstr("No exits."));
    EXPECT_THAT(said_of("describe kitchen\n"), Not(HasSubstr("opening to Hall")));
}

// A mesh of a terrace with a bench. It was drawn in millimetres and states no unit.
std::string terrace_in_millimetres() {
    std::string text = "solid terrace\n";
    const auto block = [&](const std::array<int, 3>& least, const std::array<int, 3>& most) {
        const auto corner = [&](int which) {
            return fmt::format("vertex {} {} {}\n", (which & 1 ? most : least)[0], (which & 2 ? most : least)[1],
                               (which & 4 ? most : least)[2]);
        };
        for (const auto& [a, b, c] :
             {std::array{0, 2, 1}, std::array{1, 2, 3}, std::array{4, 5, 6}, std::array{5, 7, 6}, std::array{0, 1, 4},
              std::array{1, 5, 4}, std::array{2, 6, 3}, std::array{3, 6, 7}, std::array{0, 4, 2}, std::array{2, 4, 6},
              std::array{1, 3, 5}, std::array{3, 7, 5}})
            text += "facet normal 0 0 0\nouter loop\n" + corner(a) + corner(b) + corner(c) + "endloop\nendfacet\n";
    };
    block({0, 0, -100}, {6200, 4000, 0});
    block({200, 200, 1}, {1700, 600, 450});
    return text + "endsolid terrace\n";
}

TEST(MendedUnit, is_saved_next_to_the_world_and_applies_at_once_and_in_the_next_session) {
    const TemporaryFolder folder;
    const std::filesystem::path world = folder.write("terrace.stl", terrace_in_millimetres());
    const std::string mended = said_in(world, "faults\nno unit\none unit is a millimetre\nforward 1\n");
    EXPECT_THAT(mended, HasSubstr("the world would be 6.2 metres wide"));
    EXPECT_THAT(mended, HasSubstr("The unit has been changed."));
    EXPECT_THAT(content_of(folder.path() / "terrace.stl.handrail.toml"), HasSubstr("metres = 0.001"));
    const std::string next = said_in(world, "faults\n");
    EXPECT_THAT(next, Not(HasSubstr("no unit of length")));
    EXPECT_THAT(next, Not(HasSubstr("6,200")));
}

}  // namespace made_door_test
}  // namespace handrail::test
