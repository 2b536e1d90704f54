// TOML that toml++ 3.3 takes without end into itself: 200,000 tables within each other by one name, so the process that
// parses it has no stack left.
#pragma once

#include <string>

namespace handrail::test {

inline std::string deadly_toml() {
    std::string name = "a";
    for (int i = 1; i < 200'000; ++i) name += ".a";
    return "[" + name + "]\nx = 1\n";
}

}  // namespace handrail::test
