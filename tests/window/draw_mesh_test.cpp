#include "app/window/draw_mesh.h"

#include "tests/support/names.h"
#include "tests/window/small_room.h"

namespace handrail::test {
namespace draw_mesh_test {

double length_m(const DrawMesh& mesh) {
    double sum = 0.0;
    for (const DrawEdge& e : mesh.edges) {
        const Vec3 a(e.a_m[0], e.a_m[1], e.a_m[2]), b(e.b_m[0], e.b_m[1], e.b_m[2]);
        sum += glm::distance(a, b);
    }
    return sum;
}

Polygon upright(double x_from_m, double x_to_m, double z_from_m, double z_to_m) {
    return {{{x_from_m, 0.0, z_from_m}, {x_to_m, 0.0, z_from_m}, {x_to_m, 0.0, z_to_m}, {x_from_m, 0.0, z_to_m}}};
}

void add_wall_piece(Scene& scene, const Polygon& polygon, std::uint32_t feature) {
    scene.surfaces.push_back({polygon, {0.0, -1.0, 0.0}, FeatureId{feature}, kDefaultMaterial, SolidRole::Solid});
}

TEST(DrawMesh, makes_each_polygon_a_fan) {
    Scene scene;
    add_wall_piece(scene, upright(0.0, 2.0, 0.0, 1.0), 0);
    const DrawMesh mesh = build_draw_mesh(scene);
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.opaque, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_TRUE(mesh.translucent.empty());
    EXPECT_EQ(mesh.origin_m, Vec3(1.0, 0.0, 0.5));
}

TEST(DrawMesh, outlines_a_wall_of_several_pieces_as_one_wall) {
    // A wall of 4 m by 2 m consists of three pieces that meet in a T. The outline of the wall is 12 m long.
    Scene scene;
    add_wall_piece(scene, upright(0.0, 2.0, 0.0, 2.0), 0);
    add_wall_piece(scene, upright(2.0, 4.0, 0.0, 0.7), 0);
    add_wall_piece(scene, upright(2.0, 4.0, 0.7, 2.0), 0);
    EXPECT_NEAR(length_m(build_draw_mesh(scene)), 12.0, 1e-4);
}

TEST(DrawMesh, outlines_two_features_in_one_plane_separately) {
    Scene scene;  // two squares with sides of 2 m; each has an outline of 8 m, because each draws the shared side
    add_wall_piece(scene, upright(0.0, 2.0, 0.0, 2.0), 0);
    add_wall_piece(scene, upright(2.0, 4.0, 0.0, 2.0), 1);
    EXPECT_NEAR(length_m(build_draw_mesh(scene)), 16.0, 1e-4);
}

TEST(DrawMesh, joins_slanted_pieces_at_any_angle) {
    // A square with sides of 2 m is cut along its diagonal and turned in its plane in steps of 7 degrees. The outline
    // of the square is always 8 m long.
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double c = std::cos(radians_from_degrees(degrees)), s = std::sin(radians_from_degrees(degrees));
        const auto turned = [&](double x, double z) { return Vec3(c * x - s * z + 30.0, 5.0, s * x + c * z - 70.0); };
        Scene scene;
        add_wall_piece(scene, {{turned(0.0, 0.0), turned(2.0, 0.0), turned(2.0, 2.0)}}, 0);
        add_wall_piece(scene, {{turned(0.0, 0.0), turned(2.0, 2.0), turned(0.0, 2.0)}}, 0);
        EXPECT_NEAR(length_m(build_draw_mesh(scene)), 8.0, 1e-4) << degrees;
    }
}

TEST(DrawMesh, leaves_out_invisible_volumes_and_needle_triangles) {
    Scene scene;
    add_box(scene, Vec3(0.0), Vec3(1.0), FeatureKind::Trigger, SolidRole::Trigger);
    add_box(scene, Vec3(0.0), Vec3(1.0), FeatureKind::Wall, SolidRole::BodyClip);
    scene.triangles.push_back({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, kNoFeature, kDefaultMaterial});
    EXPECT_TRUE(build_draw_mesh(scene).vertices.empty());
    add_box(scene, Vec3(0.0), Vec3(1.0), FeatureKind::Liquid, SolidRole::Liquid);
    const DrawMesh mesh = build_draw_mesh(scene);
    EXPECT_EQ(mesh.translucent.size(), 36U);  // six sides of two triangles each
    EXPECT_TRUE(mesh.opaque.empty());
}

TEST(DrawMesh, of_an_empty_scene_is_empty) { EXPECT_TRUE(build_draw_mesh(Scene{}).vertices.empty()); }

TEST(LookOf, distinguishes_kinds_by_luminance_or_pattern) {
    struct Sample {
        const char* what;
        DrawLook look;
    };
    const Vec3 up(0.0, 0.0, 1.0), down(0.0, 0.0, -1.0), east(1.0, 0.0, 0.0), north(0.0, 1.0, 0.0),
        slope(0.0, 0.7071, 0.7071);
    const std::vector<Sample> samples{{"wall facing north", look_of(FeatureKind::Wall, SolidRole::Solid, north)},
                                      {"wall facing east", look_of(FeatureKind::Wall, SolidRole::Solid, east)},
                                      {"floor", look_of(FeatureKind::Floor, SolidRole::Solid, up)},
                                      {"ceiling", look_of(FeatureKind::Ceiling, SolidRole::Solid, down)},
                                      {"slope", look_of(FeatureKind::Slope, SolidRole::Solid, slope)},
                                      {"door", look_of(FeatureKind::Door, SolidRole::Mover, east)},
                                      {"lift", look_of(FeatureKind::Lift, SolidRole::Mover, up)},
                                      {"button", look_of(FeatureKind::Button, SolidRole::Mover, east)},
                                      {"water", look_of(FeatureKind::Liquid, SolidRole::Liquid, up)},
                                      {"table top", look_of(FeatureKind::Object, SolidRole::Solid, up)}};
    for (const Sample& a : samples)
        for (const Sample& b : samples) {
            if (&a == &b || a.look.pattern != b.look.pattern) continue;
            EXPECT_GT(std::abs(luminance(a.look.rgb) - luminance(b.look.rgb)), 15.0) << a.what << " and " << b.what;
        }
}

}  // namespace draw_mesh_test
}  // namespace handrail::test
