// Defines the name of a learner in a lesson, and a number derived from that name. Plain data.
#pragma once

#include <cstdint>
#include <string>

namespace handrail::teaching {

struct LearnerName {
    std::string name;          // chosen name; empty: no particular learner
    std::uint64_t number = 0;  // seed for shuffled orders, derived from the name
};
// Returns the name with its number. Equal names have equal numbers.
LearnerName learner_named(const std::string& name);

}  // namespace handrail::teaching
