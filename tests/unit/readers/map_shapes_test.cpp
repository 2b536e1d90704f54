// Tests exact shapes in a map. A map requests an exact shape by the key cs_name, as the original's maps do, or by the
// keys `shape` and `axis`.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/readers/reading.h"

namespace handrail {
namespace map_shapes_test {

using test::box_brush;
using test::entity;
using test::key;
using test::Reading;
using test::reading_of;

Reading read(const std::string& keys, const std::string& brushes, const std::string& class_name = "func_wall") {
    return reading_of(read_quake_map(
        entity("worldspawn", {}, box_brush(0, 0, -32, 640, 640, 0)) + entity(class_name, keys, brushes), "shapes.map"));
}

bool heard(const Reading& reading, const std::string& part) {
    return std::any_of(reading.said.begin(), reading.said.end(),
                       [&](const std::string& s) { return s.find(part) != std::string::npos; });
}

const std::string kCube = box_brush(64, 64, 0, 96, 96, 32);     // side 1 m, with a corner at (2, 2, 0)
const std::string kPillar = box_brush(64, 64, 0, 96, 96, 128);  // 1 by 1 m, 4 m high

TEST(MapShapes, dynamic_things_take_their_sizes_from_their_bounding_box) {
    const Reading ball = read(key("cs_name", "dynamic_sphere"), kCube, "thing");
    const auto* sphere = std::get_if<SphereShape>(&ball.scene.solids.at(1).round);
    ASSERT_TRUE(sphere);
    EXPECT_NEAR(glm::length(sphere->centre_m - Vec3(2.5, 2.5, 0.5)), 0.0, 1e-12);
    EXPECT_NEAR(sphere->radius_m, 0.5, 1e-12);
    EXPECT_EQ(ball.scene.solids[1].role, SolidRole::Mover);
    EXPECT_EQ(ball.scene.find(ball.scene.solids[1].feature)->name, "ball");
    EXPECT_TRUE(ball.said.empty());
    EXPECT_EQ(ball.scene.report.brushes, 2);
    EXPECT_EQ(ball.scene.report.polygons, 12) << "faces of the file, not those drawn around the ball";
    const Reading tin = read(key("cs_name", "dynamic_cylinder"), kPillar, "thing");
    const auto* cylinder = std::get_if<CylinderShape>(&tin.scene.solids.at(1).round);
    ASSERT_TRUE(cylinder);
    EXPECT_NEAR(glm::length(cylinder->bottom_m - Vec3(2.5, 2.5, 0.0)), 0.0, 1e-12);
    EXPECT_EQ(cylinder->axis, Vec3(0, 0, 1));
    EXPECT_NEAR(cylinder->height_m, 4.0, 1e-12);
    EXPECT_NEAR(cylinder->radius_m, 0.5, 1e-12);
    const Reading box = read(key("cs_name", "dynamic_box"), kCube, "thing");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(box.scene.solids.at(1).round));
    EXPECT_EQ(box.scene.solids[1].shape.planes.size(), 6U);
    // Several brushes of one entity must make one shape, even if they form a box.
    const std::string two = box_brush(64, 64, 0, 96, 96, 16) + box_brush(64, 64, 16, 96, 96, 32);
    for (const char* name : {"dynamic_box", "dynamic_sphere"})
        EXPECT_EQ(read(key("cs_name", name), two, "thing").scene.solids.size(), 2U) << name;
}

TEST(MapShapes, sides_that_differ_by_more_than_5_percent_are_reported_with_file_and_line) {
    for (const auto& [side, reported] : {std::pair{33.0, false}, {33.5, false}, {34.0, true}, {64.0, true}}) {
        const Reading ball = read(key("cs_name", "dynamic_sphere"), box_brush(64, 64, 0, 64 + side, 96, 32), "thing");
        EXPECT_EQ(heard(ball, "box around this sphere"), reported) << side;
        if (reported) {
            EXPECT_TRUE(heard(ball, "shapes.map, line 12"));
        }
        EXPECT_NEAR(std::get<SphereShape>(ball.scene.solids.at(1).round).radius_m, 0.5, 1e-12)
            << "the smallest side, so that it stays in its box";
    }
    EXPECT_TRUE(heard(read(key("cs_name", "dynamic_cylinder"), box_brush(64, 64, 0, 96, 80, 32), "thing"),
                      "box around this cylinder"));
    EXPECT_TRUE(read(key("cs_name", "dynamic_cylinder"), kPillar, "thing").said.empty())
        << "a cylinder may be higher than wide";
}

TEST(MapShapes, the_key_shape_makes_any_entity_exact_along_any_axis) {
    const Reading cone = read(key("shape", "Cone") + key("axis", "-z"), kPillar);
    const auto* shape = std::get_if<ConeShape>(&cone.scene.solids.at(1).round);
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->base_m.z, 4.0, 1e-12);
    EXPECT_NEAR(shape->axis.z, -1.0, 1e-12);
    EXPECT_EQ(cone.scene.solids[1].role, SolidRole::Solid);
    EXPECT_EQ(cone.scene.find(cone.scene.solids[1].feature)->name, "cone");
    const std::string lying = box_brush(64, 64, 0, 192, 96, 32);  // 4 m long along x
    for (const auto& [axis, direction] : {std::pair{"x", 1.0}, {"-x", -1.0}}) {
        const Reading post = read(key("name", "Rail") + key("shape", "capsule") + key("axis", axis), lying);
        const auto* capsule = std::get_if<CapsuleShape>(&post.scene.solids.at(1).round);
        ASSERT_TRUE(capsule);
        EXPECT_NEAR(capsule->axis.x, direction, 1e-12);
        EXPECT_NEAR(capsule->length_m, 3.0, 1e-12);
        EXPECT_NEAR(capsule->radius_m, 0.5, 1e-12);
        EXPECT_TRUE(post.said.empty());
        EXPECT_EQ(post.scene.find(post.scene.solids[1].feature)->name, "Rail");
    }
    const Reading across = read(key("shape", "cylinder") + key("axis", "y"), box_brush(64, 64, 0, 96, 192, 32));
    EXPECT_NEAR(std::get<CylinderShape>(across.scene.solids.at(1).round).height_m, 4.0, 1e-12);
    EXPECT_NEAR(std::abs(std::get<CylinderShape>(across.scene.solids.at(1).round).axis.y), 1.0, 1e-12);
    EXPECT_TRUE(std::holds_alternative<CylinderShape>(
        read(key("shape", "cylinder"), kPillar, "func_door").scene.solids.at(1).round));
}

TEST(MapShapes, an_impossible_shape_is_reported_and_the_brushes_remain) {
    const Reading unknown = read(key("shape", "spere"), kCube);
    EXPECT_TRUE(heard(unknown, "The nearest name is sphere"));
    EXPECT_TRUE(std::holds_alternative<std::monostate>(unknown.scene.solids.at(1).round));
    EXPECT_TRUE(heard(read(key("shape", "cone") + key("axis", "up"), kCube), "is not x, y or z"));
    EXPECT_TRUE(heard(read(key("shape", "sphere"), kCube, "trigger_once"), "cannot be touched"));
    const Reading building =
        reading_of(read_quake_map(entity("worldspawn", key("shape", "sphere"), kCube), "shapes.map"));
    EXPECT_TRUE(heard(building, "on the whole building"));
    EXPECT_EQ(building.scene.solids.size(), 1U);
    const Reading flat = read(key("shape", "capsule"), box_brush(64, 64, 0, 96, 96, 8));
    EXPECT_TRUE(heard(flat, "wider than it is long"));
    EXPECT_NEAR(std::get<CapsuleShape>(flat.scene.solids.at(1).round).radius_m, 0.125, 1e-12);
}

TEST(MapShapes, the_drawn_surface_of_a_shape_has_its_name) {
    const Reading ball = read(key("name", "Globe") + key("shape", "sphere"), kCube);
    const FeatureId globe = ball.scene.solids.at(1).feature;
    std::size_t drawn = 0;
    for (const SurfacePolygon& surface : ball.scene.surfaces) drawn += surface.feature == globe ? 1 : 0;
    EXPECT_GT(drawn, 50U);
    EXPECT_EQ(ball.scene.find(globe)->name, "Globe");
}

}  // namespace map_shapes_test
}  // namespace handrail
