#include <array>
#include <cstdint>
#include <cstdio>

#include "tests/support/names.h"
#include "tests/support/project_root.h"

namespace handrail {
namespace same_numbers_test {

std::string output_of(const std::string& program) {
    std::string out;
    std::FILE* pipe = ::popen(program.c_str(), "r");
    if (!pipe) return out;
    std::array<char, 4096> block;
    for (std::size_t got = 0; (got = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
        out.append(block.data(), got);
    EXPECT_EQ(::pclose(pipe), 0) << program;
    return out;
}

// Returns the FNV-1a hash of `text`.
std::uint64_t sum_of(const std::string& text) {
    std::uint64_t sum = 0xcbf29ce484222325U;
    for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return sum;
}

// Every compiler, optimiser and sanitizer must give the same numbers. If you change the renderer's numbers on purpose,
// enter the new hashes here. Run `touch_replay >FILE` before and after the change to see which numbers differ.
TEST(TouchRenderer, gives_identical_numbers_in_every_build_preset) {
    const std::string numbers = output_of(test::built_program("touch_replay"));
    EXPECT_GT(numbers.size(), 10000U);
    EXPECT_EQ(sum_of(numbers), 0xcbcd30554d294c93U) << fmt::format("{:#x}", sum_of(numbers));
}

TEST(ThingsThatMove, follow_identical_paths_in_every_build_preset) {
    const std::string numbers = output_of(test::built_program("bodies_replay"));
    EXPECT_GT(numbers.size(), 10000U);
    EXPECT_EQ(sum_of(numbers), 0xff0c41a8ee7d3036U) << fmt::format("{:#x}", sum_of(numbers));
}

}  // namespace same_numbers_test
}  // namespace handrail
