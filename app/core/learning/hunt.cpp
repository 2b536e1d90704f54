#include "app/core/learning/hunt.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <queue>
#include <tuple>

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

constexpr double kCell_m = 0.25;
constexpr std::size_t kMostNodes = 40000;
constexpr double kFound_m = 1.0;
constexpr double kClockHeight_m = 1.0;

// Returns where a walker arrives that walks straight from `from_m` to `to_m`. Returns no value if anything blocks the
// walk or there is no ground.
std::optional<Vec3> walks(const WalkerWorld& world, const Vec3& from_m, const Vec3& to_m, const WalkerSize& body) {
    const Vec3 way(to_m.x - from_m.x, to_m.y - from_m.y, 0.0);
    const double length = glm::length(way);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / kCell_m)));
    const WalkerShape shape{body.radius_m, body.height_m - body.step_up_m};
    Vec3 at = from_m;
    for (int i = 1; i <= pieces; ++i) {
        const Vec3 up(0.0, 0.0, body.step_up_m + 0.005);
        const Vec3 on = at + way / static_cast<double>(pieces);
        if (world.trace(at + up, on + up, shape).hit || world.blocked(on + up, shape)) return std::nullopt;
        const TraceHit ground = world.trace(on + up, on - Vec3(0.0, 0.0, body.step_up_m), shape);
        if (!ground.hit || ground.normal.z < 0.7) return std::nullopt;
        at = ground.end_m;
    }
    return at;
}

}  // namespace

HuntGround::HuntGround(const WalkerWorld& doors_open, const Vec3& feet_m, const WalkerSize& body) {
    contract_pre(is_finite(feet_m));
    contract_pre(body.radius_m > 0.0 && body.height_m > 0.0);
    std::map<std::tuple<int, int, int>, std::uint32_t> known;
    const auto key = [&](int x, int y, double z) { return std::tuple(x, y, static_cast<int>(std::lround(z / 0.5))); };
    struct Cell {
        int x, y;
    };
    std::vector<Cell> cells{{0, 0}};
    nodes_.push_back({feet_m, -1.0, {}});
    known.emplace(key(0, 0, feet_m.z), 0U);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
            const Vec3 from = nodes_[i].feet_m;
            const auto to = walks(doors_open, from, from + Vec3(dx * kCell_m, dy * kCell_m, 0.0), body);
            if (!to) continue;
            const int x = cells[i].x + dx, y = cells[i].y + dy;
            // Rounding may give one place two different keys, so the heights half a metre above and below are also
            // tried.
            auto there = known.find(key(x, y, to->z));
            for (const double off : {-0.5, 0.5})
                if (there == known.end()) {
                    const auto near = known.find(key(x, y, to->z + off));
                    if (near != known.end() && std::abs(nodes_[near->second].feet_m.z - to->z) < 0.3) there = near;
                }
            if (there == known.end()) {
                if (nodes_.size() >= kMostNodes) continue;
                there = known.emplace(key(x, y, to->z), static_cast<std::uint32_t>(nodes_.size())).first;
                nodes_.push_back({*to, -1.0, {}});
                cells.push_back({x, y});
            }
            nodes_[i].beside.push_back(there->second);
        }
    measure(0);
}

// Computes the shortest routes along the grid. They are longer than straight routes. The announcement rounds distances
// to whole steps, so the difference is not heard.
void HuntGround::measure(std::uint32_t from) {
    // Some steps are possible in one direction only, such as down a drop. So the search follows the steps backwards
    // from the aim.
    std::vector<std::vector<std::uint32_t>> into(nodes_.size());
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        for (const std::uint32_t next : nodes_[i].beside) into[next].push_back(i);
    for (Node& node : nodes_) node.way_m = -1.0;
    std::deque<std::uint32_t> open{from};
    nodes_[from].way_m = 0.0;
    while (!open.empty()) {
        const std::uint32_t at = open.front();
        open.pop_front();
        for (const std::uint32_t next : into[at])
            if (nodes_[next].way_m < 0.0) {
                nodes_[next].way_m = nodes_[at].way_m + kCell_m;
                open.push_back(next);
            }
    }
}

Vec3 HuntGround::hiding_place(std::uint64_t number, double least_m) const {
    contract_pre(least_m >= 0.0);
    std::vector<std::uint32_t> far;
    std::uint32_t farthest = 0;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].way_m >= least_m) far.push_back(i);
        if (nodes_[i].way_m > nodes_[farthest].way_m) farthest = i;
    }
    if (far.empty()) return nodes_[farthest].feet_m;
    // Mixes the bits by Splitmix64, so that consecutive numbers give places far apart.
    std::uint64_t z = number + 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return nodes_[far[(z ^ (z >> 31)) % far.size()]].feet_m;
}

std::optional<std::uint32_t> HuntGround::nearest(const Vec3& feet_m) const {
    std::optional<std::uint32_t> best;
    double best_m = 0.8;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        const Vec3 way = nodes_[i].feet_m - feet_m;
        const double distance = std::hypot(way.x, way.y) + 2.0 * std::abs(way.z);
        if (distance >= best_m) continue;
        best_m = distance;
        best = i;
    }
    return best;
}

void HuntGround::aim(const Vec3& feet_m) {
    if (const auto at = nearest(feet_m)) measure(*at);
}

std::optional<double> HuntGround::way_m(const Vec3& feet_m) const {
    const auto at = nearest(feet_m);
    if (!at || nodes_[*at].way_m < 0.0) return std::nullopt;
    return nodes_[*at].way_m;
}

std::optional<Vec3> HuntGround::next_m(const WalkerWorld& doors_open, const Vec3& feet_m,
                                       const WalkerSize& body) const {
    auto at = nearest(feet_m);
    if (!at || nodes_[*at].way_m < 0.0) return std::nullopt;
    Vec3 best = nodes_[*at].feet_m;
    for (int i = 0; i < 400 && nodes_[*at].way_m > 0.0; ++i) {
        std::optional<std::uint32_t> onward;
        for (const std::uint32_t next : nodes_[*at].beside)
            if (nodes_[next].way_m >= 0.0 && nodes_[next].way_m < nodes_[*at].way_m &&
                (!onward || nodes_[next].way_m < nodes_[*onward].way_m))
                onward = next;
        if (!onward) break;
        const Vec3 there = nodes_[*onward].feet_m;
        const auto end = walks(doors_open, feet_m, there, body);
        if (end && std::abs(end->z - there.z) < 0.3) best = there;
        else if (i > 8) break;
        at = onward;
    }
    return best;
}

bool finds(const WalkerWorld& world, const Vec3& feet_m, const Vec3& clock_feet_m) {
    const Vec3 way = clock_feet_m - feet_m;
    if (std::hypot(way.x, way.y) > kFound_m || std::abs(way.z) > 0.6) return false;
    const Vec3 up(0.0, 0.0, kClockHeight_m);
    return glm::length(way) < 0.1 || !world.trace(feet_m + up, clock_feet_m + up, WalkerShape{}).hit;
}

}  // namespace handrail::core
