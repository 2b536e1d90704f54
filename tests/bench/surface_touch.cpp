// Measures the cost of each method of rendering a surface. The proxy slides over a floor or over a tessellated sphere.
// The floor is plain (with friction), without friction, with friction that weakens, damped, guarded, rounded at its
// edges, a sheet, a one-sided sheet, or textured. The sphere is faceted or shaded. Under callgrind, instructions.sh
// counts the instructions of measured_ticks().
//   surface_touch TICKS
//   plain|slippery|weakening|damped|guarded|rounded|sheet|one-sided|friction|sine|square|picture|facets|shaded
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/sphere_mesh.h"

namespace handrail::test {
namespace {

// callgrind starts and stops counting at this function, which it finds by its name. The function must contain nothing
// else.
[[gnu::noinline]] double measured_ticks(const HapticScene& scene, const TouchTuning& tuning,
                                        const std::vector<Vec3>& goals, TouchState& state) {
    double checksum = 0.0;
    for (const Vec3& goal : goals) checksum += touch_tick(state, scene, tuning, goal, 1e-3).force_n.x;
    return checksum;
}

std::shared_ptr<const HapticScene> floor_of(const std::string& kind) {
    Relief relief;
    relief.depth_hand_m = 4e-4;
    relief.friction_share = kind == "friction" ? 0.3 : 0.0;
    relief.kind = kind == "sine"      ? ReliefKind::Sine
                  : kind == "square"  ? ReliefKind::Square
                  : kind == "picture" ? ReliefKind::Picture
                                      : ReliefKind::Level;
    std::vector<float> depths(128 * 128);
    for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = static_cast<float>(i * 7919 % 101) * 0.01F;
    relief.picture = std::make_shared<const HeightField>(128, 128, depths);
    const bool textured = kind == "friction" || kind == "sine" || kind == "square" || kind == "picture";
    HapticMaterial material;
    material.friction_static = material.friction_kinetic = kind == "slippery" ? 0.0 : 0.3;
    if (kind == "weakening") material.friction_static = 0.5;
    if (kind == "damped") material.damping_ns_per_m = 5.0;
    material.relief = textured ? 0 : -1;
    HapticSceneBuilder builder({material});
    const Aabb box{{-5, -5, -1}, {5, 5, 0}};
    const std::array<Vec3, 4> top{Vec3(-5, -5, 0), Vec3(5, -5, 0), Vec3(5, 5, 0), Vec3(-5, 5, 0)};
    if (kind == "sheet" || kind == "one-sided") {
        builder.add_polygon(top, SurfaceLabel{}, kind == "sheet" ? TouchSide::Both : TouchSide::Front);
    } else if (kind == "rounded") {
        const std::array<Plane, 6> planes{Plane{{1, 0, 0}, 5},  Plane{{-1, 0, 0}, 5}, Plane{{0, 1, 0}, 5},
                                          Plane{{0, -1, 0}, 5}, Plane{{0, 0, 1}, 0},  Plane{{0, 0, -1}, 1}};
        const SurfaceLabel label;
        builder.add_solid(planes, box, std::span(&label, 1), 0.003);
    } else {
        builder.add_box(box);
    }
    if (textured) builder.set_reliefs({relief});
    return builder.build();
}

int run(int ticks, const std::string& kind) {
    TouchTuning tuning;
    std::vector<Vec3> goals;
    std::shared_ptr<const HapticScene> scene;
    if (kind == "facets" || kind == "shaded") {
        HapticSceneBuilder builder;
        builder.add_mesh(sphere_mesh(22, 0.5));
        if (kind == "shaded") builder.shade_meshes();
        scene = builder.build();
        goals = sphere_slide(0.5, tuning.radius_m, 0.2, ticks);
    } else {
        scene = floor_of(kind);
        tuning.passivity_guard = kind == "guarded";
        for (int i = 0; i < ticks; ++i)
            goals.emplace_back(0.1 * std::sin(1e-3 * i), 0.1 * std::sin(7e-4 * i),
                               std::max(0.005 - 0.003 - 5e-4 * std::sin(5e-3 * i), 0.02 - 2e-4 * i));
    }
    TouchState state;
    std::cout << kind << ": checksum " << measured_ticks(*scene, tuning, goals, state) << " over " << ticks
              << " ticks\n";
    return 0;
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    return handrail::test::run(argc > 1 ? std::atoi(argv[1]) : 2000, argc > 2 ? argv[2] : "picture");
}
