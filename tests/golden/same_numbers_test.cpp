#include <array>
#include <cstdio>

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

void expect_same(const std::string& plain, const std::string& optimised) {
    EXPECT_GT(plain.size(), 10000U);
    if (plain == optimised) return;
    std::size_t at = 0;
    while (at < plain.size() && at < optimised.size() && plain[at] == optimised[at]) ++at;
    const auto line_at = [at](const std::string& text) {
        const std::size_t begin = text.rfind('\n', at) + 1;
        return text.substr(begin, text.find('\n', at) - begin);
    };
    ADD_FAILURE() << "first difference:\n-O0: " << line_at(plain) << "\n-O2: " << line_at(optimised);
}

TEST(TouchRenderer, gives_the_same_numbers_with_and_without_optimisation) {
    expect_same(output_of(test::built_program("touch_replay_O0")), output_of(test::built_program("touch_replay_O2")));
}

TEST(ThingsThatMove, go_the_same_ways_with_and_without_optimisation) {
    expect_same(output_of(test::built_program("bodies_replay_O0")), output_of(test::built_program("bodies_replay_O2")));
}

}  // namespace same_numbers_test
}  // namespace handrail
