#include "worlds/floorplan/plan_walls.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "worlds/floorplan/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::floorplan {
namespace {

constexpr double kStraight_m = 0.03, kNextTo_m = 0.25, kNearWall_m = 0.35;

struct Edge {
    std::uint32_t a = 0, b = 0;  // the corners at the two ends, as indices
    std::vector<std::size_t> spaces;
    bool wall = false;
};

// The outlines of a level as a graph of corners and edges.
class Net {
public:
    std::uint32_t corner(const Vec2& at) {
        const auto key = std::make_pair(std::llround(at.x * 1e3), std::llround(at.y * 1e3));
        const auto [found, is_new] = number_.try_emplace(key, static_cast<std::uint32_t>(at_.size()));
        if (is_new) {
            at_.push_back(at);
            edges_at_.emplace_back();
        }
        return found->second;
    }
    std::uint32_t find(const Vec2& at) const {
        const auto found = number_.find(std::make_pair(std::llround(at.x * 1e3), std::llround(at.y * 1e3)));
        return found == number_.end() ? kNone : found->second;
    }
    void add(std::uint32_t a, std::uint32_t b, std::size_t space) {
        if (a == b) return;
        const auto [found, is_new] =
            edge_number_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(edges_.size()));
        if (is_new) {
            edges_at_[a].push_back(found->second);
            edges_at_[b].push_back(found->second);
            edges_.push_back({std::min(a, b), std::max(a, b), {}});
        }
        std::vector<std::size_t>& spaces = edges_[found->second].spaces;
        if (std::find(spaces.begin(), spaces.end(), space) == spaces.end()) spaces.push_back(space);
    }

    static constexpr std::uint32_t kNone = 0xffffffffU;
    std::vector<Edge>& edges() { return edges_; }
    const Vec2& at(std::uint32_t corner) const { return at_[corner]; }
    const std::vector<std::uint32_t>& edges_at(std::uint32_t corner) const { return edges_at_[corner]; }

private:
    std::map<std::pair<long long, long long>, std::uint32_t> number_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_number_;
    std::vector<Vec2> at_;
    std::vector<std::vector<std::uint32_t>> edges_at_;
    std::vector<Edge> edges_;
};

class Level {
public:
    Level(const FloorPlan& plan, std::size_t level, const std::vector<std::size_t>& here)
        : plan_(plan), level_(level), here_(here), corner_m_(0.5 * plan.wall_m + 0.01), index_(boxes(plan, here)) {}

    LevelWalls build() {
        for (const std::size_t s : here_)
            for (const Ring& ring : plan_.spaces[s].rings)
                for (std::size_t i = 0; i < ring.size(); ++i)
                    net_.add(net_.corner(ring[i]), net_.corner(ring[(i + 1) % ring.size()]), s);
        note_doors();
        for (Edge& edge : net_.edges()) decide(edge);
        make_runs();
        for (const PlanWall& wall : plan_.walls)
            if (wall.level == level_ && glm::length(wall.to - wall.from) > plan_.wall_m) {
                made_.runs.push_back({wall.from, wall.to, {}});
                run_spaces_.emplace_back();
            }
        place_doors();
        cut_gaps();
        return std::move(made_);
    }

private:
    static std::vector<Aabb> boxes(const FloorPlan& plan, const std::vector<std::size_t>& here) {
        std::vector<Aabb> all;
        for (const std::size_t s : here) {
            Aabb box;
            for (const Ring& ring : plan.spaces[s].rings)
                for (const Vec2& p : ring) box.include(Vec3(p, 0.0));
            if (box.empty()) box.include(Vec3(1e9, 1e9, 0.0));
            all.push_back(box);
        }
        return all;
    }

    // Returns the first space that contains the point and is not in `but`. Walled spaces take precedence. Returns
    // kNoSpace if there is none.
    std::size_t space_at(const Vec2& at, const std::vector<std::size_t>& but = {}) {
        index_.find({Vec3(at, -1.0), Vec3(at, 1.0)}, near_);
        std::size_t found = kNoSpace;
        for (const std::uint32_t k : near_) {
            const std::size_t s = here_[k];
            if (std::find(but.begin(), but.end(), s) != but.end() || !inside(plan_.spaces[s].rings, at)) continue;
            if (plan_.spaces[s].walled) return s;
            if (found == kNoSpace) found = s;
        }
        return found;
    }

    void note_doors() {
        for (std::size_t d = 0; d < plan_.doors.size(); ++d) {
            const PlanDoor& door = plan_.doors[d];
            if (std::find(door.levels.begin(), door.levels.end(), level_) == door.levels.end()) continue;
            doors_.push_back(d);
            if (door.kind == PlanDoorKind::Opening || door.along) continue;
            const std::uint32_t corner = net_.find(door.at);
            if (corner == Net::kNone) continue;
            // Recognises a door across a corridor: the borders on both sides of the door separate the same two spaces.
            std::vector<const Edge*> shared;
            for (const std::uint32_t e : net_.edges_at(corner))
                if (net_.edges()[e].spaces.size() > 1) shared.push_back(&net_.edges()[e]);
            if (shared.size() == 2 && shared[0]->spaces == shared[1]->spaces)
                for (const std::uint32_t e : net_.edges_at(corner))
                    if (net_.edges()[e].spaces.size() > 1) across_.insert(e);
        }
    }

    void decide(Edge& edge) {
        const bool walled =
            std::any_of(edge.spaces.begin(), edge.spaces.end(), [&](std::size_t s) { return plan_.spaces[s].walled; });
        const auto number = static_cast<std::uint32_t>(&edge - net_.edges().data());
        edge.wall = walled || across_.contains(number);
        if (edge.wall) return;
        const Vec2 &a = net_.at(edge.a), &b = net_.at(edge.b);
        const double length = glm::length(b - a);
        const Vec2 middle = 0.5 * (a + b);
        std::size_t one = edge.spaces[0], other = edge.spaces.size() > 1 ? edge.spaces[1] : kNoSpace;
        if (other == kNoSpace) {
            const Vec2 side = left_of((b - a) / length) * kNextTo_m;
            const bool own_left = inside(plan_.spaces[one].rings, middle + side);
            other = space_at(own_left ? middle - side : middle + side, {one});
            // The adjoining space has walls of its own, so this edge needs none.
            if (other != kNoSpace && plan_.spaces[other].walled) return;
        }
        if (other == kNoSpace) {
            edge.wall = true;
            return;
        }
        LevelWalls::Open& open = made_.open[std::minmax(one, other)];
        if (length > open.width_m) open.at = middle;
        open.width_m = std::max(open.width_m, length);
    }

    // Joins collinear edges into one wall. A wall ends at a corner where another wall begins.
    void make_runs() {
        std::vector<Edge>& edges = net_.edges();
        std::vector<bool> taken(edges.size(), false);
        const auto next_at = [&](std::uint32_t corner, std::uint32_t from) {
            std::uint32_t found = Net::kNone;
            int count = 0;
            for (const std::uint32_t e : net_.edges_at(corner))
                if (edges[e].wall) {
                    ++count;
                    if (e != from) found = e;
                }
            return count == 2 ? found : Net::kNone;
        };
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (!edges[e].wall || taken[e]) continue;
            taken[e] = true;
            std::vector<std::uint32_t> corners{edges[e].a, edges[e].b}, parts{e};
            for (const bool ahead : {true, false})
                for (;;) {
                    const std::uint32_t end = ahead ? corners.back() : corners.front();
                    const std::uint32_t n = next_at(end, ahead ? parts.back() : parts.front());
                    if (n == Net::kNone || taken[n]) break;
                    const std::uint32_t further = edges[n].a == end ? edges[n].b : edges[n].a;
                    if (!straight(corners, ahead ? corners.front() : further, ahead ? further : corners.back())) break;
                    taken[n] = true;
                    corners.insert(ahead ? corners.end() : corners.begin(), further);
                    parts.insert(ahead ? parts.end() : parts.begin(), n);
                }
            made_.runs.push_back({net_.at(corners.front()), net_.at(corners.back()), {}});
            std::vector<std::size_t> spaces;
            for (const std::uint32_t p : parts)
                spaces.insert(spaces.end(), edges[p].spaces.begin(), edges[p].spaces.end());
            run_spaces_.push_back(std::move(spaces));
        }
    }

    bool straight(const std::vector<std::uint32_t>& corners, std::uint32_t from, std::uint32_t to) const {
        const Vec2 &a = net_.at(from), &b = net_.at(to);
        const double length = glm::length(b - a);
        if (length < 1e-3 || corners.size() > 200) return false;
        const Vec2 along = (b - a) / length;
        double last = 0.0;
        const auto fits = [&](std::uint32_t corner) {
            const Vec2 off = net_.at(corner) - a;
            const double far = glm::dot(off, along);
            if (std::abs(cross(along, off)) > kStraight_m || far < last - 1e-6) return false;
            last = far;
            return true;
        };
        return std::all_of(corners.begin(), corners.end(), fits);
    }

    std::vector<std::size_t> spaces_of(std::size_t d) const {
        const PlanDoor& door = plan_.doors[d];
        const auto at = std::find(door.levels.begin(), door.levels.end(), level_) - door.levels.begin();
        return static_cast<std::size_t>(at) < door.spaces.size() ? door.spaces[static_cast<std::size_t>(at)]
                                                                 : std::vector<std::size_t>();
    }

    void place_doors() {
        std::vector<Aabb> run_boxes;
        for (const WallRun& run : made_.runs) {
            Aabb box{Vec3(glm::min(run.from, run.to), 0.0), Vec3(glm::max(run.from, run.to), 0.0)};
            run_boxes.push_back(grown(box, kNearWall_m));
        }
        const BoxIndex runs(run_boxes);
        std::vector<std::uint32_t> near;
        for (const std::size_t d : doors_) {
            const PlanDoor& door = plan_.doors[d];
            DoorGap gap;
            gap.door = d;
            gap.spaces = spaces_of(d);
            const double wanted_m = std::clamp(door.width_m.value_or(kDoorWide_m), kLeastWay_m, 8.0);
            runs.find({Vec3(door.at, -1.0), Vec3(door.at, 1.0)}, near);
            double best = 1e300;
            for (const std::uint32_t r : near) {
                const WallRun& run = made_.runs[r];
                const double length = glm::length(run.to - run.from);
                const Vec2 along = (run.to - run.from) / length, off = door.at - run.from;
                const double t = glm::dot(off, along), away = std::abs(cross(along, off));
                if (away > kNearWall_m || t < -kNearWall_m || t > length + kNearWall_m) continue;
                if (door.along && std::abs(cross(along, *door.along)) > 0.3) continue;
                const double room = length - 2.0 * corner_m_, width = std::min(wanted_m, room);
                const double at = std::clamp(t, corner_m_ + 0.5 * width,
                                             std::max(length - corner_m_ - 0.5 * width, corner_m_ + 0.5 * width));
                double score = 4.0 * away + 2.0 * std::abs(at - t) + (width < kLeastWay_m ? 20.0 : 0.0) +
                               (wanted_m - std::max(width, 0.0)) - 1e-3 * std::min(length, 100.0);
                for (const std::size_t s : gap.spaces)
                    if (std::find(run_spaces_[r].begin(), run_spaces_[r].end(), s) == run_spaces_[r].end())
                        score += 1.0;
                if (score >= best || width <= 0.3) continue;
                best = score;
                gap.at = run.from + along * at;
                gap.along = along;
                gap.width_m = width;
                gap.in_wall = true;
                gap.moved = std::abs(at - t) > 0.25;
            }
            if (!gap.in_wall) {
                gap.at = door.at;
                gap.width_m = wanted_m;
                if (door.along) gap.along = *door.along;
            }
            const Vec2 side = left_of(gap.along) * (0.5 * plan_.wall_m + kNextTo_m);
            gap.sides = {space_at(gap.at + side), space_at(gap.at - side)};
            if (gap.sides[0] == gap.sides[1]) gap.sides[1] = kNoSpace;
            if (gap.spaces.size() < 2)
                for (const std::size_t s : gap.sides)
                    if (s != kNoSpace && gap.spaces.size() < 2 &&
                        std::find(gap.spaces.begin(), gap.spaces.end(), s) == gap.spaces.end())
                        gap.spaces.push_back(s);
            std::sort(gap.spaces.begin(), gap.spaces.end());
            made_.doors.push_back(std::move(gap));
        }
    }

    double sill_of(const DoorGap& gap) const {
        if (gap.spaces.empty()) return 0.0;
        double most = -1e300;
        for (const std::size_t s : gap.spaces)
            most = std::max(most, plan_.spaces[s].levels.size() == 1 ? plan_.spaces[s].raised_m : 0.0);
        return most;
    }

    // Cuts the gaps of doors into the door's own wall and into walls that coincide with it.
    void cut_gaps() {
        std::vector<Aabb> run_boxes;
        for (const WallRun& run : made_.runs)
            run_boxes.push_back(
                grown({Vec3(glm::min(run.from, run.to), 0.0), Vec3(glm::max(run.from, run.to), 0.0)}, kNearWall_m));
        const BoxIndex runs(run_boxes);
        std::vector<std::uint32_t> near;
        for (const DoorGap& gap : made_.doors) {
            const Vec2 half = gap.along * (0.5 * gap.width_m);
            runs.find(
                {Vec3(glm::min(gap.at - half, gap.at + half), -1.0), Vec3(glm::max(gap.at - half, gap.at + half), 1.0)},
                near);
            for (const std::uint32_t r : near) {
                WallRun& run = made_.runs[r];
                const double length = glm::length(run.to - run.from);
                const Vec2 along = (run.to - run.from) / length, off = gap.at - run.from;
                if (std::abs(cross(along, gap.along)) > 0.17 || std::abs(cross(along, off)) > kNearWall_m) continue;
                // The ends of a wall reach half its thickness beyond its corners. A file may draw a wall in two pieces
                // that meet in the middle of a doorway, so these ends are cut, too.
                const double t = glm::dot(off, along), end_m = 0.5 * plan_.wall_m,
                             from = std::max(t - 0.5 * gap.width_m, -end_m),
                             to = std::min(t + 0.5 * gap.width_m, length + end_m);
                if (to - from > 1e-3) run.gaps.push_back({from, to, kDoorHigh_m, sill_of(gap)});
            }
        }
        for (WallRun& run : made_.runs) {
            std::sort(run.gaps.begin(), run.gaps.end(),
                      [](const WallRun::Gap& a, const WallRun::Gap& b) { return a.from_m < b.from_m; });
            std::vector<WallRun::Gap> joined;
            for (const WallRun::Gap& gap : run.gaps)
                if (!joined.empty() && gap.from_m <= joined.back().to_m + 0.02)
                    joined.back().to_m = std::max(joined.back().to_m, gap.to_m),
                    joined.back().sill_m = std::max(joined.back().sill_m, gap.sill_m);
                else joined.push_back(gap);
            run.gaps = std::move(joined);
        }
    }

    const FloorPlan& plan_;
    std::size_t level_;
    const std::vector<std::size_t>& here_;
    double corner_m_;  // length at each end of a wall that belongs to the wall around the corner
    BoxIndex index_;
    std::vector<std::uint32_t> near_;
    Net net_;
    std::vector<std::size_t> doors_;
    std::set<std::uint32_t> across_;
    std::vector<std::vector<std::size_t>> run_spaces_;
    LevelWalls made_;
};

}  // namespace

LevelWalls walls_of_level(const FloorPlan& plan, std::size_t level, const std::vector<std::size_t>& here) {
    return Level(plan, level, here).build();
}

}  // namespace handrail::floorplan
