// Tests routes for announced directions, and the simulated walker that follows them, in rooms made of a few boxes.
// Tests that obstacles stop the walker, and that the walker slides along walls and into the doorway whose frame it has
// met. Also tests that routes keep away from edges, and that they report their own errors.
#include "worlds/navigation/directions_route.h"

#include <random>

#include "app/core/world/walker.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace word_route_test {

using test::SceneBuilder;

constexpr double kStep_m = 0.7;

struct Room {
    std::shared_ptr<Navigation> navigation;
    std::unique_ptr<BlindGround> ground;
};

void wall(SceneBuilder& b, const Vec3& low, const Vec3& high) {
    b.box(low, high, "wall", SolidRole::Solid, "brick", FeatureKind::Wall);
}
Room room_of(SceneBuilder& b) {
    const WalkerSize size = walker_size(b.scene(), 0.25);
    auto made = Navigation::make(b.scene(), walker_measures(b.scene(), size.radius_m, size.height_m, size.step_up_m));
    EXPECT_TRUE(made);
    Room room{*made, nullptr};
    room.ground = std::make_unique<BlindGround>(room.navigation->space(), std::vector<DirectionsDoor>{});
    return room;
}
// Returns a space of 10 by 10 m. A wall at y = 5 divides it and has a gap of `gap_m` metres around `gap_x`.
SceneBuilder two_rooms(double gap_x, double gap_m = 0.9) {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {10, 10, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    wall(b, {-0.2, -0.2, 0}, {10.2, 0, 2.6});
    wall(b, {-0.2, 10, 0}, {10.2, 10.2, 2.6});
    wall(b, {-0.2, 0, 0}, {0, 10, 2.6});
    wall(b, {10, 0, 0}, {10.2, 10, 2.6});
    wall(b, {0, 4.9, 0}, {gap_x - 0.5 * gap_m, 5.1, 2.6});
    wall(b, {gap_x + 0.5 * gap_m, 4.9, 0}, {10, 5.1, 2.6});
    b.start({2, 2, 0}, 0.0);
    return b;
}
BlindWalker at(const Room& room, double x, double y) { return room.ground->body_at({x, y, 0.0}); }

TEST(BlindGround, stops_a_body_where_the_walker_stops_and_slides_it_where_the_walker_slides) {
    SceneBuilder b = two_rooms(5.0);
    const Room room = room_of(b);
    const auto scene = b.share();
    const WalkerWorld world(scene);
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    const auto part = [&] { return static_cast<double>(random() % 10001) / 10000.0; };
    for (int i = 0; i < 200; ++i) {
        const double x = 0.5 + 9.0 * part(), y = 0.5 + 3.8 * part(), heading = 2.0 * kPi * part(), far = 6.0 * part();
        // Near the angle that decides between sliding and stopping, and near the frame of the gap, the two walkers may
        // differ.
        const double askew = std::abs(std::remainder(heading, 0.5 * kPi));
        if (std::abs(askew - std::asin(kStoppedBelow)) < 0.15) continue;
        BlindWalker body = at(room, x, y);
        const Paced paced = room.ground->walk(body, heading, far, PaceEnd::Steps, {});
        if (body.at_m.y > 5.0 || (std::abs(body.at_m.x - 5.0) < 1.2 && body.at_m.y > 3.0))
            continue;  // the walker went through the gap, or lined up with it
        Walker walker(world, walker_size(*scene, 0.25));
        walker.place({x, y, 0.0});
        double walked_m = 0.0;
        while (walked_m < paced.walked_m - 1e-6) {
            const double way_m = std::min(0.02, paced.walked_m - walked_m);
            const WalkResult r = walker.tick(forward_of_heading(heading) * (way_m * 60.0), 1.0 / 60.0);
            if (r.walked_m < 0.1 * way_m) break;
            walked_m += r.walked_m;
        }
        EXPECT_NEAR(walker.state().feet_m.x, body.at_m.x, 0.15) << x << " " << y << " " << heading << " " << far;
        EXPECT_NEAR(walker.state().feet_m.y, body.at_m.y, 0.15) << x << " " << y << " " << heading << " " << far;
    }
}

// A landing of stairs leads past the upper part of a door, with a wall between them. Nobody on the landing can reach
// the door, although the body of a walker there is at the height of the leaf.
TEST(BlindGround, lets_a_walker_reach_a_door_from_its_own_floor_only) {
    SceneBuilder b = two_rooms(5.0);
    b.box({0, 5.1, 0}, {10, 7, 1.5}, "landing", SolidRole::Solid, "stone", FeatureKind::Floor);
    b.start({5, 6, 1.5}, 0.0);
    Room room = room_of(b);
    DirectionsDoor door;
    door.leaves.push_back(
        {{{-0.45, -0.02, 0.0}, {0.45, 0.02, 2.1}}, Placement{{5, 5, 0}, {}, 1.0}, Placement{{4, 4.95, 0}, {}, 1.0}});
    const BlindGround ground(room.navigation->space(), {door});
    const auto door_at = [&](const Vec3& feet_m) {
        const BlindWalker body = ground.body_at(feet_m);
        EXPECT_NEAR(ground.feet_m(body).z, feet_m.z, 0.05);
        return ground.door_at(body.span);
    };
    EXPECT_EQ(door_at({5, 4.6, 0}), 0U);
    EXPECT_EQ(door_at({5, 5.2, 1.5}), kNothing);
    EXPECT_EQ(door_at({5, 5.6, 1.5}), kNothing);
}

TEST(BlindGround, slides_a_body_into_the_doorway_whose_frame_it_met_and_into_no_other_gap) {
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    const auto part = [&] { return static_cast<double>(random() % 10001) / 10000.0; };
    for (int i = 0; i < 12; ++i) {
        const double gap_x = 2.0 + 6.0 * part();
        SceneBuilder b = two_rooms(gap_x);
        const Room room = room_of(b);
        for (int k = 0; k < 20; ++k) {
            const double off_m = (2.0 * part() - 1.0) * 1.5, heading = (2.0 * part() - 1.0) * 0.3;
            BlindWalker body = at(room, gap_x + off_m, 4.6);
            if (!room.navigation->space().straight({gap_x + off_m, 4.6, 0}, {gap_x + off_m, 4.3, 0})) continue;
            const auto aside_m = room.ground->line_up_m(body, heading, {});
            if (aside_m) {
                EXPECT_LE(std::abs(*aside_m), kLineUp_m + 0.1);
                EXPECT_LE(*aside_m * off_m, 0.0) << "away from the doorway";
            }
            // The gap leaves 20 cm free on each side of the walker. Up to an offset of 0.55 m, the walker must always
            // find the gap; beyond 0.95 m, never. In between, the walker may drift on the way to the wall, so either
            // result is allowed.
            const bool sure = std::abs(off_m) < 0.55;
            if (sure) {
                EXPECT_TRUE(aside_m) << off_m << " " << heading;
            }
            if (std::abs(off_m) > 0.95) {
                EXPECT_FALSE(aside_m) << off_m << " " << heading;
            }
            const Paced paced = room.ground->walk(body, heading, 3.0, PaceEnd::Steps, {});
            if (sure) {
                EXPECT_GT(body.at_m.y, 5.2) << off_m << " " << heading;
            }
            if (std::abs(off_m) > 0.95) {
                EXPECT_TRUE(paced.stopped);
            }
        }
    }
    // A gap of three metres is not a doorway. If a walker hits its corner, the walker must stop.
    SceneBuilder wide = two_rooms(5.0, 3.0);
    const Room room = room_of(wide);
    EXPECT_FALSE(room.ground->line_up_m(at(room, 3.4, 4.6), 0.0, {}));
}

// Searches for the doorway in a simple way, in a world without doors. This reference walker makes each stride in full
// and checks the borders of its cell.
struct PlainStrides {
    const WalkSpace& space;
    double stride_m = 0.8 * space.cell_m;

    bool go(BlindWalker& body, const Vec2& by_m, bool& edge) const {
        bool moved = false;
        for (int axis = 0; axis < 2; ++axis) {
            if (by_m[axis] == 0.0) continue;
            const WalkSpan& span = space.spans[body.span];
            const std::uint32_t at = axis == 0 ? span.cell % space.width : span.cell / space.width;
            const double low = space.origin_m[axis] + at * space.cell_m, to = body.at_m[axis] + by_m[axis];
            if (!(to > low && to < low + space.cell_m)) {
                const std::uint32_t next = span.next[axis + (by_m[axis] > 0.0 ? 0 : 2)];
                edge = edge || (next == kNothing && span.near_edge);
                if (next == kNothing) continue;
                body.span = next;
            }
            body.at_m[axis] = to;
            moved = true;
        }
        return moved;
    }
    double goes_m(BlindWalker& body, const Vec2& way, double most_m) const {
        bool edge = false;
        const Vec2 start = body.at_m;
        for (double left_m = most_m; left_m > 0.0 && !edge; left_m -= stride_m)
            if (!go(body, way * stride_m, edge)) break;
        return edge ? 0.0 : glm::dot(body.at_m - start, way);
    }
    std::optional<double> line_up_m(const BlindWalker& body, double heading_rad) const {
        const Vec2 ahead{std::sin(heading_rad), std::cos(heading_rad)}, right{ahead.y, -ahead.x};
        const auto opens = [&](BlindWalker probe) {
            const bool deep = goes_m(probe, ahead, kLineUpDeep_m) >= kLineUpDeep_m - 2.0 * stride_m;
            BlindWalker one = probe, other = probe;
            return deep && goes_m(one, -right, kDoorway_m) + goes_m(other, right, kDoorway_m) < kDoorway_m;
        };
        if (opens(body)) return 0.0;
        BlindWalker sides[2] = {body, body};
        bool goes[2] = {true, true};
        for (double aside_m = stride_m; aside_m <= kLineUp_m; aside_m += stride_m)
            for (const int side : {0, 1}) {
                const double sign = side == 0 ? 1.0 : -1.0;
                goes[side] = goes[side] && goes_m(sides[side], right * sign, stride_m) > 0.25 * stride_m;
                if (goes[side] && opens(sides[side])) return sign * (aside_m + stride_m);
            }
        return std::nullopt;
    }
};

TEST(BlindGround, lines_up_bit_identically_to_a_full_length_search_that_checks_every_stride) {
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    const auto part = [&] { return static_cast<double>(random() % 10001) / 10000.0; };
    int there = 0, edges = 0;
    for (const double far_m : {0.0, 1e5}) {
        SceneBuilder b = two_rooms(2.0 + 6.0 * part(), 0.8 + 0.8 * part());
        // The terrace gives the space edges.
        b.box({10, 0, -0.2}, {12, 12, 0}, "terrace", SolidRole::Solid, "stone", FeatureKind::Floor);
        b.start({11, 6, 0}, 0.0);
        for (int i = 0; i < 4; ++i) {
            const double x = 9.0 * part(), y = 9.0 * part();
            wall(b, {x, y, 0}, {x + 0.1 + part(), y + 0.1 + part(), 2.6});
        }
        const Room room = room_of(b);
        WalkSpace moved = room.navigation->space();  // far from the origin, rounding makes the values coarser
        moved.origin_m += Vec3(far_m, -far_m, 0.0);
        const BlindGround ground(moved, {});
        const PlainStrides twin{moved};
        for (int i = 0; i < 2000; ++i) {
            const Vec3 place = moved.place_m(static_cast<std::uint32_t>(random() % moved.spans.size()));
            const double dx = 0.04 * part() - 0.02, dy = 0.04 * part() - 0.02;
            const BlindWalker body = ground.body_at(place + Vec3(dx, dy, 0.0));
            const double heading = i % 2 ? 2.0 * kPi * part() : notch_heading_rad(static_cast<int>(random() % 16));
            const auto found = ground.line_up_m(body, heading, {}), expected = twin.line_up_m(body, heading);
            ASSERT_EQ(found, expected) << far_m << " " << body.at_m.x << " " << body.at_m.y << " " << heading;
            there += found ? 1 : 0;
            edges += moved.spans[body.span].near_edge ? 1 : 0;
        }
    }
    EXPECT_GT(there, 20);
    EXPECT_GT(edges, 20);
}

TEST(BlindGround, gives_mirrored_answers_for_a_mirrored_room) {
    SceneBuilder b = two_rooms(4.0), mirrored = two_rooms(6.0);
    const Room one = room_of(b), other = room_of(mirrored);
    for (const double off_m : {-0.8, -0.6, -0.5, -0.4, -0.3, 0.0, 0.3, 0.4, 0.5, 0.6, 0.8}) {
        const auto a = one.ground->line_up_m(at(one, 4.0 + off_m, 4.6), 0.0, {}),
                   c = other.ground->line_up_m(at(other, 6.0 - off_m, 4.6), 0.0, {});
        EXPECT_EQ(a.has_value(), c.has_value()) << off_m;
        if (a && c) {
            EXPECT_NEAR(*a, -*c, 0.11) << off_m;
        }
    }
}

TEST(DirectionsRoute, passes_a_doorway_with_walking_errors_in_a_few_legs) {
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    const auto part = [&] { return static_cast<double>(random() % 10001) / 10000.0; };
    for (int i = 0; i < 10; ++i) {
        SceneBuilder b = two_rooms(1.0 + 8.0 * part());
        const Room room = room_of(b);
        const DirectionsPlanner planner(*room.ground, kStep_m);
        const Vec3 from(0.5 + 9.0 * part(), 0.5 + 3.5 * part(), 0.0);
        DirectionsGoal goal(room.navigation->space().spans.size(), 0);
        for (std::uint32_t s = 0; s < goal.size(); ++s) goal[s] = room.navigation->space().place_m(s).y > 5.5 ? 1 : 0;
        const auto route = planner.plan(from, 0.0, goal, {});
        ASSERT_TRUE(route);
        EXPECT_LE(route->legs.size(), 6U);
        EXPECT_EQ(planner.try_out(*route, from, 0.0, goal, {}, {0.0, 0.0, 0.0}, 1, 1), 1);
        EXPECT_GE(planner.try_out(*route, from, 0.0, goal, {}, {}, 100, random()), 90);
        for (const DirectionsLeg& leg : route->legs) {
            EXPECT_GE(leg.steps, 1);
            EXPECT_GE(leg.turn_notches, -7);
            EXPECT_LE(leg.turn_notches, 8);
        }
    }
}

// A doorway between two rooms is in neither outline, although its floor belongs to one of the rooms in the room graph.
TEST(DirectionsRoute, ends_within_the_outline_that_the_file_states_for_a_room) {
    SceneBuilder b = two_rooms(5.0);
    const Room room = room_of(b);
    const WalkSpace& space = room.navigation->space();
    StatedRoom outline;
    outline.rings = {{{0.0, 6.0}, {10.0, 6.0}, {10.0, 9.0}, {0.0, 9.0}}};
    outline.height_m = 2.5;
    std::vector<std::uint32_t> room_of_span(space.spans.size(), 0);
    RoomGraph graph;
    graph.rooms.resize(1);
    graph.rooms[0].middle_m = {5.0, 7.5, 0.0};
    graph.room_of_span = room_of_span;
    auto stated = std::make_shared<StatedBuilding>();
    stated->rooms.push_back(outline);
    Scene scene;
    scene.stated = stated;
    const DirectionsGoal goal = goal_in_room(space, room_of_span, 0, &outline);
    std::size_t in = 0;
    for (std::uint32_t s = 0; s < goal.size(); ++s) {
        const Vec3 at_m = space.place_m(s);
        if (goal[s]) {
            EXPECT_GT(at_m.y, 6.0) << at_m.x;
        }
        if (stands_inside(graph, space, scene, at_m, 0)) {
            EXPECT_GT(at_m.y, 6.0) << at_m.x;
        }
        in += goal[s];
    }
    EXPECT_GT(in, 100U);
    EXPECT_TRUE(stands_inside(graph, space, scene, {5.0, 7.5, 0.0}, 0));
    EXPECT_FALSE(stands_inside(graph, space, scene, {5.0, 6.1, 0.0}, 0)) << "a hand's breadth inside";
}

// A place has ended a route if the walker can go straight on to its goal. Behind the wall, no place has.
TEST(DirectionsRoute, to_a_place_ends_where_every_place_near_it_in_a_straight_line_is) {
    constexpr double kWithin_m = 0.8;
    SceneBuilder b = two_rooms(5.0);
    const Room room = room_of(b);
    const WalkSpace& space = room.navigation->space();
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    std::size_t in = 0;
    for (int i = 0; i < 50; ++i) {
        const Vec3 at_m = space.place_m(static_cast<std::uint32_t>(random() % space.spans.size()));
        const DirectionsGoal goal = goal_at_place(space, at_m, kWithin_m);
        for (std::uint32_t s = 0; s < goal.size(); ++s) {
            const Vec3 off_m = space.place_m(s) - at_m;
            const bool near = std::hypot(off_m.x, off_m.y) <= kWithin_m && space.straight(space.place_m(s), at_m);
            ASSERT_EQ(goal[s] != 0, near) << at_m.x << ' ' << at_m.y << " from " << off_m.x << ' ' << off_m.y;
            in += goal[s];
        }
    }
    EXPECT_GT(in, 1000U);
    const DirectionsGoal none = goal_at_place(space, {50.0, 50.0, 0.0}, kWithin_m);
    EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
}

TEST(DirectionsRoute, does_not_exist_to_an_unreachable_place_or_after_cancellation) {
    SceneBuilder b = two_rooms(5.0, 0.3);  // the gap is too narrow for the walker
    b.start({2, 8, 0}, 0.0);
    const Room room = room_of(b);
    const DirectionsPlanner planner(*room.ground, kStep_m);
    DirectionsGoal north(room.navigation->space().spans.size(), 0), south = north;
    bool any = false;
    for (std::uint32_t s = 0; s < north.size(); ++s) {
        north[s] = room.navigation->space().place_m(s).y > 5.5 ? 1 : 0;
        south[s] = room.navigation->space().place_m(s).y < 1.0 ? 1 : 0;
        any = any || north[s];
    }
    ASSERT_TRUE(any);
    EXPECT_FALSE(planner.plan({2, 4, 0}, 0.0, north, {}));
    EXPECT_TRUE(planner.plan({2, 4, 0}, 0.0, south, {}));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(planner.plan({2, 4, 0}, 0.0, south, {}, {}, stop.get_token()));
}

// A lobby between two rooms is so small that the open leaf of its first door leaves no room to reach the second door.
TEST(DirectionsRoute, shuts_the_door_whose_leaf_leaves_no_room_to_the_next_door) {
    SceneBuilder b = two_rooms(5.0);
    wall(b, {4.1, 5.1, 0}, {4.3, 6.4, 2.6});
    wall(b, {5.7, 5.1, 0}, {5.9, 6.4, 2.6});
    wall(b, {4.3, 6.3, 0}, {4.55, 6.4, 2.6});
    wall(b, {5.45, 6.3, 0}, {5.7, 6.4, 2.6});
    const Room room = room_of(b);
    const WalkSpace& space = room.navigation->space();
    DirectionsGoal goal(space.spans.size(), 0);
    for (std::uint32_t s = 0; s < goal.size(); ++s) goal[s] = space.place_m(s).y > 7.0 ? 1 : 0;
    const Aabb leaf{{-0.45, -0.02, 0.0}, {0.45, 0.02, 2.1}};
    const Vec3 from{4.0, 2.0, 0.0};
    for (const bool blocks : {false, true}) {
        SCOPED_TRACE(blocks);
        DirectionsDoor first, second;
        second.mover = second.group = 1;
        first.leaves.push_back({leaf, Placement{{5, 5, 0}, {}, 1.0}, Placement{{blocks ? 5.0 : 2.0, 5.7, 0}, {}, 1.0}});
        second.leaves.push_back({leaf, Placement{{5, 6.35, 0}, {}, 1.0}, Placement{{5, 9.5, 0}, {}, 1.0}});
        const BlindGround ground(space, {first, second});
        const DirectionsPlanner planner(ground, kStep_m);
        const auto route = planner.plan(from, 0.0, goal, ground.all_shut());
        ASSERT_TRUE(route);
        EXPECT_EQ(route->shuts_leaves, blocks);
        EXPECT_GE(route->came, 90);
        EXPECT_GE(planner.try_out(*route, from, 0.0, goal, ground.all_shut(), {}, 50, 7), 45);
        DirectionsRoute leaves_open = *route;
        leaves_open.shuts_leaves = false;
        EXPECT_EQ(planner.try_out(leaves_open, from, 0.0, goal, ground.all_shut(), {}, 50, 7) == 0, blocks);
    }
}

// The platform ends on two sides with a drop of half a metre.
TEST(DirectionsRoute, never_leads_a_body_with_walking_errors_over_an_edge) {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {3, 12, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({3, 0, -1.2}, {10, 9, -1.0}, "pit", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({3, 9, -0.2}, {10, 12, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    wall(b, {-0.2, -0.2, -1.2}, {10.2, 0, 2.6});
    wall(b, {-0.2, 12, -1.2}, {10.2, 12.2, 2.6});
    wall(b, {-0.2, 0, -1.2}, {0, 12, 2.6});
    wall(b, {10, 0, -1.2}, {10.2, 12, 2.6});
    b.start({1.5, 2, 0}, 0.0);
    const Room room = room_of(b);
    const DirectionsPlanner planner(*room.ground, kStep_m);
    const Vec3 from(1.2, 1.5, 0.0);
    const DirectionsGoal goal = goal_at_place(room.navigation->space(), {9.0, 11.0, 0.0}, 1.0);
    const auto route = planner.plan(from, 0.0, goal, {});
    ASSERT_TRUE(route);
    const auto scene = b.share();
    const WalkerWorld world(scene);
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    const auto error = [&] { return static_cast<double>(random() % 20001) / 10000.0 - 1.0; };
    for (int i = 0; i < 30; ++i) {
        Walker walker(world, walker_size(*scene, 0.25));
        walker.place(from);
        int notch = 0;
        for (const DirectionsLeg& leg : route->legs) {
            notch += leg.turn_notches;
            const double heading = notch_heading_rad(notch) + 0.087 * error();
            const double most_m = leg.steps * kStep_m * (leg.end == PaceEnd::Steps ? 1.0 + 0.1 * error() : 1.5);
            for (double walked_m = 0.0; walked_m < most_m; walked_m += 0.02)
                walker.tick(forward_of_heading(heading) * 1.2, 1.0 / 60.0);
        }
        EXPECT_NEAR(walker.state().feet_m.z, 0.0, 0.01) << i;
    }
}

}  // namespace word_route_test
}  // namespace handrail
