// Keeps the last positions of the proxy, which the plan shows as a line. Plain state in world metres, for the app
// thread.
#pragma once

#include <vector>

#include "worlds/base/vec.h"

namespace handrail::core {

class HandPath {
public:
    static constexpr std::size_t kMostPoints = 400;
    static constexpr double kPoint_m = 0.1;  // distance between two positions that are kept

    // Adds the position if the proxy has moved far enough since the last one.
    void add(const Vec3& proxy_m) {
        if (!points_m_.empty() && glm::distance(points_m_.back(), proxy_m) < kPoint_m) return;
        if (points_m_.size() >= kMostPoints) points_m_.erase(points_m_.begin(), points_m_.begin() + kMostPoints / 4);
        points_m_.push_back(proxy_m);
    }
    void clear() { points_m_.clear(); }
    const std::vector<Vec3>& points_m() const { return points_m_; }

private:
    std::vector<Vec3> points_m_;
};

}  // namespace handrail::core
