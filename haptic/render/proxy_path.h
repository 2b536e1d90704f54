// The path of one move of the proxy, and the work that the move may still do. Plain values. Owned by ProxySolver, with
// the same thread and rules.
#pragma once

#include <array>
#include <cstddef>

#include "haptic/render/tick_assert.h"
#include "worlds/base/vec.h"

namespace handrail::render {

// The points of the path, relative to the solver's anchor.
struct ProxyPath {
    static constexpr int kMostRounds = 64;  // rounds in one move

    std::array<Vec3, 2 * kMostRounds + 4> points_m{};
    int size = 0;
    int rubs_from = 0;       // index of the point from which on friction treats the proxy as never in the air
    int rounds_left = 0;     // rounds left over from the last move, for friction
    bool was_free = true;    // nothing held the proxy before this move
    double longest_m = 0.0;  // greatest length of the path

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
    // Adjusts the points after the anchor has moved by by_m.
    void move_anchor(const Vec3& by_m) noexcept {
        for (int i = 0; i < size; ++i) points_m[static_cast<std::size_t>(i)] -= by_m;
    }
};

// The rest of a move's work budget, in the units of ProxySolver::kMostWork.
struct ProxyWork {
    int left = 0;
    int most_rounds = 0;
    int looks_left = 0;  // for this gathering in one shape
    int looks = 0;       // total of this move
};

}  // namespace handrail::render
