// Generates a path of a hand that moves through a building and slides along walls, floors and objects. Instruction
// counts and benchmarks use the path. The same scene gives the same path on every machine.
#pragma once

#include <random>

#include "haptic/render/touch.h"
#include "tests/support/names.h"

namespace handrail::test {

// Returns goals at 1 kHz from `start_m`. The hand moves straight at walking speed (1 m/s) until it touches a surface.
// Then it follows the surface at 0.25 m/s and up to 3 mm deep. It changes to a new direction every 0.4 to 1.6 s, or
// when the proxy is stuck. Three of four directions keep to the surface; the fourth may lead away from it.
inline std::vector<Vec3> record_walk(const HapticScene& scene, const TouchTuning& tuning, const Vec3& start_m,
                                     int ticks, std::uint32_t seed = 1996) {
    // Depth of the press; path per tick when walking; path per tick when sliding; path per tick below which the proxy
    // is stuck.
    constexpr double kDepth_m = 3e-3, kWalk_m = 1e-3, kFeel_m = 2.5e-4, kStuck_m = 2.5e-5;
    std::mt19937 random(seed);
    const auto unit = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    TouchState state;
    std::vector<Vec3> goals;
    Vec3 goal = start_m, proxy = start_m, direction(1, 0, 0), normal(0.0);
    int left = 1, stuck = 0;
    for (int i = 0; i < ticks; ++i) {
        if (left <= 0 || stuck > 100) {
            do {
                // The numbers are drawn in separate statements, because compilers evaluate arguments in different
                // orders.
                const double z = 2 * unit() - 1, y = 2 * unit() - 1, x = 2 * unit() - 1;
                direction = {x, y, z};
            } while (glm::dot(direction, direction) < 0.1 || glm::dot(direction, direction) > 1.0);
            if (random() % 4 != 0) direction -= normal * (glm::dot(direction, normal) + 0.3 * glm::length(direction));
            direction = glm::normalize(direction);
            left = 400 + static_cast<int>(1200 * unit());
            stuck = 0;
        }
        const bool touching = normal != Vec3(0.0);
        goal += direction * (touching ? kFeel_m : kWalk_m);
        const double depth = glm::length(goal - proxy);
        if (touching && depth > kDepth_m) goal = proxy + (goal - proxy) * (kDepth_m / depth);
        goals.push_back(goal);
        const TouchResult r = touch_tick(state, scene, tuning, goal, 1e-3);
        const bool holds = r.contacts.count > 0;
        normal = holds ? r.contacts.contacts[r.contacts.strongest].normal : Vec3(0.0);
        left -= holds ? 1 : 0;
        stuck = glm::length(r.slide_m) < kStuck_m ? stuck + 1 : 0;
        proxy = r.proxy_m;
    }
    return goals;
}

}  // namespace handrail::test
