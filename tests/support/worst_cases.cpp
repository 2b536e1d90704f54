#include "tests/support/worst_cases.h"

#include <cmath>
#include <random>
#include <utility>

#include "tests/support/names.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace {

Vec3 in_box(std::mt19937& random, double half_m) {
    const double x = unit(random), y = unit(random), z = unit(random);
    return (Vec3(x, y, z) * 2.0 - 1.0) * half_m;
}

// Makes a hundred thousand triangles of about 20 mm in a cube of 0.7 m. The hand starts in the middle and changes its
// direction twenty times a second, so that it drags the proxy around.
WorstCase soup(double proxy_radius_m, int ticks) {
    WorstCase out;
    std::mt19937 random(1);
    HapticSceneBuilder builder;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 at = in_box(random, 0.35);
        const Vec3 a = in_box(random, 0.012), b = in_box(random, 0.012), c = in_box(random, 0.012);
        builder.add_triangle(at + a, at + b, at + c);
    }
    out.scene = builder.build();
    out.tuning.radius_m = proxy_radius_m;
    Vec3 at(0.0), way(5e-3, 0.0, 0.0);
    for (int i = 0; i < ticks; ++i) {
        if (i % 50 == 0) way = glm::normalize(in_box(random, 1.0) - at * 2.0) * 5e-3;
        out.goals_m.push_back(at += way);
    }
    return out;
}

// Makes sheets that nearly coincide, each with a slightly different tilt. The hand pokes through them and slides on
// them at up to 1 m/s.
WorstCase sheets(int ticks) {
    WorstCase out;
    std::mt19937 random(3);
    HapticSceneBuilder builder;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 tilt = in_box(random, 0.02);
        builder.add_triangle({-1, -1, tilt.x}, {1, -1, tilt.y}, {0, 2, tilt.z});
    }
    out.scene = builder.build();
    for (int i = 0; i < ticks; ++i) {
        const double t = 2.0 * kPi * i / 1000.0;
        out.goals_m.emplace_back(0.1 * std::sin(t), 0.1 * std::sin(2.0 * t), 0.005 + 0.03 * std::cos(3.0 * t));
    }
    return out;
}

// Makes spheres of 100,820 triangles whose surfaces all pass near the proxy. They approach it and move away again.
WorstCase meshes(int bodies, int ticks) {
    WorstCase out;
    std::mt19937 random(2);
    HapticSceneBuilder shape;
    shape.add_mesh(sphere_mesh(71, 0.3));
    const auto sphere = shape.build();
    HapticSceneBuilder builder;
    std::vector<Vec3> away;
    for (int b = 0; b < bodies; ++b) {
        Vec3 out_of(0.0);
        do out_of = in_box(random, 1.0);
        while (glm::length(out_of) > 1.0 || glm::length(out_of) < 0.1 ||
               out_of.z > -0.2);  // only from below, so that the proxy can be pushed upwards
        away.push_back(glm::normalize(out_of));
        builder.add_body(FeatureId{static_cast<std::uint32_t>(b)}, sphere,
                         {away.back() * 0.33, normalized({unit(random), unit(random), unit(random), 1.0}), 1.0});
    }
    out.scene = builder.build();
    for (int i = 0; i < ticks; ++i)
        out.goals_m.emplace_back(0.004 * std::sin(1e-2 * i), 0.004 * std::cos(1.3e-2 * i), 0.0);
    out.move = [away](std::size_t tick, std::vector<BodyPose>& poses) {
        for (std::size_t b = 0; b < poses.size(); ++b) {
            poses[b].at.rotation = rotation_about({0, 0, 1}, 2e-3 * static_cast<double>(tick));
            poses[b].at.position_m = away[b] * (0.3125 + 0.0175 * std::cos(2.0 * kPi * static_cast<double>(tick) /
                                                                           (400.0 + 10.0 * static_cast<double>(b))));
        }
    };
    return out;
}

// Makes boxes of 0.1 m within a sphere of 0.5 m, each moving on its own circle. The hand goes to and fro through their
// middle.
WorstCase boxes(int bodies, int ticks) {
    WorstCase out;
    std::mt19937 random(5);
    HapticSceneBuilder shape;
    shape.add_box({Vec3(-kBox_m / 2.0), Vec3(kBox_m / 2.0)});
    const auto box = shape.build();
    HapticSceneBuilder builder;
    std::vector<Vec3> middles;
    for (int b = 0; b < bodies; ++b) {
        Vec3 at(0.0);
        do at = in_box(random, 0.5);
        while (glm::length(at) > 0.5 || glm::length(at) < 0.12);
        middles.push_back(at);
        builder.add_body(FeatureId{static_cast<std::uint32_t>(b)}, box, {at, {}, 1.0});
    }
    out.scene = builder.build();
    for (int i = 0; i < ticks; ++i) out.goals_m.emplace_back(0.3 * std::sin(6e-3 * i), 0.02 * std::sin(2e-2 * i), 0.0);
    out.move = [middles](std::size_t tick, std::vector<BodyPose>& poses) {
        for (std::size_t b = 0; b < poses.size(); ++b) {
            const double turn = 4e-3 * static_cast<double>(tick) + static_cast<double>(b);
            poses[b].at.rotation = rotation_about({0, 0, 1}, turn);
            poses[b].at.position_m = middles[b] + 0.02 * Vec3(std::cos(turn), std::sin(turn), 0.0);
        }
    };
    return out;
}

WorstCase sphere(double proxy_radius_m, double speed_m_per_s, int ticks) {
    WorstCase out;
    HapticSceneBuilder builder;
    builder.add_mesh(sphere_mesh(224, 0.5));
    out.scene = builder.build();
    out.goals_m = sphere_slide(0.5, proxy_radius_m, speed_m_per_s, ticks + 100);
    out.goals_m.erase(out.goals_m.begin(), out.goals_m.begin() + 100);
    return out;
}

WorstCase mesh_that_comes(int ticks) {
    WorstCase out;
    HapticSceneBuilder shape;
    shape.add_mesh(sphere_mesh(71, 0.3));
    HapticSceneBuilder builder;
    builder.add_body(FeatureId{1}, shape.build(), {Vec3(0.0, 0.0, -0.35), {}, 1.0});
    out.scene = builder.build();
    for (int i = 0; i < ticks; ++i) out.goals_m.emplace_back(0.0);
    out.move = [](std::size_t tick, std::vector<BodyPose>& poses) {
        const double t = 1e-3 * static_cast<double>(tick);
        poses[0].at.position_m = Vec3(0.02 * std::sin(5.0 * t), 0.0, -0.31 - 0.02 * std::cos(10.0 * t));
        poses[0].at.rotation = rotation_about(glm::normalize(Vec3(1.0, 2.0, 0.5)), 3.0 * t);
    };
    return out;
}

}  // namespace

WorstCase worst_case(int number, int ticks) {
    constexpr const char* kNames[kWorstCases] = {"soup of 1e5 triangles at 5 m/s",
                                                 "3,000 sheets in one place",
                                                 "20 overlapping mesh bodies",
                                                 "128 overlapping mesh bodies",
                                                 "a million triangles, ball of 10 cm",
                                                 "a million triangles at 1 m/s",
                                                 "a mesh body of 1e5 triangles that comes and turns",
                                                 "500 boxes that move",
                                                 "2,000 boxes that move",
                                                 "soup of 1e5 triangles, ball of 0.2 mm"};
    WorstCase out = number == 0   ? soup(0.002, ticks)
                    : number == 1 ? sheets(ticks)
                    : number == 2 ? meshes(20, ticks)
                    : number == 3 ? meshes(128, ticks)
                    : number == 4 ? sphere(0.05, 5.0, ticks)
                    : number == 5 ? sphere(0.005, 1.0, ticks)
                    : number == 6 ? mesh_that_comes(ticks)
                    : number == 7 ? boxes(500, ticks)
                    : number == 8 ? boxes(2000, ticks)
                                  : soup(0.0002, ticks);
    out.name = kNames[number];
    out.tuning.rated_stiffness_n_per_m = 1000.0;
    out.tuning.default_stiffness_fraction = 1.0;
    if (number == 4) {
        out.tuning.radius_m = 0.05;
        out.tuning.world_m_per_hand_m = 10.0;
    }
    return out;
}

}  // namespace handrail::test
