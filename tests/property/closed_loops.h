// Makes closed paths of a hand and measures the energy that a scene gives to the hand on them (invariant I11). The
// caller's random generator makes the paths reproducible.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/property/replay.h"
#include "tests/support/names.h"

namespace handrail::test {

inline constexpr double kStiffness_n_per_m = 1000.0;  // stiffness of plain_tuning()

// Returns a smooth closed path around `middle`, made of a few harmonics with random phases. Each coordinate stays
// within `reach_m`.
inline std::vector<Vec3> closed_loop(std::mt19937& random, const Vec3& middle, const Vec3& reach_m, double seconds) {
    std::uniform_real_distribution<double> phase(0.0, 2.0 * kPi), weight(0.2, 1.0);
    constexpr int kHarmonics = 5;
    std::array<std::array<double, kHarmonics>, 3> phases, weights;
    for (int axis = 0; axis < 3; ++axis) {
        double sum = 0.0;
        for (int k = 0; k < kHarmonics; ++k) {
            phases[axis][k] = phase(random);
            weights[axis][k] = weight(random) / (k + 1);
            sum += weights[axis][k];
        }
        for (double& w : weights[axis]) w /= sum;
    }
    const int ticks = static_cast<int>(seconds * 1000.0);
    std::vector<Vec3> goals;
    for (int i = 0; i <= ticks; ++i) {
        Vec3 goal = middle;
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 0; k < kHarmonics; ++k)
                goal[axis] +=
                    reach_m[axis] * weights[axis][k] * std::sin(2.0 * kPi * (k + 1) * i / ticks + phases[axis][k]);
        goals.push_back(goal);
    }
    return goals;
}

// Returns the same loop, but beginning and ending at its point farthest from all obstacles. No compressed spring then
// stores energy at either end.
inline std::vector<Vec3> begun_in_the_open(const HapticScene& scene, std::vector<Vec3> goals) {
    std::size_t best = 0;
    double widest = -1.0;
    for (std::size_t i = 0; i < goals.size(); i += 50) {
        double clearance = 1e9;
        for (std::uint32_t o = 0; o < scene.obstacles.size(); ++o)
            clearance = std::min(clearance, scene.closest(o, goals[i] - scene.origin_m).distance_m);
        if (clearance > widest) {
            widest = clearance;
            best = i;
        }
    }
    EXPECT_GT(widest, 0.006) << "this loop is never in the open";
    goals.pop_back();
    std::rotate(goals.begin(), goals.begin() + static_cast<std::ptrdiff_t>(best), goals.end());
    goals.push_back(goals.front());
    return goals;
}

inline std::vector<Vec3> with_quantum(std::vector<Vec3> goals, double quantum_m) {
    for (Vec3& goal : goals) goal = glm::round(goal / quantum_m) * quantum_m;
    return goals;
}

struct Loop {
    double energy_j = 0.0;   // energy given to the hand, by the trapezoidal rule
    double allowed_j = 0.0;  // greatest error of the trapezoidal rule where contacts begin or end (I11)
    double edges_j = 0.0;    // the same error where the proxy passed from one facet to the next
    double largest_n = 0.0, largest_jump_n = 0.0;
};

inline Loop run(const HapticScene& scene, const std::vector<Vec3>& goals, const TouchTuning& tuning) {
    Loop loop;
    Vec3 last_force(0.0), last_goal(0.0);
    Vec3 last_normal(0.0);
    int last_count = 0;
    bool first = true;
    replay(scene, goals, {}, tuning, [&](std::size_t, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
        const Vec3 normal = r.contacts.count > 0 ? r.contacts.contacts[r.contacts.strongest].normal : Vec3(0.0);
        if (!first) {
            const double way = glm::length(goal - last_goal), change = glm::length(r.force_n - last_force);
            loop.energy_j += 0.5 * glm::dot(last_force + r.force_n, goal - last_goal);
            loop.largest_jump_n = std::max(loop.largest_jump_n, change);
            // The force changes its slope within the step. The error is at most half the change of force times the
            // path, or K |dg|^2 / 8 where a plain contact begins.
            if (r.contacts.count != last_count)
                loop.allowed_j += std::max(kStiffness_n_per_m * way * way / 8.0, 0.5 * std::min(change, 1.0) * way);
            else if (glm::dot(normal, last_normal) < 1.0 - 1e-6)
                loop.edges_j += std::max(kStiffness_n_per_m * way * way / 8.0, 0.5 * std::min(change, 1.0) * way);
        }
        last_normal = normal;
        loop.largest_n = std::max(loop.largest_n, glm::length(r.force_n));
        last_count = r.contacts.count;
        first = false;
        last_force = r.force_n;
        last_goal = goal;
    });
    loop.allowed_j += 1e-9 * kStiffness_n_per_m;
    return loop;
}

}  // namespace handrail::test
