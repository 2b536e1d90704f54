// Tests that the program stores a person's additions to a shipped world in the person's own folder. This must not
// depend on how the person opened the world.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace shipped_world_test {
namespace fs = std::filesystem;

class ShippedWorld : public testing::Test {
protected:
    // Opens `world`, sets a mark at the start and leaves. Then returns the files below the person's own folder that
    // contain the mark.
    std::vector<std::string> kept_after_mark_in(const std::string& world,
                                                const std::map<std::string, std::string>& environment = {}) {
        const TemporaryFolder home;
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = {world, "--no-window", "--device", "none"};
        call.input = "mark\nHere I was\nquit\n";
        call.environment = environment;
        call.environment["HOME"] = home.path().string();
        call.environment["XDG_DATA_HOME"] = (home.path() / "data").string();
        const ProgramRun run = run_program(call);
        EXPECT_EQ(run.exit_status, 0) << run.err;
        EXPECT_THAT(run.out, testing::HasSubstr("Here I was"));
        std::vector<std::string> kept;
        std::error_code ec;
        for (const fs::directory_entry& file : fs::directory_iterator(home.path() / "data/handrail/worlds", ec)) {
            std::ifstream stream(file.path());
            const std::string text((std::istreambuf_iterator<char>(stream)), {});
            if (text.find("Here I was") != std::string::npos) kept.push_back(file.path().filename().string());
        }
        EXPECT_FALSE(fs::remove(beside(ours_), ec)) << "beside the world itself, for " << world;
        return kept;
    }
    static fs::path beside(fs::path world) { return world += ".handrail.toml"; }
    const fs::path ours_ = test::bundled_world("house.map");
};

TEST_F(ShippedWorld, stores_marks_in_the_persons_folder_whether_opened_by_path_name_or_link) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "NamedWorlds.* runs the same threads";
    const std::vector<std::string> by_path = kept_after_mark_in(ours_.string());
    ASSERT_EQ(by_path.size(), 1U);
    EXPECT_EQ(kept_after_mark_in("house"), by_path) << "the name alone, and the same file";
    const TemporaryFolder links;
    fs::create_symlink(ours_, links.path() / "my_house.map");
    EXPECT_EQ(kept_after_mark_in((links.path() / "my_house.map").string()), by_path);
    EXPECT_FALSE(fs::exists(beside(links.path() / "my_house.map")));
    fs::create_directory_symlink((test::project_root() / "worlds/maps").string(), links.path() / "worlds");
    EXPECT_EQ(kept_after_mark_in((links.path() / "worlds" / "house.map").string()), by_path);
}

TEST_F(ShippedWorld, stores_them_there_even_if_another_folder_is_set_as_that_of_the_shipped_worlds) {
    const TemporaryFolder others;
    fs::copy_file(ours_, others.path() / "house.map");
    const std::map<std::string, std::string> named{{"HANDRAIL_WORLDS", others.path().string()}};
    EXPECT_EQ(kept_after_mark_in(ours_.string(), named).size(), 1U);
    EXPECT_EQ(kept_after_mark_in("house", named).size(), 1U);
    EXPECT_FALSE(fs::exists(beside(others.path() / "house.map")));
}

TEST_F(ShippedWorld, stores_marks_of_a_persons_own_world_next_to_it) {
    const TemporaryFolder own;
    fs::copy_file(ours_, own.path() / "house.map");
    EXPECT_TRUE(kept_after_mark_in((own.path() / "house.map").string()).empty());
    EXPECT_TRUE(fs::exists(beside(own.path() / "house.map")));
}

}  // namespace shipped_world_test
}  // namespace handrail::test
