// The way of one move of the proxy, and what the move may still do. Plain values. Owned by ProxySolver; its thread and
// rules.
#pragma once

#include <array>
#include <cstddef>

#include "haptic/render/tick_assert.h"
#include "worlds/base/vec.h"

namespace handrail {

// Relative to the solver's anchor.
struct ProxyPath {
    static constexpr int kMostRounds = 64;  // of a move

    std::array<Vec3, 2 * kMostRounds + 4> points_m{};
    int size = 0;
    int rubs_from = 0;       // from this point on the ball was never in the air, as far as friction knows
    int rounds_left = 0;     // of the last move, for friction
    bool was_free = true;    // nothing held the ball before this move
    double longest_m = 0.0;  // the way may be so long

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
    // The anchor has moved by that.
    void move_anchor(const Vec3& by_m) noexcept {
        for (int i = 0; i < size; ++i) points_m[static_cast<std::size_t>(i)] -= by_m;
    }
};

// What is left of a move's budget, in the units of ProxySolver::kMostWork.
struct ProxyWork {
    int left = 0;
    int most_rounds = 0;
    int looks_left = 0;  // of this gathering in one shape
    int looks = 0;       // of this move, all together
};

}  // namespace handrail
