// What a lesson needs to know about the learner. Plain data.
#pragma once

#include <cstdint>
#include <string>

namespace handrail::teaching {

struct LearnerName {
    std::string name;          // chosen name; empty: nobody in particular
    std::uint64_t number = 0;  // seed for shuffled orders
};
// The name with its number, which is always the same.
LearnerName learner_named(const std::string& name);

}  // namespace handrail::teaching
