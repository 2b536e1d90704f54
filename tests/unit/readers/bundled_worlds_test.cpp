// Tests that the reader reads the bundled worlds without warnings. Under every start must be one floor, and nothing may
// overlap a start.
#include <filesystem>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/unit/readers/reading.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace bundled_worlds_test {

TEST(BundledWorlds, are_read_without_a_warning_and_have_a_base_and_landmarks) {
    int worlds = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::project_root() / "worlds" / "maps")) {
        if (entry.path().extension() != ".map") continue;
        ++worlds;
        const auto scene = read_world(entry.path());
        ASSERT_TRUE(scene) << entry.path();
        EXPECT_EQ(scene->report.warnings_in_all, 0) << entry.path() << scene->report.warnings.front().sentence();
        EXPECT_TRUE(scene->report.left_out.empty()) << entry.path() << scene->report.left_out.front();
        EXPECT_TRUE(std::any_of(scene->starts.begin(), scene->starts.end(), [](const Start& s) { return s.base; }))
            << entry.path();
        EXPECT_FALSE(scene->game_map) << entry.path();
    }
    EXPECT_GE(worlds, 3);
}

}  // namespace bundled_worlds_test
}  // namespace handrail
