// Compiles and runs the five lines of README.md that use the library, and compares them with the page.
#include <cmath>
#include <fstream>
#include <sstream>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace library_example_test {

double force_in_house() {
    // clang-format off
const auto world = handrail::readers::read_world("house.map");
const auto felt = handrail::compile::compile_haptic(*world, handrail::compile::MaterialSource::Library);
const auto hand_m = world->starts.front().feet_m + handrail::Vec3(0.0, 0.0, -0.001);  // 1 mm deep
handrail::render::TouchState state;
const auto force_n = handrail::render::touch_tick(state, *felt, {}, hand_m, 0.001).force_n;
    // clang-format on
    return glm::length(force_n);
}

TEST(Readme, shows_five_lines_of_library_code_that_compile_and_give_a_force) {
    const std::string readme = test::content_of(test::project_root() / "README.md");
    const std::size_t open = readme.find("```cpp\n");
    ASSERT_NE(open, std::string::npos);
    const std::string shown = readme.substr(open + 7, readme.find("```", open + 7) - open - 7);
    EXPECT_EQ(std::count(shown.begin(), shown.end(), '\n'), 5);
    EXPECT_NE(test::content_of(test::project_root() / "tests/unit/docs/library_example_test.cpp").find(shown),
              std::string::npos)
        << shown;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(test::project_root() / "worlds" / "maps");
    const double force_n = force_in_house();
    std::filesystem::current_path(before);
    EXPECT_TRUE(std::isfinite(force_n));
}

}  // namespace library_example_test
}  // namespace handrail
