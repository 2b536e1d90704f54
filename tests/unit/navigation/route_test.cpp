// Compares routes with a brute-force search, and tests routes in unusual worlds.
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/navigation/grid_twin.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/validate_ways.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace route_test {

using test::GridTwin;
using test::SceneBuilder;

std::shared_ptr<Navigation> navigate(const Scene& scene) {
    const WalkerSize size = walker_size(scene, 0.25);
    auto made = Navigation::make(scene, walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    return made ? *made : nullptr;
}

Scene bundled(const std::string& name) {
    auto scene = read_world(test::project_root() / "worlds" / "maps" / name);
    EXPECT_TRUE(scene);
    return std::move(*scene);
}

// Returns places next to every named thing on a floor, where a walker can stand.
std::vector<Vec3> places_beside_things(const Scene& scene, Navigation& navigation) {
    std::vector<Vec3> places;
    for (const Start& start : scene.starts) places.push_back(start.feet_m);
    for (const Feature& feature : scene.features)
        if (feature.kind == FeatureKind::Object && feature.landmark)
            if (const auto place = navigation.nearest_place(
                    {feature.bounds_m.centre_m().x, feature.bounds_m.centre_m().y, feature.bounds_m.min_m.z}))
                places.push_back(*place);
    return places;
}

// The grid search runs for a slightly thinner and a slightly wider walker. The length of the program's route must be
// between theirs, so that the size of the grid's squares does not matter.
constexpr double kThinner_m = 0.03;

struct Twins {
    Twins(const Scene& scene, double side_m)
        : thin(scene, size_by(scene, -kThinner_m), side_m),
          wide(scene, size_by(scene, kThinner_m), side_m),
          side(side_m) {}
    static WalkerSize size_by(const Scene& scene, double more_m) {
        WalkerSize size = walker_size(scene, 0.25);
        size.radius_m += more_m;
        return size;
    }
    GridTwin thin, wide;
    double side;
};

void agree(const Route& route, const Vec3& to, std::optional<double> least_m, std::optional<double> most_m,
           double side_m, int& compared) {
    if (route.drops) return;  // the grid search never steps off an edge
    const bool there = route.reaches && glm::length(route.points_m.back() - to) < 0.4;
    if (most_m) {
        EXPECT_TRUE(there) << "the wider body comes there in " << *most_m;
    }
    if (there) {
        EXPECT_TRUE(least_m) << "even the thinner body does not come there";
    }
    if (!there || !least_m || !most_m) return;
    EXPECT_LE(test::length_with_rides_m(route), 1.05 * *most_m + side_m);
    EXPECT_GE(test::length_with_rides_m(route), 0.95 * *least_m - side_m);
    ++compared;
}

// Checks whether a walker gets from `from` to each of `places`, and how long the shortest route is. If `back` is true,
// also checks the routes back. Inside a building a route back is as long as the route there, unless a walker can get
// down from a high box but not up again.
int agrees_with(const Twins& twins, Navigation& navigation, const Vec3& from, const std::vector<Vec3>& places,
                bool back) {
    int compared = 0;
    const auto least = twins.thin.lengths(from, places), most = twins.wide.lengths(from, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        SCOPED_TRACE(::testing::Message() << "between " << from.x << " " << from.y << " " << from.z << " and "
                                          << places[i].x << " " << places[i].y << " " << places[i].z);
        agree(navigation.plan(from, places[i], RoutePreference::Shortest), places[i], least[i], most[i], twins.side,
              compared);
        if (back)
            agree(navigation.plan(places[i], from, RoutePreference::Shortest), from, least[i], most[i], twins.side,
                  compared);
    }
    return compared;
}

TEST(Routes, agree_with_a_grid_search_between_all_landmarks_of_every_bundled_world) {
    for (const auto& entry : std::filesystem::directory_iterator(test::project_root() / "worlds" / "maps")) {
        if (entry.path().extension() != ".map") continue;
        SCOPED_TRACE(entry.path().filename().string());
        if (!test::tried(entry.path().filename() == "house.map" ? 0 : 1, 2)) continue;
        const Scene scene = bundled(entry.path().filename().string());
        const auto navigation = navigate(scene);
        ASSERT_TRUE(navigation);
        const std::vector<Vec3> places = places_beside_things(scene, *navigation);
        Twins twins(scene, 0.1);
        for (const Vec3& place : places) {
            twins.thin.flood_from(place);
            twins.wide.flood_from(place);
        }
        int compared = 0;
        for (std::size_t i = 0; i < places.size(); i += test::source_stride())
            compared += agrees_with(twins, *navigation, places[i], test::from_on(places, i), true);
        EXPECT_GT(compared, 0);
    }
}

// Returns a closed field with walls that have gaps of all widths, and with boxes of all heights.
Scene random_world(std::mt19937& random, const Vec3& at) {
    SceneBuilder builder;
    const auto draw = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto box = [&](const Vec3& a, const Vec3& b) {
        builder.box(at + a, at + b, "block", SolidRole::Solid, {}, FeatureKind::Wall);
    };
    constexpr double kSize = 10.0;
    box({0, 0, -0.2}, {kSize, kSize, 0});
    box({-0.2, 0, -0.2}, {0, kSize, 2.5});
    box({kSize, 0, -0.2}, {kSize + 0.2, kSize, 2.5});
    box({0, -0.2, -0.2}, {kSize, 0, 2.5});
    box({0, kSize, -0.2}, {kSize, kSize + 0.2, 2.5});
    for (int wall = 1; wall < 3; ++wall) {
        const double x = kSize * wall / 3.0 + draw(-0.5, 0.5), gap = draw(0.0, kSize - 1.0);
        // The gap is clearly wide enough or clearly too narrow for a walker who is half a metre wide.
        const double width = std::bernoulli_distribution(0.8)(random) ? draw(0.75, 1.2) : draw(0.1, 0.35);
        box({x, 0, 0}, {x + 0.15, gap, 2.5});
        box({x, gap + width, 0}, {x + 0.15, kSize, 2.5});
    }
    for (int i = 0; i < 6; ++i) {
        const Vec3 a{draw(0.5, 8.0), draw(0.5, 8.0), 0};
        // The walker must go around the high boxes and can step over the low ones.
        const double high = std::bernoulli_distribution(0.5)(random) ? draw(0.4, 2.0) : draw(0.05, 0.2);
        box(a, a + Vec3(draw(0.2, 1.5), draw(0.2, 1.5), high));
    }
    builder.start(at + Vec3(0.3, 0.3, 0), 0.0);
    return builder.scene();
}

TEST(Routes, agree_with_a_grid_search_in_random_worlds_of_boxes_and_walls) {
    std::mt19937 random(test::seed_of_run());
    for (int world = 0; world < 12; ++world) {
        SCOPED_TRACE("seed " + std::to_string(test::seed_of_run()) + " world " + std::to_string(world));
        const Vec3 at = world % 3 == 2 ? Vec3(2e5, -1e5, 300.0) : Vec3(0.0);
        const Scene scene = random_world(random, at);
        std::vector<Vec3> places{at + Vec3(0.3, 0.3, 0)};
        Twins twins(scene, 0.1);
        twins.thin.flood_from(places[0]);
        twins.wide.flood_from(places[0]);
        for (int i = 0; i < 8; ++i) {
            const Vec3 place = at + Vec3(std::uniform_real_distribution<double>(0.3, 9.7)(random),
                                         std::uniform_real_distribution<double>(0.3, 9.7)(random), 0);
            if (twins.wide.flood_from(place) && twins.thin.flood_from(place)) places.push_back(place);
        }
        const auto navigation = navigate(scene);
        ASSERT_TRUE(navigation);
        agrees_with(twins, *navigation, places[0], places, false);
    }
}

// Moves the walker's body along every stretch of each route. No solid may be in its way.
TEST(Routes, can_be_walked_by_a_simulated_walker) {
    const Scene scene = bundled("house.map");
    const auto navigation = navigate(scene);
    ASSERT_TRUE(navigation);
    const WalkerWorld world(test::without_doors(scene));
    const WalkerSize size = walker_size(scene, 0.25);
    const std::vector<Vec3> places = places_beside_things(scene, *navigation);
    ASSERT_GE(places.size(), 12U);
    int walked = 0;
    for (const Vec3& to : places)
        for (const RoutePreference preference : {RoutePreference::Safest, RoutePreference::Shortest}) {
            const Route route = navigation->plan(places[0], to, preference);
            ASSERT_TRUE(route.reaches);
            Walker walker(world, size);
            walker.place(route.points_m.front());
            std::size_t next = 1;
            for (int tick = 0; tick < 6000 && next < route.points_m.size(); ++tick) {
                Vec3 off = route.points_m[next] - walker.state().feet_m;
                off.z = 0.0;
                if (glm::length(off) < 0.08) ++next;
                else walker.tick(off / std::max(glm::length(off), 0.02), 0.02);
            }
            EXPECT_EQ(next, route.points_m.size())
                << to.x << " " << to.y << " " << to.z << " stuck at " << walker.state().feet_m.x << " "
                << walker.state().feet_m.y << " " << walker.state().feet_m.z;
            ++walked;
        }
    EXPECT_GE(walked, 24);
}

TEST(Routes, keep_away_from_walls_if_there_is_room_and_are_hardly_longer) {
    const Scene scene = bundled("house.map");
    const auto navigation = navigate(scene);
    ASSERT_TRUE(navigation);
    const auto near_walls = [&](const Route& route) {
        double close_m = 0.0;
        for (std::size_t i = 1; i < route.points_m.size(); ++i) {
            std::size_t all = 0, close = 0;
            navigation->space().straight(route.points_m[i - 1], route.points_m[i], [&](std::uint32_t s) {
                ++all;
                close += navigation->space().spans[s].clearance_m < 0.2F ? 1 : 0;
            });
            if (all > 0)
                close_m += glm::length(route.points_m[i] - route.points_m[i - 1]) * static_cast<double>(close) /
                           static_cast<double>(all);
        }
        return close_m;
    };
    double safest_close = 0.0, shortest_close = 0.0, safest_long = 0.0, shortest_long = 0.0;
    const std::vector<Vec3> places = places_beside_things(scene, *navigation);
    for (const Vec3& from : places)
        for (const Vec3& to : places) {
            const Route safest = navigation->plan(from, to, RoutePreference::Safest),
                        shortest = navigation->plan(from, to, RoutePreference::Shortest);
            EXPECT_EQ(safest.reaches, shortest.reaches);
            EXPECT_LE(safest.length_m, 1.5 * shortest.length_m + 1.0);
            safest_close += near_walls(safest);
            shortest_close += near_walls(shortest);
            safest_long += safest.length_m;
            shortest_long += shortest.length_m;
        }
    EXPECT_LT(safest_close, 0.8 * shortest_close);
    EXPECT_LT(safest_long, 1.12 * shortest_long);
}

TEST(Routes, list_the_doors_and_stairs_along_the_route_in_order) {
    const Scene scene = bundled("house.map");
    const auto navigation = navigate(scene);
    ASSERT_TRUE(navigation);
    const auto thing = [&](const std::string& name) {
        for (const Feature& feature : scene.features)
            if (feature.name == name)
                return Vec3(feature.bounds_m.centre_m().x, feature.bounds_m.centre_m().y, feature.bounds_m.min_m.z);
        ADD_FAILURE() << name;
        return Vec3(0.0);
    };
    const Route route = navigation->plan(thing("Letter box"), thing("Piano"));
    ASSERT_TRUE(route.reaches);
    std::vector<std::string> met;
    for (std::size_t i = 0; i < route.passages.size(); ++i) {
        const RoutePassage& passage = route.passages[i];
        met.push_back(scene.find(passage.feature) ? scene.find(passage.feature)->name : "");
        EXPECT_GE(passage.at_m, i > 0 ? route.passages[i - 1].at_m : 0.0);
        if (passage.kind == PassageKind::Stairs) {
            EXPECT_NEAR(passage.rise_m, 2.9, 0.35);
        }
    }
    EXPECT_EQ(met, (std::vector<std::string>{"Front door", "Stairs", "Music room door"}));
}

void say_where_the_route_ends(const Scene& scene) {
    const auto navigation = navigate(scene);
    ASSERT_TRUE(navigation);
    int reached = 0, not_reached = 0;
    for (const Start& start : scene.starts) {
        const Route route = navigation->plan(scene.starts.front().feet_m, start.feet_m);
        ASSERT_FALSE(route.points_m.empty());
        (route.reaches ? reached : not_reached)++;
        EXPECT_EQ(route.reaches, navigation->reachable(scene.starts.front().feet_m, start.feet_m));
        if (route.reaches) continue;
        EXPECT_GT(route.short_of_m, 1.0);
        // The walker must be able to reach the place where the route ends.
        EXPECT_TRUE(navigation->plan(scene.starts.front().feet_m, route.points_m.back()).reaches);
    }
    EXPECT_GT(reached, 0);
    EXPECT_GT(not_reached, 0);
}

// Two rooms of 8 by 4 m. The wall between them has no door.
TEST(Routes, report_where_the_connection_ends_if_a_room_has_no_door) {
    using test::entity;
    using test::key;
    const auto start = [](const char* at) { return entity("info_player_deathmatch", key("origin", at)); };
    const auto scene = read_quake_map(
        entity("worldspawn", {}, test::room_brushes(0, 0, 0, 520, 128, 96) + test::box_brush(256, 0, 0, 264, 128, 96)) +
            entity("info_player_start", key("origin", "64 64 24")) + start("192 64 24") + start("456 64 24"),
        "shut.map");
    ASSERT_TRUE(scene) << scene.error().sentence();
    say_where_the_route_ends(*scene);
}

TEST(Routes, report_where_the_connection_ends_in_real_maps) {
    for (const char* name : {"quake-e1m1.map", "quake-start.map"}) {
        SCOPED_TRACE(name);
        const auto path = test::real_world(name);
        if (!path) GTEST_SKIP() << test::needs_real_world(name);
        const auto scene = read_world(*path);
        ASSERT_TRUE(scene) << scene.error().sentence();
        say_where_the_route_ends(*scene);
    }
}

TEST(Routes, use_lifts_in_both_directions_and_teleporters_and_drops_in_one) {
    using test::box_brush;
    using test::entity;
    using test::key;
    // A low floor, and a high floor 160 units above it. A lift joins them at x 0 to 64. A teleporter at the west end of
    // the low floor leads to a separate cell.
    const std::string text =
        entity("worldspawn", key("wad", ""),
               box_brush(-512, -256, -16, 512, 256, 0) + box_brush(64, -256, 0, 512, 256, 160) +
                   box_brush(0, -256, 0, 64, -32, 160) + box_brush(0, 32, 0, 64, 256, 160) +
                   box_brush(-512, -272, -16, 512, -256, 320) + box_brush(-512, 256, -16, 512, 272, 320) +
                   box_brush(-528, -272, -16, -512, 272, 320) + box_brush(512, -272, -16, 528, 272, 320) +
                   box_brush(1000, 1000, -16, 1200, 1200, 0)) +
        entity("func_plat", {}, box_brush(0, -32, 0, 64, 32, 160)) +
        entity("trigger_teleport", key("target", "cell"), box_brush(-480, -32, 0, -416, 32, 64, "trigger")) +
        entity("info_teleport_destination", key("targetname", "cell") + key("origin", "1100 1100 24")) +
        entity("info_player_start", key("origin", "-200 0 24")) +
        entity("info_player_deathmatch", key("origin", "300 0 184"));
    const auto scene = read_quake_map(text, "lift.map");
    ASSERT_TRUE(scene);
    ASSERT_TRUE(scene->game_map);
    const auto navigation = navigate(*scene);
    ASSERT_TRUE(navigation);
    const Vec3 low = scene->starts[0].feet_m, high = scene->starts[1].feet_m, cell{1100.0 / 32, 1100.0 / 32, 0.0};
    const Route up = navigation->plan(low, high);
    ASSERT_TRUE(up.reaches);
    ASSERT_EQ(up.passages.size(), 1U);
    EXPECT_EQ(up.passages[0].kind, PassageKind::Lift);
    EXPECT_NEAR(up.passages[0].rise_m, (160.0 - 8.0) / 32.0, 0.02);
    EXPECT_FALSE(up.drops);
    const Route down = navigation->plan(high, low);
    ASSERT_TRUE(down.reaches);
    EXPECT_FALSE(down.drops) << "the lift is safer than jumping off";
    EXPECT_EQ(navigation->plan(high, low, RoutePreference::Shortest).passages.size(), 1U);
    const Route away = navigation->plan(low, cell);
    ASSERT_TRUE(away.reaches);
    EXPECT_EQ(away.passages.back().kind, PassageKind::Teleporter);
    const Route back = navigation->plan(cell, low);
    EXPECT_FALSE(back.reaches);
    EXPECT_GT(back.short_of_m, 20.0);
    EXPECT_FALSE(navigation->plan(low, high, RoutePreference::OnFoot).reaches) << "there are no stairs";
}

TEST(Routes, on_foot_use_the_stairs_even_if_a_lift_is_nearer) {
    const auto scene = read_world(test::project_root() / "worlds" / "maps" / "school.map");
    ASSERT_TRUE(scene);
    const auto navigation = navigate(*scene);
    ASSERT_TRUE(navigation);
    // Places in front of the lift's lower door and in front of its upper one.
    const Vec3 below(14.15, 10.2, 0.0), above(14.15, 10.2, 3.4);
    const auto takes = [](const Route& route, PassageKind kind) {
        return std::any_of(route.passages.begin(), route.passages.end(),
                           [kind](const RoutePassage& passage) { return passage.kind == kind; });
    };
    const Route near = navigation->plan(below, above), foot = navigation->plan(below, above, RoutePreference::OnFoot);
    ASSERT_TRUE(near.reaches);
    ASSERT_TRUE(foot.reaches);
    EXPECT_TRUE(takes(near, PassageKind::Lift));
    EXPECT_FALSE(takes(foot, PassageKind::Lift));
    EXPECT_TRUE(takes(foot, PassageKind::Stairs));
    EXPECT_GT(foot.length_m, near.length_m);
}

TEST(Routes, around_a_blocked_door_lead_back_from_the_door_and_never_through_it) {
    const Scene scene = bundled("school.map");
    const auto navigation = navigate(scene);
    const RoomGraph graph = make_rooms(scene, navigation->space());
    int looked_at = 0, doors = 0;
    for (const Portal& portal : graph.portals) {
        if (portal.kind != PassageKind::Door || portal.feature == kNoFeature || ++doors % 2 == 0 ||
            !test::tried(static_cast<std::size_t>(doors / 2), 6))
            continue;
        const std::vector<Aabb> boxes = door_boxes(scene, graph, portal.feature);
        const Aabb& leaf = scene.features[portal.feature.value].bounds_m;
        const bool thin_x = leaf.max_m.x - leaf.min_m.x < leaf.max_m.y - leaf.min_m.y;
        for (const double off_m : {-0.7, -0.25, 0.4}) {
            const Vec3 start = portal.place_m + (thin_x ? Vec3(off_m, 0.0, 0.0) : Vec3(0.0, off_m, 0.0));
            const std::uint32_t here = room_at(graph, navigation->space(), start);
            if (here == kNothing) continue;
            navigation->block(boxes);
            for (const std::uint32_t room : portal.rooms) {
                // Skips rooms that a walker cannot reach around the blocked place from the middle of the room.
                const Vec3 goal = graph.rooms[room].middle_m;
                if (!navigation->plan(graph.rooms[here].middle_m, goal).reaches) continue;
                const Route round = navigation->plan(start, goal);
                EXPECT_TRUE(round.reaches) << graph.rooms[room].name << " from " << off_m << " m";
                ++looked_at;
                for (std::size_t i = 1; i < round.points_m.size(); ++i)
                    for (double part = 0.0; part <= 1.0; part += 0.01) {
                        const Vec3 at = glm::mix(round.points_m[i - 1], round.points_m[i], part);
                        const bool in_leaf = at.x > leaf.min_m.x && at.x < leaf.max_m.x && at.y > leaf.min_m.y &&
                                             at.y < leaf.max_m.y && std::abs(at.z - portal.place_m.z) < 1.0;
                        ASSERT_FALSE(in_leaf) << graph.rooms[here].name << " to " << graph.rooms[room].name << " from "
                                              << off_m << " m before " << spoken_name(scene, portal.feature);
                    }
            }
        }
    }
    EXPECT_GT(looked_at, test::scaled(20));
}

TEST(Routes, are_the_same_every_time_and_far_from_the_origin) {
    std::mt19937 random(7);
    const Scene scene = random_world(random, Vec3(0.0));
    random.seed(7);
    const Scene far = random_world(random, Vec3(524288.0, -262144.0, 1024.0));
    const auto one = navigate(scene), two = navigate(scene), there = navigate(far);
    ASSERT_TRUE(one && two && there);
    for (int i = 0; i < 20; ++i) {
        const Vec3 to{0.4 + 0.45 * i, 9.0 - 0.4 * i, 0.0};
        const Route a = one->plan({0.3, 0.3, 0.0}, to), b = two->plan({0.3, 0.3, 0.0}, to);
        ASSERT_EQ(a.points_m.size(), b.points_m.size());
        for (std::size_t k = 0; k < a.points_m.size(); ++k) EXPECT_EQ(a.points_m[k], b.points_m[k]);
        const Route c = there->plan(Vec3(524288.3, -262143.7, 1024.0), to + Vec3(524288.0, -262144.0, 1024.0));
        EXPECT_EQ(a.reaches, c.reaches);
        EXPECT_NEAR(a.length_m, c.length_m, 0.02 * a.length_m + 0.05);
    }
}

TEST(Routes, of_worlds_without_floor_are_refused_in_one_sentence) {
    Scene nothing;
    nothing.materials.emplace_back();
    const auto none = Navigation::make(nothing, WalkerMeasures{});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "There is no floor to walk on here, so there are no rooms and no routes.");

    SceneBuilder wall;
    wall.box({0, 0, 0}, {4, 0.01, 3});
    wall.start({2, -1, 0}, 0.0);  // there is nothing below the start
    EXPECT_FALSE(Navigation::make(wall.scene(), WalkerMeasures{}));

    SceneBuilder floor;
    floor.box({0, 0, -1}, {4, 4, 0});
    floor.start({2, 2, 0}, 0.0);
    const auto some = Navigation::make(floor.scene(), WalkerMeasures{});
    ASSERT_TRUE(some);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE((*some)->plan({nan, 0, 0}, {2, 2, 0}).points_m.empty());
    EXPECT_TRUE((*some)->plan({2, 2, 0}, {nan, 0, 0}).points_m.empty());
    EXPECT_TRUE((*some)->plan({2e9, 2, 0}, {2, 2, 0}).points_m.empty());
    const Route here = (*some)->plan({2, 2, 0}, {2, 2, 0});
    EXPECT_TRUE(here.reaches);
    EXPECT_EQ(here.length_m, 0.0);
    const Route beyond = (*some)->plan({2, 2, 0}, {50, 2, 0});
    EXPECT_FALSE(beyond.reaches);
    // The floor supports the walker until the walker's whole body is beyond the edge.
    EXPECT_NEAR(beyond.points_m.back().x, 4.2, 0.15);
    EXPECT_NEAR(beyond.short_of_m, 45.8, 0.2);
}

TEST(Routes, in_a_huge_world_use_larger_cells_and_report_it) {
    SceneBuilder field;
    field.box({-80, -80, -1}, {80, 80, 0}, "field", SolidRole::Solid, {}, FeatureKind::Floor);
    field.start({0, 0, 0}, 0.0);
    WalkerMeasures coarse;
    coarse.cell_m = 0.1;
    const auto made = Navigation::make(field.scene(), coarse);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ((*made)->said().size(), 1U);
    EXPECT_TRUE((*made)->said()[0].starts_with("This world is so large"));
    EXPECT_LT((*made)->space().spans.size(), 2'000'000U);
    EXPECT_NEAR((*made)->plan({0, 0, 0}, {30, 40, 0}).length_m, 50.0, 0.5);

    // A block far away must not make the program treat a small house as large.
    SceneBuilder house;
    house.box({0, 0, -1}, {10, 10, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    house.box({9e5, 9e5, 0}, {9e5 + 1, 9e5 + 1, 1}, "moon", SolidRole::Solid, {}, FeatureKind::Wall);
    house.start({5, 5, 0}, 0.0);
    const auto small = Navigation::make(house.scene(), WalkerMeasures{});
    ASSERT_TRUE(small);
    EXPECT_TRUE((*small)->said().empty());
    EXPECT_LT((*small)->space().spans.size(), 50'000U);
}

TEST(Routes, in_an_endless_world_cover_the_surroundings_of_the_start_and_report_it) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "too large for a sanitizer";
    SceneBuilder endless;
    endless.box({-4e4, -4e4, -1}, {4e4, 4e4, 0}, "desert", SolidRole::Solid, {}, FeatureKind::Floor);
    endless.start({3e3, -2e3, 0}, 0.0);
    WalkerMeasures coarse;
    coarse.cell_m = 0.4;
    const auto made = Navigation::make(endless.scene(), coarse);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ((*made)->said().size(), 1U);
    EXPECT_TRUE((*made)->said()[0].starts_with("This world is so large that rooms and routes"));
    EXPECT_TRUE(validate((*made)->space()));
    const Route near = (*made)->plan({3e3, -2e3, 0}, {3e3 + 120.0, -2e3 - 160.0, 0});
    EXPECT_TRUE(near.reaches);
    EXPECT_NEAR(near.length_m, 200.0, 2.0);
    EXPECT_FALSE((*made)->plan({3e3, -2e3, 0}, {-3e4, 0, 0}).reaches);
}

TEST(Routes, can_be_cancelled_during_preparation) {
    const Scene scene = bundled("house.map");
    std::stop_source stop;
    stop.request_stop();
    const auto made = Navigation::make(scene, WalkerMeasures{}, stop.get_token());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().message, "The search for rooms was abandoned.");
}

}  // namespace route_test
}  // namespace handrail
