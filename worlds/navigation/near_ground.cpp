#include "worlds/navigation/near_ground.h"

#include <algorithm>
#include <cmath>

#include "worlds/scene/outer_ground.h"

namespace handrail::navigation {
namespace {

// Least side of a square, and most squares along a side of the grid.
constexpr double kLeastSquare_m = 0.5, kMostSquares = 2'000.0;
constexpr double kSquareShare = 0.125;  // side of a square, as a fraction of the distance within which ground is kept

}  // namespace

NearGround::NearGround(const Scene& scene, const Obstacles& obstacles, double within_m) : within_m_(within_m) {
    Aabb ground;
    std::vector<bool> is_ground(obstacles.all.size(), false);
    for (std::size_t k = 0; k < is_ground.size(); ++k) {
        const Feature* feature = scene.find(obstacles.all[k].feature);
        is_ground[k] = feature && is_outer_ground(*feature);
        if (is_ground[k]) ground.include(obstacles.all[k].box_m);
    }
    if (ground.empty()) return;
    is_ground_ = std::move(is_ground);
    least_ = Vec2(ground.min_m);
    const Vec3 size = ground.size_m();
    square_m_ = std::max({kLeastSquare_m, kSquareShare * within_m, std::max(size.x, size.y) / kMostSquares});
    wide_ = static_cast<std::size_t>(size.x / square_m_) + 1;
    deep_ = static_cast<std::size_t>(size.y / square_m_) + 1;
    near_.assign(wide_ * deep_, false);
    const auto square = [&](double metres, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(metres / square_m_, 0.0, static_cast<double>(count - 1)));
    };
    const auto include = [&](const Aabb& box) {
        const std::size_t x1 = square(box.max_m.x + within_m - least_.x, wide_),
                          y1 = square(box.max_m.y + within_m - least_.y, deep_);
        for (std::size_t y = square(box.min_m.y - within_m - least_.y, deep_); y <= y1; ++y)
            for (std::size_t x = square(box.min_m.x - within_m - least_.x, wide_); x <= x1; ++x)
                near_[y * wide_ + x] = true;
    };
    for (std::size_t k = 0; k < is_ground_.size(); ++k) {
        const Feature* feature = scene.find(obstacles.all[k].feature);
        const bool neighbour = feature && feature->made_name && feature->name == kNeighbouringBuilding;
        if (!is_ground_[k] && !neighbour) include(obstacles.all[k].box_m);
    }
    for (const Start& start : scene.starts) include({start.feet_m, start.feet_m});
}

bool NearGround::leaves_out(std::uint32_t obstacle, const Vec2& at_m) const {
    if (obstacle >= is_ground_.size() || !is_ground_[obstacle]) return false;
    const Vec2 off = (at_m - least_) / square_m_;
    if (off.x < 0.0 || off.y < 0.0) return true;
    const auto x = static_cast<std::size_t>(off.x), y = static_cast<std::size_t>(off.y);
    return x >= wide_ || y >= deep_ || !near_[y * wide_ + x];
}

}  // namespace handrail::navigation
