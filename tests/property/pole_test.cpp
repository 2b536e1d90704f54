// Tests how accurate the force is if very many triangles meet in one point, as at the pole of a sphere of meridians.
// All of these triangles can be candidates.
#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace pole_test {

constexpr double kSphere_m = 0.5;

struct OverPole {
    double direction_rms_degrees = 0.0, jump_rms_n = 0.0, truncated_share = 0.0, nearest_m = 1.0;
};

OverPole slide_over_pole(int sectors, int ticks) {
    HapticSceneBuilder builder;
    builder.add_mesh(pole_mesh(sectors, 16, 3e-3, kSphere_m));
    const auto scene = builder.build();
    TouchTuning tuning;
    tuning.override_stiffness_n_per_m = 1000.0;
    TouchState state;
    OverPole out;
    Vec3 last(0.0);
    double angles2 = 0.0, jumps2 = 0.0;
    int count = 0, truncated = 0;
    bool has_last = false;
    for (const Vec3& goal : pole_slide(kSphere_m, tuning.radius_m, 0.2, ticks)) {
        const TouchResult r = touch_tick(state, *scene, tuning, goal, 1e-3);
        out.nearest_m = std::min(out.nearest_m, glm::length(r.proxy_m) - kSphere_m);
        if (r.contacts.count == 0 || glm::length(Vec2(goal)) >= 0.01) {
            has_last = false;
            continue;
        }
        const double angle =
            std::atan2(glm::length(glm::cross(r.force_n, goal)), glm::dot(r.force_n, goal)) * 180.0 / kPi;
        angles2 += angle * angle;
        if (has_last) jumps2 += glm::dot(r.force_n - last, r.force_n - last);
        last = r.force_n;
        has_last = true;
        ++count;
        truncated += r.contacts.truncated;
    }
    out.direction_rms_degrees = std::sqrt(angles2 / count);
    out.jump_rms_n = std::sqrt(jumps2 / count);
    out.truncated_share = static_cast<double>(truncated) / count;
    return out;
}

// Measured: 0.61 degrees for 500 triangles and 0.68 for 1,000. Before the work of a tick was bounded, the limit of this
// test was half a degree, and 0.44 and 0.22 degrees were measured. Examining a thousand triangles takes most of the
// work that a tick may do. The remaining rounds are then made in the next ticks.
TEST(Pole, with_as_many_triangles_as_candidates_is_felt_within_seven_tenths_of_a_degree) {
    for (const int sectors : {500, 1000}) {
        const OverPole over = slide_over_pole(sectors, 8000);
        std::cout << fmt::format("{} triangles: {:.3f} degrees, {:.4f} N a tick rms\n", sectors,
                                 over.direction_rms_degrees, over.jump_rms_n);
        EXPECT_LE(over.direction_rms_degrees, 0.7) << sectors;
        EXPECT_LE(over.jump_rms_n, 0.025) << sectors;
        EXPECT_GE(over.nearest_m, 0.005 - 1e-5) << sectors;  // the facets are up to 3 micrometres inside the sphere
    }
}

// With more triangles than candidates, the proxy waits at a place where it knows all triangles near it. It lags but
// never enters the sphere, and the solver reports the lag.
TEST(Pole, with_more_triangles_than_candidates_holds_the_proxy_back_and_reports_it) {
    const OverPole over = slide_over_pole(2 * ProxySolver::kMaxCandidates, 2000);
    EXPECT_GT(over.truncated_share, 0.1);
    EXPECT_GE(over.nearest_m, 0.005 - 1e-5);
}

}  // namespace pole_test
}  // namespace handrail::test
