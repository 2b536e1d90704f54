// Checks with readelf how the built programs are protected. Both programs must load at random addresses, their tables
// must be read-only while they run, and functions with arrays must detect an overwritten stack.
#include <array>
#include <cstdio>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"

namespace handrail::test {
namespace hardened_test {

using testing::ContainsRegex;
using testing::HasSubstr;

std::string readelf_of(const std::string& program) {
    std::string text;
    const std::string command =
        std::string("readelf --wide --file-header --program-headers --dynamic --dyn-syms '") + program + "' 2>&1";
    if (FILE* pipe = ::popen(command.c_str(), "r")) {
        std::array<char, 4096> piece{};
        while (std::fgets(piece.data(), piece.size(), pipe)) text += piece.data();
        ::pclose(pipe);
    }
    return text;
}

TEST(Hardened, programs_start_at_random_addresses_with_read_only_tables_and_guarded_stacks) {
    if (!HANDRAIL_HARDENED)
        GTEST_SKIP() << "This preset is built without, or for a sanitizer, which guards in its own way.";
    for (const std::string& program : {test::built_program("handrail"), test::built_program("handrail-guard")}) {
        SCOPED_TRACE(program);
        const std::string header = readelf_of(program);
        EXPECT_THAT(header, ContainsRegex("Type: +DYN \\(Position-Independent Executable file\\)"));
        EXPECT_THAT(header, HasSubstr("GNU_RELRO"));
        EXPECT_THAT(header, HasSubstr("BIND_NOW"));
        EXPECT_THAT(header, ContainsRegex("GNU_STACK[ 0-9a-fx]* RW "));  // the stack is not executable
        EXPECT_THAT(header, HasSubstr("__stack_chk_fail"));
    }
#ifdef __OPTIMIZE__
    EXPECT_THAT(readelf_of(test::built_program("handrail")),
                ContainsRegex("__[a-z]+_chk@"));  // the programs call the checked versions of the C library's functions
#endif
    EXPECT_THAT(readelf_of(test::built_program("handrail")), HasSubstr("__glibcxx_assert_fail"));
}

}  // namespace hardened_test
}  // namespace handrail::test
