#include "worlds/navigation/room_outlines.h"
#include "tests/support/project_root.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace room_outlines_test {

struct Floor {
    explicit Floor(const Scene& scene) {
        auto made = make_walk_space(scene, walker_measures(scene, 0.25, 1.8, 0.25));
        EXPECT_TRUE(made);
        space = std::move(*made);
        graph = make_rooms(scene, space);
        outlines = room_outlines(graph, space);
    }
    WalkSpace space;
    RoomGraph graph;
    std::vector<RoomOutline> outlines;
};

// Returns the area of a loop: the sum of the trapezoids below its sides.
double area_m2(const std::vector<Vec2>& loop) {
    double sum_m2 = 0.0;
    Vec2 from = loop.back();
    for (const Vec2& to : loop) {
        sum_m2 += (from.x - to.x) * 0.5 * (from.y + to.y);
        from = to;
    }
    return sum_m2;
}

// Returns how many loops of the outline surround a point.
int loops_around(const RoomOutline& outline, const Vec3& p) {
    int around = 0;
    for (const std::vector<Vec2>& loop : outline.loops_m) {
        bool in = false;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
        }
        around += in;
    }
    return around;
}

// Checks each outline against the places where a walker can stand. Each place must be inside a loop of its room. A loop
// must consist only of corners and run with the room on its left. It may enclose only the room's places and the things
// among them.
void is_sound(const Floor& floor) {
    ASSERT_EQ(floor.outlines.size(), floor.graph.rooms.size());
    std::vector<int> inside(floor.outlines.size(), 0), all(floor.outlines.size(), 0);
    for (std::uint32_t s = 0; s < floor.space.spans.size(); ++s) {
        const std::uint32_t room = floor.graph.room_of_span[s];
        const Vec3 place = floor.space.place_m(s);
        ++all[room];
        inside[room] += loops_around(floor.outlines[room], place) > 0;
        EXPECT_GE(place.z, floor.outlines[room].lowest_m);
        EXPECT_LE(place.z, floor.outlines[room].highest_m);
    }
    for (std::size_t r = 0; r < floor.outlines.size(); ++r) {
        double enclosed_m2 = 0.0;
        for (const std::vector<Vec2>& loop : floor.outlines[r].loops_m) {
            enclosed_m2 += area_m2(loop);
            EXPECT_GE(loop.size(), 4U);
            EXPECT_GT(area_m2(loop), 0.0);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec2 one = loop[(i + 1) % loop.size()] - loop[i],
                           next = loop[(i + 2) % loop.size()] - loop[(i + 1) % loop.size()];
                // Here the loop reverses its direction, at the end of a step.
                const bool back = one.x * next.x + one.y * next.y < 0.0;
                EXPECT_TRUE(back || std::abs(one.x * next.y - one.y * next.x) > 1e-6) << "a corner that is none";
            }
        }
        // Up to half a square metre of a room's places may be outside its loops.
        const double cell_m2 = floor.space.cell_area_m2();
        EXPECT_GE(inside[r] + static_cast<int>(0.5 / cell_m2), all[r]);
        EXPECT_GE(inside[r], all[r] * 9 / 10) << floor.graph.rooms[r].name;
        EXPECT_GE(enclosed_m2 + 1e-6, inside[r] * cell_m2);
    }
}

TEST(RoomOutlines, of_a_room_with_a_pillar_are_one_square_inset_by_the_body_radius) {
    for (const Vec3& at : {Vec3(0.0), Vec3(-812.3, 655.1, 4.0)}) {
        test::SceneBuilder b;
        b.box(at + Vec3(-1, -1, -0.2), at + Vec3(7, 5, 0), "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        b.box(at + Vec3(-0.2, -0.2, 0), at + Vec3(6.2, 0, 2.6), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
        b.box(at + Vec3(-0.2, 4, 0), at + Vec3(6.2, 4.2, 2.6), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
        b.box(at + Vec3(-0.2, 0, 0), at + Vec3(0, 4, 2.6), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
        b.box(at + Vec3(6, 0, 0), at + Vec3(6.2, 4, 2.6), "wall", SolidRole::Solid, {}, FeatureKind::Wall);
        b.box(at + Vec3(2.5, 1.5, 0), at + Vec3(3.5, 2.5, 2.6), "Pillar");
        b.start(at + Vec3(1, 1, 0), 0.0);
        const Floor floor(*b.share());
        ASSERT_EQ(floor.outlines.size(), 1U);
        ASSERT_EQ(floor.outlines[0].loops_m.size(), 1U);
        const std::vector<Vec2>& loop = floor.outlines[0].loops_m[0];
        EXPECT_EQ(loop.size(), 4U);
        EXPECT_NEAR(area_m2(loop), 5.5 * 3.5, 0.02 * 5.5 * 3.5);
        EXPECT_EQ(loops_around(floor.outlines[0], at + Vec3(3, 2, 0)), 1) << "the pillar makes no hole";
        is_sound(floor);
    }
}

TEST(RoomOutlines, contain_each_place_of_their_room_among_random_blocks) {
    std::mt19937 random(test::seed_of_run());
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int run = 0; run < 12; ++run) {
        test::SceneBuilder b;
        b.box({0, 0, -0.2}, {7, 7, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
        for (int i = 0; i < 14; ++i) {
            const Vec3 from(between(0, 6), between(0, 6), 0.0);
            b.box(from, from + Vec3(between(0.1, 2.5), between(0.1, 1.0), i % 2 == 0 ? 2.6 : 0.5), "block");
        }
        b.start({between(0.5, 6.5), between(0.5, 6.5), 0.0}, 0.0);
        const auto scene = b.share();
        if (!make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25)))
            continue;  // the start is inside a block
        is_sound(Floor(*scene));
    }
}

TEST(RoomOutlines, are_valid_in_the_house_with_its_storeys) {
    const auto scene = read_world(test::project_root() / "worlds" / "maps" / "house.map");
    ASSERT_TRUE(scene);
    const Floor floor(*scene);
    is_sound(floor);
    EXPECT_GE(std::count_if(floor.outlines.begin(), floor.outlines.end(),
                            [](const RoomOutline& one) { return !one.loops_m.empty(); }),
              10);
}

}  // namespace room_outlines_test
}  // namespace handrail
