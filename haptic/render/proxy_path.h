// Holds the path of one move of the proxy, and the rest of that move's work budget. Plain values. ProxySolver owns
// them; the same thread and rules apply.
#pragma once

#include <array>
#include <cstddef>

#include "haptic/render/tick_assert.h"
#include "worlds/base/vec.h"

namespace handrail::render {

// The points of the path, relative to the solver's anchor.
struct ProxyPath {
    static constexpr int kMostRounds = 64;  // greatest number of rounds in one move

    std::array<Vec3, 2 * kMostRounds + 4> points_m{};
    int size = 0;
    int rubs_from = 0;       // index of the first point at which the proxy slides; before it, friction does not act
    int rounds_left = 0;     // rounds that the move did not need and that friction may use
    bool was_free = true;    // no surface held the proxy before this move
    double longest_m = 0.0;  // limit for the length of the path

    Vec3& operator[](int i) noexcept {
        tick_assert(i >= 0 && static_cast<std::size_t>(i) < points_m.size());
        return points_m[static_cast<std::size_t>(i)];
    }
    const Vec3& operator[](int i) const noexcept {
        tick_assert(i >= 0 && static_cast<std::size_t>(i) < points_m.size());
        return points_m[static_cast<std::size_t>(i)];
    }
    void begin(const Vec3& at_m) noexcept {
        points_m[0] = at_m;
        size = 1;
    }
    void add(const Vec3& to_m) noexcept {
        tick_assert(static_cast<std::size_t>(size) < points_m.size());
        points_m[static_cast<std::size_t>(size++)] = to_m;
    }
    // Adapts the points to an anchor that has moved by `by_m`.
    void move_anchor(const Vec3& by_m) noexcept {
        for (int i = 0; i < size; ++i) points_m[static_cast<std::size_t>(i)] -= by_m;
    }
};

// The remaining work budget of a move, in the units of ProxySolver::kMostWork.
struct ProxyWork {
    int left = 0;
    int most_rounds = 0;
    int looks_left = 0;  // visits left for this gathering in one shape
    int looks = 0;       // number of visits in this move
};

}  // namespace handrail::render
