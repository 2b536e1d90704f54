// Contains TOML text on which toml++ 3.3 recurses without limit: 200,000 nested tables in one dotted name. The stack of
// the process that parses it overflows.
#pragma once

#include <string>

#include "tests/support/names.h"

namespace handrail::test {

inline std::string deadly_toml() {
    std::string name = "a";
    for (int i = 1; i < 200'000; ++i) name += ".a";
    return "[" + name + "]\nx = 1\n";
}

}  // namespace handrail::test
