// Who learns, as far as a lesson wants to know it. Plain data.
#pragma once

#include <cstdint>
#include <string>

namespace handrail {

struct LearnerName {
    std::string name;          // chosen; empty: nobody in particular
    std::uint64_t number = 0;  // what shuffled orders are drawn from
};
// The number of a name, the same each time.
LearnerName learner_named(const std::string& name);

}  // namespace handrail
