// Stores the proxy's data about the obstacles near it. For each candidate obstacle there is one cut, which is a
// half-space that supports the obstacle. The file also stores the obstacles that contain the proxy and are therefore
// not felt. Plain values of fixed size: they allocate only in their constructors. ProxySolver owns them; the same
// thread and rules apply.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "haptic/render/tick_assert.h"
#include "worlds/geometry/half_space_projection.h"

namespace handrail::render {

// An obstacle of a body, or of the still part of the scene.
struct OwnedObstacle {
    static constexpr std::uint16_t kStill = 0xFFFF;  // value of `body` for an obstacle that belongs to no body

    std::uint32_t obstacle = 0;
    std::uint16_t body = kStill;
    bool operator==(const OwnedObstacle&) const = default;
};

// The ghosts: obstacles in which the proxy started and that it has not left yet.
class ProxyGhosts {
public:
    static constexpr int kMost = 256;

    int count() const noexcept { return count_; }
    const OwnedObstacle& operator[](int i) const noexcept {
        tick_assert(i >= 0 && i < count_);
        return list_[static_cast<std::size_t>(i)];
    }
    void clear() noexcept { count_ = 0; }
    // Adds a ghost. Ghosts beyond kMost are ignored.
    void add(const OwnedObstacle& ghost) noexcept {
        if (count_ < kMost) list_[static_cast<std::size_t>(count_++)] = ghost;
    }
    // Removes ghost i; the last one moves to its place.
    void remove(int i) noexcept {
        tick_assert(i >= 0 && i < count_);
        list_[static_cast<std::size_t>(i)] = list_[static_cast<std::size_t>(--count_)];
    }
    bool has(const OwnedObstacle& one) const noexcept {
        const auto end = list_.begin() + count_;
        return std::find(list_.begin(), end, one) != end;
    }
    bool has_of(std::uint16_t body) const noexcept {
        const auto end = list_.begin() + count_;
        return std::find_if(list_.begin(), end, [&](const OwnedObstacle& g) { return g.body == body; }) != end;
    }
    void remove_of(std::uint16_t body) noexcept {
        for (int i = count_ - 1; i >= 0; --i)
            if (list_[static_cast<std::size_t>(i)].body == body) remove(i);
    }

private:
    std::vector<OwnedObstacle> list_ = std::vector<OwnedObstacle>(kMost);
    int count_ = 0;
};

// The candidates. Element i of each vector belongs to candidate i; the first `count` are in use.
struct ProxyCuts {
    static constexpr int kMost = 1024;  // greatest number of candidates, whose cuts need 32 kB
    // State of a one-sided sheet. While the proxy is not on its touchable side, the sheet is asleep and has no cut.
    enum class Sheet : std::uint8_t { No, Awake, Asleep };
    // Offset of a half-space that contains all points. A sleeping sheet has such a cut.
    static constexpr double kNoCut_m = -1e30;

    int count = 0;
    int one_sided = 0;  // how many of the candidates are one-sided sheets
    // Planes that support the obstacles themselves, without the proxy's radius, because the radius may grow. Relative
    // to the solver's anchor.
    std::vector<HalfSpace> planes = std::vector<HalfSpace>(kMost);
    std::vector<std::uint32_t> obstacles = std::vector<std::uint32_t>(kMost);
    std::vector<std::uint16_t> owners = std::vector<std::uint16_t>(kMost, OwnedObstacle::kStill);
    // The planes of `planes` in the body's frame and metres; only for obstacles of bodies.
    std::vector<HalfSpace> own_planes = std::vector<HalfSpace>(kMost);
    // Number of the move in which the solver last renewed the cut from a place ahead of the proxy.
    std::vector<std::uint64_t> looked_ahead = std::vector<std::uint64_t>(kMost);
    std::vector<Sheet> sheets = std::vector<Sheet>(kMost);
    // One-sided sheets that were awake when the last gathering began.
    std::vector<OwnedObstacle> awake = std::vector<OwnedObstacle>(kMost);
    int awake_count = 0;

    void clear() noexcept { count = one_sided = 0; }
    std::span<const HalfSpace> in_use() const noexcept {
        return std::span(planes).first(static_cast<std::size_t>(count));
    }
    OwnedObstacle of(std::size_t i) const noexcept { return {obstacles[i], owners[i]}; }
    // Returns the cut moved outwards by the proxy's radius, which limits the proxy's centre.
    HalfSpace wall(int i, double radius_m) const noexcept {
        tick_assert(i >= 0 && i < count);
        const HalfSpace& cut = planes[static_cast<std::size_t>(i)];
        return {cut.normal, cut.offset_m + radius_m};
    }
    bool asleep(int i) const noexcept { return one_sided > 0 && sheets[static_cast<std::size_t>(i)] == Sheet::Asleep; }

    // Adds a candidate. Requires count < kMost. A one-sided sheet is asleep at first.
    void add(const OwnedObstacle& what, const HalfSpace& plane, bool is_one_sided) noexcept {
        tick_assert(count < kMost);
        const auto i = static_cast<std::size_t>(count++);
        planes[i] = plane;
        obstacles[i] = what.obstacle;
        owners[i] = what.body;
        looked_ahead[i] = 0;
        sheets[i] = is_one_sided ? Sheet::Asleep : Sheet::No;
        if (!is_one_sided) return;
        planes[i].offset_m = kNoCut_m;
        ++one_sided;
    }

    // Call it before candidates are gathered again. It stores which sheets are awake, so that they stay awake even if a
    // moving body has just come nearer than the proxy's radius.
    void remember_awake() noexcept {
        awake_count = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            if (sheets[i] == Sheet::Awake) awake[static_cast<std::size_t>(awake_count++)] = of(i);
    }
    bool was_awake(std::size_t i) const noexcept {
        const auto end = awake.begin() + awake_count;
        return std::find(awake.begin(), end, of(i)) != end;
    }

    // Drops the cuts of every body for which leaves(owner) returns true. The other cuts keep their order.
    template <class Leaves>
    void drop_of(const Leaves& leaves) noexcept {
        std::size_t to = 0;
        for (std::size_t from = 0; from < static_cast<std::size_t>(count); ++from) {
            if (leaves(owners[from])) {
                one_sided -= sheets[from] != Sheet::No;
                continue;
            }
            planes[to] = planes[from];
            obstacles[to] = obstacles[from];
            owners[to] = owners[from];
            own_planes[to] = own_planes[from];
            looked_ahead[to] = looked_ahead[from];
            sheets[to] = sheets[from];
            ++to;
        }
        count = static_cast<int>(to);
        tick_assert(one_sided >= 0 && one_sided <= count);
    }
};

}  // namespace handrail::render
