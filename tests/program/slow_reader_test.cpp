// Runs the program with a world that is slow to read. The reader process reports its progress and then waits.
#include <gmock/gmock.h>

#include <filesystem>
#include <future>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace slow_reader_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class SlowReader : public testing::Test {
protected:
    static constexpr const char* kLine = "Loading, 40 percent: building walls, floors and openings.";

    void SetUp() override {
        fs::create_directories(folder_.path() / "bin");
        fs::copy_file(test::built_program("handrail"), program());
        // A script in place of handrail-reader. It reports progress as handrail-reader does (reader_process), waits,
        // and then runs the real handrail-reader.
        const fs::path reader =
            folder_.write("bin/handrail-reader", "#!/bin/sh\nprintf 'p40\\nsimport.shapes\\n' >&4\nsleep 3\nexec '" +
                                                     test::built_program("handrail-reader") + "' \"$@\"\n");
        fs::permissions(reader, fs::perms::owner_all);
        world_ = folder_.write("hall.rooms",
                               "Building: Slow hall.\nHall, 8 by 6 metres.\nDoor outside in the south wall.\n");
    }
    fs::path program() const { return folder_.path() / "bin" / "handrail"; }
    std::future<ProgramRun> begin(std::vector<std::string> arguments, const std::string& input = {}) {
        ProgramCall call;
        call.program = program().string();
        call.arguments = std::move(arguments);
        call.environment["HANDRAIL_WORLDS"] = (test::project_root() / "worlds/maps").string();
        call.input = input;
        return std::async(std::launch::async, [call] { return run_program(call); });
    }

    TemporaryFolder folder_;
    fs::path world_;
};

TEST_F(SlowReader, is_reported_on_standard_error_by_commands_but_not_with_json) {
    auto info = begin({"info", world_.string()}), check = begin({"check", world_.string()}),
         json = begin({"info", "--json", world_.string()});
    EXPECT_THAT(info.get().err, StartsWith(std::string(kLine) + "\n"));
    EXPECT_THAT(check.get().err, StartsWith(std::string(kLine) + "\n"));
    const ProgramRun as_data = json.get();
    EXPECT_EQ(as_data.exit_status, 0);
    EXPECT_EQ(as_data.err, "");
    ProgramCall quick;
    quick.program = test::built_program("handrail");
    quick.arguments = {"info", test::bundled_world("first_room.map")};
    EXPECT_EQ(run_program(quick).err, "") << "what is quick";
}

TEST_F(SlowReader, is_reported_in_a_session_by_speech_and_in_text) {
    const ProgramRun run = begin({world_.string(), "--no-window", "--device", "none"}, "where\nquit\n").get();
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr(std::string("say: ") + kLine));
}

}  // namespace slow_reader_test
}  // namespace handrail::test
