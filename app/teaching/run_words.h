// Declares functions that both parts of TeachingRun use, teaching_run.cpp and teaching_questions.cpp.
#pragma once

#include <cmath>
#include <string>

#include "worlds/base/vec.h"

namespace handrail::teaching {

// Returns true if two places are on the same storey and at most `level_m` apart horizontally.
inline bool near_place(const Vec3& a, const Vec3& b, double level_m) {
    constexpr double kSameHeight_m = 1.0;
    return std::abs(a.z - b.z) < kSameHeight_m && std::hypot(a.x - b.x, a.y - b.y) < level_m;
}

// Joins two sentences. Either may be empty.
inline std::string one_after(std::string first, const std::string& then) {
    if (!first.empty() && !then.empty()) first += ' ';
    return first + then;
}

}  // namespace handrail::teaching
