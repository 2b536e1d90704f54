// Tests that surfaces which feel higher or lower than their geometry never give a hand energy (invariant I11). Such
// surfaces are height textures, friction textures and shaded meshes. Random closed loops run over random worlds, with
// smooth positions and with a device's encoder steps. The tests print their seeds.
#include <cmath>

#include "haptic/render/relief.h"
#include "tests/property/closed_loops.h"
#include "tests/support/names.h"
#include "tests/support/sphere_mesh.h"

namespace handrail::test {
namespace surfaces_test {

std::shared_ptr<const HeightField> random_picture(std::mt19937& random) {
    const int width = 8 + static_cast<int>(random() % 57), height = 8 + static_cast<int>(random() % 57);
    std::vector<float> depths(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (float& d : depths)
        d = random() % 3 == 0 ? 1.0F : random() % 2 == 0 ? 0.0F : static_cast<float>(random() % 1000) * 1e-3F;
    return std::make_shared<const HeightField>(width, height, depths);
}

Relief random_relief(std::mt19937& random, ReliefKind kind) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Relief relief;
    relief.kind = kind;
    relief.depth_hand_m = 0.0005 + 0.003 * unit(random);
    relief.period_hand_m = 0.004 + 0.016 * unit(random);
    const double turn = 2.0 * kPi * unit(random);
    relief.turn_cos = std::cos(turn);
    relief.turn_sin = std::sin(turn);
    relief.low_m = relief.high_m = Vec3(unit(random), unit(random), unit(random));
    if (kind == ReliefKind::Picture) {
        relief.picture = random_picture(random);
        relief.size_m = 0.03 + 0.2 * unit(random);
    }
    return relief;
}

// Returns a floor, a wall and a slanted brush that meet, each with its own texture.
std::shared_ptr<const HapticScene> textured_corner(std::mt19937& random, ReliefKind kind, double friction) {
    std::vector<HapticMaterial> materials(4);
    std::vector<Relief> reliefs;
    for (int i = 0; i < 3; ++i) {
        materials[static_cast<std::size_t>(i) + 1].relief = i;
        materials[static_cast<std::size_t>(i) + 1].friction_kinetic = friction;
        reliefs.push_back(random_relief(random, kind));
        if (friction > 0.0) reliefs.back().friction_share = 0.3;
    }
    HapticSceneBuilder builder(materials);
    builder.add_box({{-1, -1, -1}, {0.03, 1, 0}}, SurfaceLabel{kNoFeature, 1, false});
    builder.add_box({{0.06, -1, -1}, {1, 1, 0.02}}, SurfaceLabel{kNoFeature, 2, false});
    const Vec3 slant = glm::normalize(Vec3(0.3, -1.0, 0.4));
    std::vector<Plane> planes{{slant, glm::dot(slant, Vec3(0.0, 0.035, 0.0))},
                              {{0, 1, 0}, 0.5},
                              {{1, 0, 0}, 0.5},
                              {{-1, 0, 0}, 0.5},
                              {{0, 0, 1}, 0.5},
                              {{0, 0, -1}, 0.5}};
    builder.add_solid(planes, {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, SurfaceLabel{kNoFeature, 3, false});
    builder.set_reliefs(std::move(reliefs));
    return builder.build();
}

class TexturedSurface : public ::testing::TestWithParam<ReliefKind> {};

TEST_P(TexturedSurface, gives_no_energy_over_random_closed_loops) {  // invariant I11
    const int loops = scaled(40);
    double worst_j = -1.0, worst_jump_n = 0.0;
    for (int seed = 1; seed <= loops; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        const auto scene = textured_corner(random, GetParam(), 0.0);
        const auto goals = begun_in_the_open(*scene, closed_loop(random, {0.0, 0.0, 0.01}, {0.07, 0.04, 0.03}, 4.0));
        TouchTuning tuning = uncapped_tuning(0.005);
        for (const bool quantised : {false, true}) {
            const Loop loop = run(*scene, quantised ? with_quantum(goals, 6e-5) : goals, tuning);
            worst_j = std::max(worst_j, loop.energy_j);
            worst_jump_n = std::max(worst_jump_n, quantised ? 0.0 : loop.largest_jump_n);
            EXPECT_GT(loop.largest_n, 0.5) << "seed " << seed << " touches nothing";
            EXPECT_LE(loop.energy_j, loop.allowed_j) << "seed " << seed << (quantised ? ", quantised" : "");
        }
    }
    std::cout << "    worst loop gives " << 1e6 * worst_j << " uJ; largest change in a tick " << worst_jump_n << " N\n";
}

TEST_P(TexturedSurface, dissipates_energy_wherever_there_is_friction) {
    const int loops = scaled(20);
    for (int seed = 1; seed <= loops; ++seed) {
        std::mt19937 random(static_cast<unsigned>(100 + seed));
        const auto scene = textured_corner(random, GetParam(), 0.4);
        const auto goals = begun_in_the_open(*scene, closed_loop(random, {0.0, 0.0, 0.01}, {0.07, 0.04, 0.03}, 4.0));
        EXPECT_LT(run(*scene, goals, plain_tuning(0.005)).energy_j, 0.0) << "seed " << 100 + seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TexturedSurface,
                         ::testing::Values(ReliefKind::Sine, ReliefKind::Square, ReliefKind::Picture));

// ---- force shading ----

std::shared_ptr<const HapticScene> mesh_scene(const TriangleMesh& mesh, bool shaded) {
    HapticSceneBuilder builder;
    builder.add_mesh(mesh);
    if (shaded) builder.shade_meshes();
    return builder.build();
}

// Returns the root mean square angle, in degrees, between the force and that of the exact sphere. The hand slides at
// 0.2 m/s, pressed 2 to 5 mm deep.
double direction_error_deg(const HapticScene& scene, double radius_m) {
    double sum = 0.0;
    int count = 0;
    replay(scene, sphere_slide(radius_m, 0.005, 0.2, 6000), {}, plain_tuning(0.005),
           [&](std::size_t, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
               if (glm::length(r.force_n) < 1.5) return;
               const double cosine = glm::dot(r.force_n, goal) / (glm::length(r.force_n) * glm::length(goal));
               const double angle = std::acos(std::min(1.0, cosine));
               sum += angle * angle;
               ++count;
           });
    EXPECT_GT(count, 4000);
    return std::sqrt(sum / count) * 180.0 / kPi;
}

TEST(ShadedMesh, points_the_force_along_the_sphere_that_it_approximates) {
    const TriangleMesh mesh = sphere_mesh(22, 0.5);  // a sphere of 9680 triangles
    const double facets = direction_error_deg(*mesh_scene(mesh, false), 0.5),
                 shaded = direction_error_deg(*mesh_scene(mesh, true), 0.5);
    std::cout << "    direction error of " << mesh.triangles.size() << " triangles: " << facets
              << " degrees rms, shaded " << shaded << "\n";
    EXPECT_LE(facets, 1.3);
    EXPECT_LE(shaded, 0.05);
}

// Returns a torus, which has convex, concave and saddle-shaped parts. Its corners are displaced at random, so that no
// two facets are alike.
TriangleMesh shaken_torus(std::mt19937& random, int around, int across, double shake_m) {
    std::uniform_real_distribution<double> shake(-shake_m, shake_m);
    TriangleMesh mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2.0 * kPi * i / around, b = 2.0 * kPi * j / across, out = 0.1 + 0.04 * std::cos(b);
            mesh.points_m.push_back(Vec3(out * std::cos(a), out * std::sin(a), 0.04 * std::sin(b)) +
                                    Vec3(shake(random), shake(random), shake(random)));
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

// Tests displaced tori and coarse spheres, pressed up to `deepest_m`. If `deepest_m` exceeds the proxy's radius of 5
// mm, the proxy jumps across the edges of facets, with and without shading. In each tick with such a jump, I11 permits
// the greatest error of the trapezoidal rule.
void gives_no_energy(double deepest_m) {
    const int loops = scaled(40);
    const bool jumps = deepest_m > 0.005;
    double worst_j = -1.0, worst_jump_n = 0.0;
    int touched = 0;
    for (int seed = 1; seed <= loops; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        const auto scene = mesh_scene(
            seed % 2 == 0 ? sphere_mesh(2 + seed % 5, 0.1) : shaken_torus(random, 16 + seed % 9, 10 + seed % 7, 5e-4),
            true);
        EXPECT_TRUE(scene->has_fields());
        const double start = seed % 2 == 0 ? 0.1 : 0.04;
        const Vec3 middle(seed % 2 == 0 ? 0.0 : 0.1, 0.0, start + 0.008);
        const auto goals = begun_in_the_open(*scene, closed_loop(random, middle, {0.04, 0.04, deepest_m + 0.003}, 4.0));
        for (const bool quantised : {false, true}) {
            const Loop loop = run(*scene, quantised ? with_quantum(goals, 6e-5) : goals, uncapped_tuning(0.005));
            worst_j = std::max(worst_j, loop.energy_j);
            worst_jump_n = std::max(worst_jump_n, quantised ? 0.0 : loop.largest_jump_n);
            touched += loop.largest_n > 0.5;
            EXPECT_LE(loop.energy_j, loop.allowed_j + (jumps ? loop.edges_j : 0.0))
                << "seed " << seed << (quantised ? ", quantised" : "");
        }
    }
    EXPECT_GE(4 * touched, loops);
    std::cout << "    worst loop gives " << 1e6 * worst_j << " uJ; largest change in a tick " << worst_jump_n << " N\n";
}

TEST(ShadedMesh, gives_no_energy_over_random_closed_loops) { gives_no_energy(0.004); }  // invariant I11
// Invariant I11.
TEST(ShadedMesh, gives_no_energy_when_pressed_deeper_than_the_proxys_radius) { gives_no_energy(0.012); }

TEST(ShadedMesh, keeps_corners_sharp_and_flat_faces_flat) {
    // A cube of triangles. Every edge is sharper than the crease angle and every face is flat, so shading must not
    // change anything.
    TouchWorld world;
    world.box_of_triangles({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05});
    const auto plain = world.scene();
    EXPECT_TRUE(mesh_scene(plain->mesh, true)->shading.facets.empty());
    EXPECT_FALSE(mesh_scene(plain->mesh, true)->has_fields());
    // A tube of 24 sides with a lid. Shading raises the sides, but neither the lid nor its rim.
    TriangleMesh tube;
    for (int i = 0; i < 24; ++i)
        for (const double z : {0.0, 0.1})
            tube.points_m.push_back({0.05 * std::cos(2.0 * kPi * i / 24), 0.05 * std::sin(2.0 * kPi * i / 24), z});
    tube.points_m.push_back({0.0, 0.0, 0.1});
    for (std::uint32_t i = 0; i < 24; ++i) {
        const std::uint32_t next = (i + 1) % 24;
        tube.triangles.push_back({2 * i, 2 * next, 2 * next + 1});
        tube.triangles.push_back({2 * i, 2 * next + 1, 2 * i + 1});
        tube.triangles.push_back({2 * i + 1, 2 * next + 1, 48});
    }
    const MeshShading shading = shade_mesh(tube.points_m, tube.triangles);
    for (std::size_t t = 0; t < tube.triangles.size(); ++t) {
        double rise = 0.0;
        for (const float s : shading.facets[t].sagitta_m) rise = std::max(rise, std::abs(static_cast<double>(s)));
        if (t % 3 == 2) EXPECT_EQ(rise, 0.0) << t;
        else
            EXPECT_NEAR(rise, 0.05 * (1.0 - std::cos(kPi / 24.0)), 2e-5)
                << t;  // rise of the diagonal edge, which spans one side of the tube's polygon
    }
    EXPECT_EQ(shade_mesh(tube.points_m, tube.triangles, 1.0).highest_m, 0.0)
        << "with no crease angle at all nothing is smooth";
}

TEST(ShadedMesh, survives_needles_duplicates_and_edges_of_three_triangles) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-0.05, 0.05);
    for (int seed = 0; seed < 20; ++seed) {
        TriangleMesh mesh;
        for (int i = 0; i < 30; ++i) mesh.points_m.push_back({unit(random), unit(random), 0.1 * unit(random)});
        mesh.points_m[1] = mesh.points_m[0];
        for (int i = 0; i < 60; ++i)
            mesh.triangles.push_back({static_cast<std::uint32_t>(random() % 30),
                                      static_cast<std::uint32_t>(random() % 30),
                                      static_cast<std::uint32_t>(random() % 30)});
        mesh.triangles.push_back(mesh.triangles.front());
        const auto scene = mesh_scene(mesh, true);
        for (const MeshShading::Facet& facet : scene->shading.facets)
            for (const float s : facet.sagitta_m) EXPECT_TRUE(std::isfinite(s)) << seed;
        replay(*scene, closed_loop(random, Vec3(0.0), Vec3(0.05), 1.0), {}, plain_tuning(0.003),
               [&](std::size_t, const Vec3&, const TouchResult& r, const ProxySolver&) {
                   ASSERT_TRUE(is_finite(r.force_n)) << seed;
               });
    }
}

}  // namespace surfaces_test
}  // namespace handrail::test
