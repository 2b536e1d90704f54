#include <array>
#include <cstdio>

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

TEST(TouchRenderer, gives_the_same_numbers_with_and_without_optimisation) {
    const std::string plain = output_of(TOUCH_REPLAY_O0), optimised = output_of(TOUCH_REPLAY_O2);
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

}  // namespace same_numbers_test
}  // namespace handrail
