#include "app/window/plan.h"

#include <map>

#include "tests/support/names.h"
#include "tests/window/small_room.h"
#include "worlds/scene/models.h"

namespace handrail::test {
namespace plan_test {

double area_m2(const std::vector<Vec2>& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[(i + 1) % outline.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return 0.5 * twice;
}

TEST(SectionAt, of_a_box_is_its_footprint_counter_clockwise_and_empty_above_the_box) {
    const ConvexSolid solid = box({1.0, 2.0, 0.0}, {4.0, 4.0, 2.0});
    EXPECT_NEAR(area_m2(section_at(solid, 1.0)), 6.0, 1e-12);
    EXPECT_EQ(section_at(solid, 1.0).size(), 4U);
    EXPECT_TRUE(section_at(solid, 2.5).empty());
    EXPECT_TRUE(section_at(solid, -0.5).empty());
}

TEST(SectionAt, of_a_pyramid_shrinks_with_height) {
    // A pyramid whose base is a square with sides of 4 m at z = 0 and whose tip is at z = 4 m. At height h, its section
    // has sides of 4 - h.
    const Vec3 tip(2.0, 2.0, 4.0);
    const std::vector<Vec3> base{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 4.0, 0.0}, {0.0, 4.0, 0.0}};
    ConvexSolid pyramid;
    for (std::size_t i = 0; i < 4; ++i) pyramid.faces.push_back({{base[i], base[(i + 1) % 4], tip}});
    pyramid.faces.push_back({{base[3], base[2], base[1], base[0]}});
    for (const double h : {0.5, 1.0, 2.0, 3.9})
        EXPECT_NEAR(area_m2(section_at(pyramid, h)), (4.0 - h) * (4.0 - h), 1e-9) << h;
}

TEST(CutPlan, shows_things_at_hand_height_and_things_below_it) {
    // The plan must show the four walls and the door as cut, the table as low, the water as liquid, and the floor as
    // floor. It must not show the ceiling.
    const PlanCut cut = cut_plan(*small_room(), 0.0);
    std::map<PlanKind, int> count;
    for (const PlanShape& shape : cut.shapes) {
        ++count[shape.kind];
        EXPECT_GT(area_m2(shape.outline_m), 0.0);
    }
    EXPECT_EQ(count, (std::map<PlanKind, int>{{PlanKind::Floor, 1},
                                              {PlanKind::Wall, 4},
                                              {PlanKind::Door, 1},
                                              {PlanKind::Low, 1},
                                              {PlanKind::Liquid, 1}}));
    EXPECT_EQ(cut.shapes.front().kind, PlanKind::Floor) << "drawn first, under everything";
    EXPECT_EQ(cut.shapes.back().kind, PlanKind::Door) << "drawn over the wall it stands in";
}

TEST(CutPlan, of_another_storey_shows_that_storey) {
    Scene scene = *small_room();
    add_box(scene, {1.0, 1.0, 2.7}, {2.0, 2.0, 5.0}, FeatureKind::Object);
    const PlanCut cut = cut_plan(scene, 2.7);
    // The ceiling, the four walls and the door end below the feet, so the plan of this storey must show all of them as
    // floor. The table and the water are too far below to be shown.
    ASSERT_EQ(cut.shapes.size(), 7U);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(cut.shapes[i].kind, PlanKind::Floor);
    EXPECT_EQ(cut.shapes[6].kind, PlanKind::Object);
}

TEST(CutPlan, shows_objects_that_were_placed_during_the_session) {
    Scene model;
    add_box(model, {-0.5, -0.25, 0.0}, {0.5, 0.25, 1.5}, FeatureKind::Object);
    const auto crate = std::make_shared<const Scene>(std::move(model));
    auto scene =
        with_placed(*small_room(), "crate", crate, {{2.0, 1.0, 0.0}, rotation_about({0, 0, 1}, kPi / 2.0), 1.0}, "");
    ASSERT_TRUE(scene);
    const std::size_t before = cut_plan(*small_room(), 0.0).shapes.size();
    const PlanCut cut = cut_plan(*scene, 0.0);
    ASSERT_EQ(cut.shapes.size(), before + 1);
    const auto found = std::find_if(cut.shapes.begin(), cut.shapes.end(),
                                    [](const PlanShape& shape) { return shape.kind == PlanKind::Object; });
    ASSERT_NE(found, cut.shapes.end());
    EXPECT_NEAR(area_m2(found->outline_m), 0.5, 1e-9);
    for (const Vec2& corner : found->outline_m) {
        EXPECT_NEAR(std::abs(corner.x - 2.0), 0.25, 1e-9) << "a quarter turn";
        EXPECT_NEAR(std::abs(corner.y - 1.0), 0.5, 1e-9);
    }
}

TEST(CutPlan, cuts_sheets_into_lines) {
    Scene scene;
    scene.triangles.push_back({{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, kNoFeature, kDefaultMaterial});
    scene.triangles.push_back({{0.0, 0.0, 5.0}, {2.0, 0.0, 5.0}, {0.0, 2.0, 5.0}, kNoFeature, kDefaultMaterial});
    const PlanCut cut = cut_plan(scene, 0.0);
    // The cut touches only the first triangle, half way up, where the triangle is 1 m wide.
    ASSERT_EQ(cut.sheets_m.size(), 1U);
    EXPECT_NEAR(glm::distance(cut.sheets_m[0][0], cut.sheets_m[0][1]), 1.0, 1e-12);
}

constexpr PixelBox kBox{Vec2(0.0, 0.0), Vec2(800.0, 600.0)};

TEST(LayOutPlan, fits_a_whole_house_with_north_up) {
    Aabb house{{0.0, 0.0, 0.0}, {20.0, 10.0, 3.0}};
    const PlanLayout layout = lay_out_plan({house}, {1.0, 1.0, 0.0}, 1.0, true, kBox);
    EXPECT_NEAR(layout.pixels_per_m, 0.94 * 800.0 / 20.0, 1e-9);
    const Vec2 middle = layout.to_pixels(Vec2(10.0, 5.0));
    EXPECT_NEAR(middle.x, 400.0, 1e-9);
    EXPECT_NEAR(middle.y, 300.0, 1e-9);
    EXPECT_LT(layout.to_pixels(Vec2(10.0, 9.0)).y, middle.y);
    EXPECT_GT(layout.to_pixels(Vec2(12.0, 5.0)).x, middle.x);
}

TEST(LayOutPlan, follows_the_walker_through_a_large_world_and_stays_inside_it) {
    Aabb town{{0.0, 0.0, 0.0}, {500.0, 300.0, 3.0}};
    const Vec2 half_m = 0.5 * Vec2(800.0, 600.0) / kPlanFinest_px_per_m;
    for (const Vec3& feet :
         {Vec3(250.0, 150.0, 0.0), Vec3(0.0, 0.0, 0.0), Vec3(499.0, 10.0, 0.0), Vec3(30.0, 299.0, 0.0)}) {
        const PlanLayout layout = lay_out_plan({town}, feet, 0.0, true, kBox);
        EXPECT_EQ(layout.pixels_per_m, kPlanFinest_px_per_m);
        const Vec2 at = layout.to_pixels(feet);
        EXPECT_TRUE(at.x >= 0.0 && at.x <= 800.0 && at.y >= 0.0 && at.y <= 600.0) << at.x << " " << at.y;
        EXPECT_GE(layout.centre_m.x, half_m.x);
        EXPECT_LE(layout.centre_m.x, 500.0 - half_m.x);
        EXPECT_GE(layout.centre_m.y, half_m.y);
        EXPECT_LE(layout.centre_m.y, 300.0 - half_m.y);
    }
}

TEST(LayOutPlan, with_heading_up_shows_things_ahead_above_the_walker) {
    Aabb house{{0.0, 0.0, 0.0}, {20.0, 10.0, 3.0}};
    const Vec3 feet(4.0, 5.0, 0.0);
    for (const double heading_rad : {0.0, 0.7, 2.0, 4.0}) {
        const PlanLayout layout = lay_out_plan({house}, feet, heading_rad, false, kBox);
        const Vec2 ahead = layout.to_pixels(feet + 2.0 * forward_of_heading(heading_rad));
        const Vec2 right = layout.to_pixels(feet + 2.0 * right_of_heading(heading_rad));
        EXPECT_NEAR(ahead.x, 400.0, 1e-9);
        EXPECT_NEAR(ahead.y, 300.0 - 2.0 * layout.pixels_per_m, 1e-9);
        EXPECT_NEAR(right.x, 400.0 + 2.0 * layout.pixels_per_m, 1e-9);
        EXPECT_NEAR(right.y, 300.0, 1e-9);
    }
}

TEST(ScaleBar, has_a_length_of_one_two_or_five_units_and_fits) {
    EXPECT_EQ(scale_bar(100.0, 240.0).words, "2 metres");
    EXPECT_EQ(scale_bar(100.0, 199.0).words, "1 metre");
    EXPECT_EQ(scale_bar(16.0, 240.0).words, "10 metres");
    EXPECT_EQ(scale_bar(16.0, 100.0).words, "5 metres");
    EXPECT_EQ(scale_bar(400.0, 240.0).words, "50 centimetres");
    EXPECT_EQ(scale_bar(100.0, 1.0).words, "1 centimetre");
    for (double scale = 0.01; scale < 1e4; scale *= 1.37) {
        const double px = scale_bar(scale, 240.0).length_m * scale;
        EXPECT_LE(px, 240.0 * (1.0 + 1e-9)) << scale;
        EXPECT_GT(px, 240.0 / 2.6) << scale;
    }
}

}  // namespace plan_test
}  // namespace handrail::test
