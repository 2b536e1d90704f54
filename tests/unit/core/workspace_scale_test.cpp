#include "app/core/context/workspace_scale.h"

#include "tests/support/box_scene.h"
#include "tests/support/names.h"

namespace handrail {
namespace workspace_scale_test {

constexpr double kTouch = 0.075, kFalcon = 0.04;
const Aabb kBounds{{0.0, 0.0, 0.0}, {30.0, 40.0, 6.0}};

TEST(NamedScale, has_the_published_ratios_and_fits_a_building_with_both_corners_inside_the_rim) {
    for (const double reach : {kTouch, kFalcon}) {
        EXPECT_EQ(world_m_per_hand_m(NamedScale::Floor, kBounds, reach), 120.0);
        EXPECT_EQ(world_m_per_hand_m(NamedScale::Room, kBounds, reach), 60.0);
        EXPECT_EQ(world_m_per_hand_m(NamedScale::Detail, kBounds, reach), 15.0);
    }
    // Half of the width of 50 m.
    EXPECT_NEAR(world_m_per_hand_m(NamedScale::Building, kBounds, kTouch) * 0.8 * kTouch, 25.0, 1e-9);
    EXPECT_EQ(world_m_per_hand_m(NamedScale::Building, kBounds, kFalcon), 500.0)
        << "no coarser than the setting allows";
    EXPECT_EQ(world_m_per_hand_m(NamedScale::Building, Aabb{}, kTouch), 120.0) << "nothing to fit";
}

TEST(NamedScale, is_announced_with_its_name_and_width_in_the_persons_units) {
    const DistanceWords steps{true, 0.7}, metres{false, 0.7};
    EXPECT_EQ(scale_sentence(NamedScale::Room, 60.0, kTouch, metres), "Room, 9 metres wide");
    EXPECT_EQ(scale_sentence(NamedScale::Room, 60.0, kTouch, steps), "Room, 9 metres wide, 13 steps");
    EXPECT_EQ(scale_sentence(NamedScale::Floor, 120.0, kTouch, metres), "Storey, 18 metres wide");
    EXPECT_EQ(scale_sentence(NamedScale::Room, 60.0, kFalcon, metres), "Room, 4.8 metres wide");
    EXPECT_EQ(scale_sentence(NamedScale::Detail, 15.0, kFalcon, metres), "Detail, 1.2 metres wide");
    EXPECT_EQ(scale_sentence(NamedScale::Building, 416.7, kTouch, metres), "Building, 63 metres wide");
}

TEST(ProxyRadius, is_4_mm_at_room_scale_2_to_6_mm_elsewhere_and_at_most_a_sixth_of_the_narrowest_door) {
    test::SceneBuilder open;
    open.box({0, 0, 0}, {1, 1, 1}, "block", SolidRole::Solid, "wood", FeatureKind::Object);
    const Scene& plain = open.scene();
    EXPECT_NEAR(proxy_radius_m(plain, 0.004, 60.0), 0.12, 1e-12);
    EXPECT_NEAR(proxy_radius_m(plain, 0.004, 120.0), 0.12, 1e-12);
    EXPECT_NEAR(proxy_radius_m(plain, 0.004, 15.0), 0.045, 1e-12);  // 6 mm at the hand
    EXPECT_NEAR(proxy_radius_m(plain, 0.004, 400.0), 0.4, 1e-12);   // 2 mm at the hand
    open.box({2, 0, 0}, {2.9, 0.1, 2.0}, "door", SolidRole::Solid, "wood", FeatureKind::Door);
    for (const double scale : {15.0, 60.0, 120.0, 400.0})
        EXPECT_LE(2.0 * proxy_radius_m(open.scene(), 0.004, scale), 0.9 / 3.0 + 1e-12);
    EXPECT_NEAR(proxy_radius_m(open.scene(), 0.004, 400.0), 0.15, 1e-12);
}

}  // namespace workspace_scale_test
}  // namespace handrail
