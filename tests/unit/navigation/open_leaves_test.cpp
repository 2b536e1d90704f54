// Tests open door leaves that block routes: which places they cover, and routes around them. Checking every point of
// the leaf is the reference for the places.
#include "worlds/navigation/open_leaves.h"

#include <random>

#include "app/core/world/walker.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace open_leaves_test {

using test::SceneBuilder;

// Returns a corridor that is 12 m long and `wide_m` wide. `at_m` is its corner.
std::shared_ptr<Navigation> corridor(double wide_m, const Vec3& at_m = Vec3(0.0)) {
    SceneBuilder b;
    const auto box = [&](const Vec3& low, const Vec3& high, FeatureKind kind) {
        b.box(at_m + low, at_m + high, "wall", SolidRole::Solid, "brick", kind);
    };
    box({0, 0, -0.2}, {12, wide_m, 0}, FeatureKind::Floor);
    box({0, -0.2, 0}, {12, 0, 2.6}, FeatureKind::Wall);
    box({0, wide_m, 0}, {12, wide_m + 0.2, 2.6}, FeatureKind::Wall);
    box({-0.2, 0, 0}, {0, wide_m, 2.6}, FeatureKind::Wall);
    box({12, 0, 0}, {12.2, wide_m, 2.6}, FeatureKind::Wall);
    b.start(at_m + Vec3(1, 0.5 * wide_m, 0), 0.0);
    const WalkerSize size = walker_size(b.scene(), 0.25);
    auto made = Navigation::make(b.scene(), walker_measures(b.scene(), size.radius_m, size.height_m, size.step_up_m));
    EXPECT_TRUE(made);
    return *made;
}

// Returns a leaf that is `long_m` long. Its hinge is at `hinge_m`, and it is turned by `turned_rad` from the east
// towards the north.
OpenLeaf leaf(const Vec3& hinge_m, double turned_rad, double long_m = 0.9) {
    return {{{0, -0.025, 0}, {long_m, 0.025, 2.0}}, {hinge_m, rotation_about({0, 0, 1}, turned_rad), 1.0}};
}

TEST(OpenLeaves, occupy_exactly_the_places_where_a_body_would_overlap_them) {
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    const auto part = [&] { return static_cast<double>(random() % 10001) / 10000.0; };
    for (const Vec3& at : {Vec3(0.0), Vec3(3000.0, -2000.0, 40.0)}) {
        const auto navigation = corridor(4.0, at);
        const WalkSpace& space = navigation->space();
        for (int round = 0; round < 8; ++round) {
            if (!test::tried(static_cast<std::size_t>(round), 3)) continue;
            const double up_m = round == 0   ? 1.9
                                : round == 1 ? -2.1
                                : round == 2 ? 0.3
                                             // The leaves are above the walker's head, under the floor, above the
                                             // walker's soles, or at floor level.
                                             : 0.0;
            std::vector<OpenLeaf> leaves{
                leaf(at + Vec3(12.0 * part(), 4.0 * part(), up_m), 2.0 * kPi * part()),
                leaf(at + Vec3(12.0 * part(), 4.0 * part(), up_m), 0.5 * kPi * static_cast<double>(random() % 4))};
            const std::vector<std::uint8_t> marks = mark_leaves(space, leaves);
            std::swap(leaves[0], leaves[1]);
            EXPECT_EQ(mark_leaves(space, leaves), marks);
            const bool meets = up_m < space.body.height_m && up_m + 2.0 > 0.0;
            EXPECT_EQ(marks.empty(), !meets);
            for (std::uint32_t s = 0; s < space.spans.size() && meets; ++s) {
                const Vec3 place = space.place_m(s);
                // Distance from the nearest of the points on the leaves, which are a centimetre apart.
                double nearest_m = 1e9;
                for (const OpenLeaf& one : leaves) {
                    const PlacedFrame frame(one.at);
                    for (int i = 0; i <= 90; ++i)
                        for (int k = 0; k <= 5; ++k) {
                            const Vec3 on = frame.to_world({0.01 * i, -0.025 + 0.01 * k, 0.0});
                            nearest_m = std::min(nearest_m, std::hypot(on.x - place.x, on.y - place.y));
                        }
                }
                const double radius_m = space.body.radius_m;
                if (nearest_m < radius_m - 0.01) {
                    ASSERT_EQ(marks[s], kInLeaf) << nearest_m;
                }
                if (nearest_m > radius_m + 0.01) {
                    ASSERT_NE(marks[s], kInLeaf) << nearest_m;
                }
                if (nearest_m > radius_m + kLeafRoom_m + 0.01) {
                    ASSERT_EQ(marks[s], kNoLeaf) << nearest_m;
                }
            }
        }
    }
    EXPECT_TRUE(mark_leaves(corridor(2.0)->space(), {}).empty());
    EXPECT_TRUE(mark_leaves(WalkSpace{}, std::vector{leaf({1, 1, 0}, 0.0)}).empty());
    EXPECT_TRUE(mark_leaves(corridor(2.0)->space(), std::vector{OpenLeaf{}}).empty());
    EXPECT_TRUE(mark_leaves(corridor(2.0)->space(), std::vector{leaf({500, 1, 0}, 0.0)}).empty());
}

TEST(OpenLeaves, are_avoided_if_there_is_room_and_otherwise_crossed) {
    for (const RoutePreference preference : {RoutePreference::Safest, RoutePreference::Shortest})
        for (const Vec3& at : {Vec3(0.0), Vec3(3000.0, -2000.0, 40.0)}) {
            const auto wide = corridor(2.4, at), narrow = corridor(1.2, at);
            const Vec3 from = at + Vec3(1, 0.6, 0), to = at + Vec3(11, 0.6, 0);
            const Route plain = wide->plan(from, to, preference);
            ASSERT_TRUE(plain.reaches);
            // The leaf reaches across the corridor from the south wall and leaves a metre and a half in the north.
            wide->know_leaves(std::vector{leaf(at + Vec3(6, 0, 0), 0.5 * kPi)});
            EXPECT_TRUE(wide->meets_leaf(plain.points_m));
            for (const bool back : {false, true}) {
                const Route round = back ? wide->plan(to, from, preference) : wide->plan(from, to, preference);
                EXPECT_TRUE(round.reaches);
                EXPECT_FALSE(wide->meets_leaf(round.points_m));
                EXPECT_LT(round.length_m, plain.length_m + 1.0);
                EXPECT_LT(glm::length(round.points_m.back() - (back ? from : to)), 0.1);
            }
            // Nobody can walk around the leaf. The route must lead through it, because a person can shut the door.
            narrow->know_leaves(std::vector{leaf(at + Vec3(6, 0, 0), 0.5 * kPi)});
            const Route through = narrow->plan(from, to, preference);
            EXPECT_TRUE(through.reaches);
            EXPECT_TRUE(narrow->meets_leaf(through.points_m));
            EXPECT_LT(through.length_m, 11.0);
            // If a leaf covers the goal, the route must end next to the leaf.
            const Route over = wide->plan(from, at + Vec3(6, 0.6, 0), preference);
            EXPECT_TRUE(over.reaches);
            EXPECT_FALSE(wide->meets_leaf(over.points_m));
            EXPECT_LT(glm::length(over.points_m.back() - (at + Vec3(6, 0.6, 0))), 0.6);
            EXPECT_EQ(*wide->nearest_place(at + Vec3(6, 0.6, 0)), over.points_m.back())
                << "which is where one can stand";
            // When the door is shut again, the route must be the original route.
            wide->know_leaves({});
            EXPECT_FALSE(wide->meets_leaf(plain.points_m));
            EXPECT_EQ(wide->plan(from, to, preference).points_m, plain.points_m);
        }
}

}  // namespace open_leaves_test
}  // namespace handrail
