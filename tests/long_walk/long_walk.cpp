// Moves a hand at random through quake-e1m1.map at 1 m/s, with a proxy of 5 mm radius and without friction. A judge
// checks every tick.
// The judge shares nothing with the renderer except the planes of the brushes. The proxy must never cross a surface or
// lose a contact. The force must not jump, unless a proxy that rolls off an edge explains the jump.
//   long_walk [TICKS] [SEED]
// 20,000,000 ticks take minutes; ctest runs a short walk. The program exits with status 1 at the first violation.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <random>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/bench/walked_scene.h"
#include "tests/support/names.h"
#include "tests/support/reference_proxy.h"
#include "tests/support/solver_probe.h"

namespace handrail::test {
namespace {

constexpr double kRadius_m = 0.005, kStiffness_n_per_m = 1000.0;
constexpr double kTether_m = 0.010;  // greatest distance of the hand from the proxy: a force of 10 N
constexpr double kCell_m = 0.5;

// A grid of the touchable solids, which checks the proxy. Each cell lists every solid whose bounds, grown by kReach_m,
// overlap the cell.
class Judge {
public:
    explicit Judge(const Scene& scene) {
        for (const Solid& solid : scene.solids)
            if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) solids_.push_back(&solid.shape);
        for (const ConvexSolid* solid : solids_) all_.include(solid->bounds_m);
        all_.min_m -= Vec3(1.0);
        all_.max_m += Vec3(1.0);
        for (int axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<long>(all_.size_m()[axis] / kCell_m) + 1;
        table_.resize(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]));
        for (std::uint32_t s = 0; s < solids_.size(); ++s) {
            const auto low = cell_of(solids_[s]->bounds_m.min_m - Vec3(kReach_m)),
                       high = cell_of(solids_[s]->bounds_m.max_m + Vec3(kReach_m));
            for (long x = low[0]; x <= high[0]; ++x)
                for (long y = low[1]; y <= high[1]; ++y)
                    for (long z = low[2]; z <= high[2]; ++z) table_[index({x, y, z})].push_back(s);
        }
    }

    static constexpr double kReach_m = 0.05;

    // Returns whether the distance of `p` from every solid is at least `least`, which is at most kReach_m. For almost
    // all solids, a single plane proves the distance. For the others, the judge tries every face, edge and corner in
    // long double.
    bool clear(const Vec3& p, double least) {
        for (const std::uint32_t s : table_[index(cell_of(p))]) {
            double out = -1e9;
            for (const Plane& plane : solids_[s]->planes) out = std::max(out, signed_distance(plane, p));
            if (out >= least) continue;
            ++measured_;
            if (nearest_on_solid(solids_[s]->planes, LVec(p)).distance < static_cast<long double>(least)) return false;
        }
        return true;
    }
    bool knows(const Vec3& p) const {
        return glm::all(glm::greaterThan(p, all_.min_m)) && glm::all(glm::lessThan(p, all_.max_m));
    }
    // Returns all solids near `p`, for the continuous reference solution.
    BruteForce around(const Vec3& p) const {
        BruteForce near;
        for (const std::uint32_t s : table_[index(cell_of(p))]) {
            std::vector<Vec3> corners;
            for (const Polygon& face : solids_[s]->faces)
                corners.insert(corners.end(), face.points_m.begin(), face.points_m.end());
            double out = -1e9;
            for (const Plane& plane : solids_[s]->planes) out = std::max(out, signed_distance(plane, p));
            if (out < kReach_m) near.add_solid(solids_[s]->planes, corners);
        }
        return near;
    }
    std::size_t solids() const { return solids_.size(); }
    long measured() const { return measured_; }

private:
    using Cell = std::array<long, 3>;
    Cell cell_of(const Vec3& p) const {
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] =
                std::clamp(static_cast<long>((p[axis] - all_.min_m[axis]) / kCell_m), 0L, cells_[axis] - 1);
        return cell;
    }
    std::size_t index(const Cell& c) const {
        return static_cast<std::size_t>((c[0] * cells_[1] + c[1]) * cells_[2] + c[2]);
    }

    std::vector<const ConvexSolid*> solids_;
    Aabb all_;
    long cells_[3]{};
    std::vector<std::vector<std::uint32_t>> table_;
    long measured_ = 0;
};

struct Walker {
    std::mt19937 random;
    Vec3 direction{1, 0, 0};
    int left = 0, stuck = 0;

    double unit() { return static_cast<double>(random()) / 4294967296.0; }
    // Returns the hand's next position, one millisecond later at 1 m/s. Three of four directions lead along the touched
    // surface.
    Vec3 step(const Vec3& goal, const Vec3& proxy, const std::optional<Vec3>& normal) {
        if (--left <= 0 || stuck > 100) {
            do {
                const double x = 2 * unit() - 1, y = 2 * unit() - 1, z = 2 * unit() - 1;
                direction = Vec3(x, y, z);
            } while (glm::dot(direction, direction) < 0.1 || glm::dot(direction, direction) > 1.0);
            if (normal && random() % 4 != 0)
                direction -= *normal * (glm::dot(direction, *normal) + 0.3 * glm::length(direction));
            direction = glm::normalize(direction);
            left = 200 + static_cast<int>(1300 * unit());
            stuck = 0;
        }
        Vec3 next = goal + direction * 1e-3;
        const double away = glm::length(next - proxy);
        if (away > kTether_m) next = proxy + (next - proxy) * (kTether_m / away);
        return next;
    }
};

struct Findings {
    long touching = 0, jumps = 0, capped = 0;
    double largest_jump_n = 0.0, way_m = 0.0;
};

// Returns whether a continuous movement explains a jump of the force. The reference is a proxy that moves continuously
// from the same place to the same goal. The jump is explained if the reference comes at least as near to the goal and
// moves as far. Nine tenths of the distance are enough, because the speed cap may stop the proxy next to the direct
// path.
bool explained(const Judge& judge, const Vec3& before, const Vec3& goal, const Vec3& after) {
    const BruteForce near = judge.around(before);
    ReferenceProxy reference(near, before, kRadius_m);
    const Vec3 end = reference.follow(goal);
    return glm::length(end - before) >= 0.9 * glm::length(after - before) &&
           glm::length(end - goal) <= glm::length(after - goal) + 1e-5;
}

int run(long ticks, std::uint32_t seed) {
    int status = 0;
    const std::optional<Scene> scene = walked_scene(status);
    if (!scene) return status;
    const auto haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    Judge judge(*scene);
    TouchTuning tuning;
    tuning.radius_m = kRadius_m;
    tuning.rated_stiffness_n_per_m = kStiffness_n_per_m;
    tuning.default_stiffness_fraction = 1.0;
    TouchState state;
    Walker walker{std::mt19937(seed)};
    Vec3 goal = scene->starts.front().feet_m + Vec3(0, 0, 1.0), proxy = goal, force(0.0);
    std::optional<Vec3> normal;
    Findings found;
    const auto begun = std::chrono::steady_clock::now();
    const auto broken = [&](long tick, const std::string& what) {
        std::cout << fmt::format("seed {}, tick {}: {} (ball {} {} {}, hand {} {} {})\n", seed, tick, what, proxy.x,
                                 proxy.y, proxy.z, goal.x, goal.y, goal.z);
        return 1;
    };
    for (long i = 0; i < ticks; ++i) {
        // Every fifty seconds, puts the hand elsewhere, so that one walk covers the whole building.
        if (i % 50000 == 0 && i > 0) {
            const Start& start = scene->starts[walker.random() % scene->starts.size()];
            goal = proxy = start.feet_m + Vec3(0, 0, 0.5 + walker.unit());
            state.reset();
            normal.reset();
            force = Vec3(0.0);
        }
        const Vec3 goal_before = goal, proxy_before = proxy, force_before = force;
        goal = walker.step(goal, proxy, normal);
        const TouchResult r = touch_tick(state, *haptic, tuning, goal, 1e-3);
        proxy = r.proxy_m;
        force = r.force_n;
        if (r.contacts.ghosted) continue;
        // Both ends of every segment of the proxy's path must be at least a radius away from all solids. If such a
        // segment is shorter than two radii, it cannot pass through a wall.
        const SolverProbe solver(state.solver());
        for (int k = 1; k < solver.path_size(); ++k) {
            if (glm::length(solver.path_m(k) - solver.path_m(k - 1)) >= 2 * kRadius_m)
                return broken(i, "a piece of way is longer than the ball");
            if (!judge.clear(solver.path_m(k), r.radius_m - 1e-9)) return broken(i, "the ball's way is in a solid");
        }
        if (!judge.knows(proxy)) return broken(i, "the ball left the world");
        if (!judge.clear(proxy, r.radius_m - 1e-9)) return broken(i, "the ball is in a solid");
        const bool pulled = glm::length(proxy - goal) > 1e-9;
        if (pulled && !r.contacts.capped && (r.contacts.count == 0 || force == Vec3(0.0)))
            return broken(i, "the hand is held by nothing");
        if (!pulled && !judge.clear(goal, kRadius_m - 1e-9)) return broken(i, "contact was lost");
        found.touching += r.contacts.count > 0;
        found.capped += r.contacts.capped;
        found.way_m += glm::length(goal - goal_before);
        // If the hand moves by a millimetre, the force changes by a newton at most. A greater change is a jump.
        const double jump_n = glm::length(force - force_before);
        if (i % 50000 != 0 && jump_n > std::max(1.0, kStiffness_n_per_m * glm::length(goal - goal_before)) + 1e-6) {
            ++found.jumps;
            found.largest_jump_n = std::max(found.largest_jump_n, jump_n);
            // On a tick on which the speed cap stops the proxy, the proxy has not reached its resting place. It may be
            // one capped step away from the direct path.
            const double on_its_way_n =
                r.contacts.capped ? kStiffness_n_per_m * (glm::length(goal - goal_before) + tuning.slide_cap_hand_m)
                                  : 0.0;
            if (jump_n > on_its_way_n && !explained(judge, proxy_before, goal, proxy))
                return broken(i, fmt::format("the force jumped by {:.2f} N where no edge explains it", jump_n));
        }
        normal =
            r.contacts.count > 0 ? std::optional<Vec3>(r.contacts.contacts[r.contacts.strongest].normal) : std::nullopt;
        walker.stuck = glm::length(r.slide_m) < 2.5e-5 ? walker.stuck + 1 : 0;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    std::cout << fmt::format(
        "seed {}: {} ticks over {} solids, {:.0f} m of hand, {:.1f} % touching, {} speed-capped; no crossing, no lost "
        "contact; {} jumps above 1 N, the largest "
        "{:.2f} N, "
        "all of them slips off an edge; {} exact distances; {:.0f} s\n",
        seed, ticks, judge.solids(), found.way_m,
        100.0 * static_cast<double>(found.touching) / static_cast<double>(ticks), found.capped, found.jumps,
        found.largest_jump_n, judge.measured(), seconds);
    return 0;
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    const std::uint32_t seed =
        argc > 2 ? static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)) : std::random_device{}() % 1000000U;
    return handrail::test::run(argc > 1 ? std::atol(argv[1]) : 20000000L, seed);
}
