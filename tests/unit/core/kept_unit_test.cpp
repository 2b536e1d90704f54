// Tests that the unit that a person has set for a world is stored, and that nothing else in the side file changes.
#include "app/core/kept/kept_unit.h"

#include <gtest/gtest.h>

#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace kept_unit_test {

namespace fs = std::filesystem;

TEST(KeptUnit, is_restored_together_with_other_additions) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("flat.obj", "v 0 0 0\n");
    EXPECT_EQ(kept_unit(world, {}, false), std::nullopt);
    SideFile file = SideFile::of_world(world, {});
    file.set_table("names", {{"Room 3", std::string("Kitchen")}});
    file.set_table("unit", {{"said_by", std::string("me")}});
    keep_unit(file, 0.0254);
    ASSERT_TRUE(file.save());
    EXPECT_EQ(kept_unit(world, {}, false), 0.0254);
    const SideFile again = SideFile::of_world(world, {});
    EXPECT_EQ(text_of(again.table("names"), "Room 3"), "Kitchen");
    EXPECT_EQ(text_of(again.table("unit"), "said_by"), "me");
}

TEST(KeptUnit, is_ignored_if_invalid_and_a_damaged_file_stays_in_place) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("flat.obj", "v 0 0 0\n"), side = folder.path() / "flat.obj.handrail.toml";
    for (const char* text :
         {"[unit]\nmetres = -1.0\n", "[unit]\nmetres = \"mm\"\n", "unit = 3\n", "[unit\nmetres = 1.0\n"}) {
        folder.write("flat.obj.handrail.toml", text);
        EXPECT_EQ(kept_unit(world, {}, false), std::nullopt) << text;
        EXPECT_TRUE(fs::exists(side)) << text;
    }
}

}  // namespace kept_unit_test
}  // namespace handrail
