// Tests saved routes: they are read and written without loss or misreading, found again in an edited world, and planned
// through their stops. Trails are reduced to few corners.
#include "app/core/kept/saved_routes.h"

#include <gmock/gmock.h>

#include <random>

#include "app/core/world/walker.h"
#include "tests/support/box_scene.h"
#include "tests/support/every.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/temporary_folder.h"
#include "worlds/navigation/route_place.h"

namespace handrail {
namespace saved_routes_test {

namespace fs = std::filesystem;
using test::SceneBuilder;
using test::TemporaryFolder;
using testing::HasSubstr;

Stop stop(const std::string& name, const Vec3& place_m) {
    return {.name = name, .place_m = place_m, .thing = {}, .room = {}, .kept = {}};
}

SavedRoute tour() {
    SavedRoute way{"Tür zu 家, \"hinten\"",
                   {stop("Door", {1, 1, 0}), stop("", {1e-17, 2, 0}), stop("Table", {3, 1, 0.1 + 0.2})},
                   "5f3a90c1",
                   {}};
    way.stops[0].room = "Kitchen";
    way.stops[2].thing = "table";
    way.stops[2].thing_m = 0.4;
    return way;
}

void expect_same(const std::vector<SavedRoute>& a, const std::vector<SavedRoute>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t w = 0; w < a.size(); ++w) {
        EXPECT_EQ(a[w].name, b[w].name);
        EXPECT_EQ(a[w].world, b[w].world);
        EXPECT_EQ(a[w].kept, b[w].kept);
        ASSERT_EQ(a[w].stops.size(), b[w].stops.size());
        for (std::size_t i = 0; i < a[w].stops.size(); ++i) {
            const Stop &one = a[w].stops[i], &other = b[w].stops[i];
            EXPECT_EQ(one.name, other.name);
            EXPECT_EQ(one.place_m, other.place_m);
            EXPECT_EQ(one.thing, other.thing);
            EXPECT_EQ(one.thing_m, other.thing_m);
            EXPECT_EQ(one.room, other.room);
            EXPECT_EQ(one.kept, other.kept);
        }
    }
}

TEST(SavedRoutes, are_saved_to_the_last_bit_together_with_marks_and_unknown_content) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    folder.write("a.map.handrail.toml",
                 "[[mark]]\nname = \"Mark 1\"\nplace_m = [1.0, 2.0, 3.0]\n"
                 "[[way]]\nname = \"Old\"\nlater = { a = 1 }\n[[way.stop]]\nname = \"A\"\nplace_m = [0.0, 0.0, "
                 "0.0]\nsign = \"red\"\n"
                 "[[way.stop]]\nname = \"B\"\nplace_m = [1.0, 0.0, 0.0]\n");
    SideFile file = SideFile::of_world(world, {});
    std::vector<Error> faults;
    std::vector<SavedRoute> ways = read_saved_routes(file, faults);
    ASSERT_TRUE(faults.empty());
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(text_of(ways[0].stops[0].kept, "sign"), "red");
    ways.push_back(tour());
    write_saved_routes(file, ways);
    ASSERT_TRUE(file.save());
    const SideFile again = SideFile::of_world(world, {});
    expect_same(read_saved_routes(again, faults), ways);
    EXPECT_TRUE(faults.empty());
    EXPECT_EQ(again.entries("mark").size(), 1U);
    const std::string text = test::content_of(folder.path() / "a.map.handrail.toml");
    for (const char* part : {"later = {", "sign = ", "[[way.stop]]", "T\\u00FCr zu \\u5BB6"})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST(SavedRoutes, that_are_unreadable_are_reported_with_file_line_and_advice_and_stay_in_the_file) {
    const std::string two =
        "[[way.stop]]\nname = \"A\"\nplace_m = [0.0, 0.0, 0.0]\n[[way.stop]]\nname = \"B\"\nplace_m = [1.0, 0.0, "
        "0.0]\n";
    const std::string good = "[[way]]\nname = \"Good\"\n" + two;
    const struct {
        std::string entry;
        const char* fault;
    } bad[] = {
        {"[[way]]\n" + two,
         "this route needs a name that fits on one line. Give it one with the key \"name\", or delete the entry."},
        {"[[way]]\nname = \"Short\"\n[[way.stop]]\nname = \"A\"\nplace_m = [0.0, 0.0, 0.0]\n",
         "the route Short needs 2 to 200 stops"},
        {"[[way]]\nname = \"None\"\nstop = 3\n", "the route None needs 2 to 200 stops"},
        {"[[way]]\nname = \"Flat\"\n[[way.stop]]\nname = \"A\"\nplace_m = [0.0, 0.0]\n[[way.stop]]\nname = "
         "\"B\"\nplace_m = [1.0, 0.0, 0.0]\n",
         "the route Flat: stop 1 needs place_m with three decimal numbers"},
        {"[[way]]\nname = \"Nan\"\n[[way.stop]]\nname = \"A\"\nplace_m = [0.0, 0.0, 0.0]\n[[way.stop]]\nname = "
         "\"B\"\nplace_m = [nan, 0.0, 0.0]\n",
         "the route Nan: stop 2 needs place_m"},
        {"[[way]]\nname = \"Mute\"\n[[way.stop]]\nplace_m = [0.0, 0.0, 0.0]\n[[way.stop]]\nname = \"B\"\nplace_m = "
         "[1.0, 0.0, 0.0]\n",
         "the first and the last stop of the route Mute each need a name"},
        {"[[way]]\nname = \"Odd\"\n[[way.stop]]\nname = \"A\\nB\"\nplace_m = [0.0, 0.0, 0.0]\n[[way.stop]]\nname = "
         "\"B\"\nplace_m = [1.0, 0.0, 0.0]\n",
         "the route Odd: the name of stop 1 must be one line of text"},
    };
    for (const auto& one : bad) {
        const TemporaryFolder folder;
        const fs::path world = folder.write("a.map", "x");
        folder.write("a.map.handrail.toml", good + one.entry);
        SideFile file = SideFile::of_world(world, {});
        ASSERT_TRUE(file.news().empty()) << file.news().front();
        std::vector<Error> faults;
        const std::vector<SavedRoute> ways = read_saved_routes(file, faults);
        ASSERT_EQ(ways.size(), 1U) << one.fault;
        ASSERT_EQ(faults.size(), 1U) << one.fault;
        EXPECT_THAT(faults[0].sentence(), testing::StartsWith("a.map.handrail.toml, line 9: ")) << one.fault;
        EXPECT_THAT(faults[0].sentence(), HasSubstr(one.fault));
        const std::vector<SideEntry> before = file.entries("way");
        write_saved_routes(file, ways);
        ASSERT_TRUE(file.save());
        const std::vector<SideEntry> after = SideFile::of_world(world, {}).entries("way");
        if (one.entry.find("nan") == std::string::npos) {  // NaN is not equal to anything
            EXPECT_EQ(after, before);
        }
        EXPECT_EQ(after.size(), 2U);
    }
}

TEST(SavedRoutes, survive_a_file_that_is_cut_or_changed_at_every_byte) {
    const TemporaryFolder folder;
    const fs::path world = folder.write("a.map", "x");
    SideFile file = SideFile::of_world(world, {});
    write_saved_routes(file, {tour(), tour()});
    ASSERT_TRUE(file.save());
    const std::string whole = test::content_of(folder.path() / "a.map.handrail.toml");
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    for (std::size_t i = 0; i < 3 * whole.size(); i += test::every(4, 16)) {
        const std::size_t at = i % whole.size();
        std::string broken = whole;
        if (i < whole.size()) broken.resize(at);
        else if (i < 2 * whole.size()) broken[at] = static_cast<char>(random());
        else broken.insert(at, whole.substr(random() % whole.size(), random() % 40));
        folder.write("a.map.handrail.toml", broken);
        SideFile read = SideFile::of_world(world, {});
        std::vector<Error> faults;
        const std::vector<SavedRoute> ways = read_saved_routes(read, faults);
        EXPECT_EQ(ways.size() + faults.size(), read.entries("way").size());
        for (const Error& fault : faults) EXPECT_FALSE(fault.message.empty());
        for (const SavedRoute& way : ways) {
            EXPECT_GE(way.stops.size(), 2U);
            EXPECT_FALSE(way.stops.front().name.empty() || way.stops.back().name.empty());
            for (const Stop& one : way.stops) EXPECT_TRUE(is_finite(one.place_m));
        }
        // Only every seventh file is written, because writing to the disk is slow.
        if ((ways.empty() && faults.empty()) || i % 7 != 0) continue;
        // What was read correctly is the same after it was written and read again.
        const std::vector<SideEntry> before = read.entries("way");
        write_saved_routes(read, ways);
        ASSERT_TRUE(read.save());
        const SideFile again = SideFile::of_world(world, {});
        ASSERT_TRUE(again.news().empty()) << again.news().front() << "\n" << broken;
        expect_same(read_saved_routes(again, faults), ways);
        EXPECT_EQ(again.entries("way").size(), before.size());
    }
}

// ---- in a world ----

struct Flat {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<Navigation> navigation;
    RoomGraph graph;
};

// Makes a floor of 12 by 5 metres with walls around it. A wall across the middle has a gap of a metre, unless `shut` is
// true. The table is at the given place, or there is none.
Flat flat(const std::optional<Vec3>& table, bool shut = false, const std::optional<Vec3>& block = {}) {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {12, 5, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    for (const auto& [low, high] :
         {std::pair{Vec3(-0.2, -0.2, 0), Vec3(12.2, 0, 2.6)}, std::pair{Vec3(-0.2, 5, 0), Vec3(12.2, 5.2, 2.6)},
          std::pair{Vec3(-0.2, 0, 0), Vec3(0, 5, 2.6)}, std::pair{Vec3(12, 0, 0), Vec3(12.2, 5, 2.6)},
          std::pair{Vec3(5.9, 0, 0), Vec3(6.1, 2, 2.6)}, std::pair{Vec3(5.9, shut ? 2.0 : 3.0, 0), Vec3(6.1, 5, 2.6)}})
        b.box(low, high, "wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    if (table) b.box(*table, *table + Vec3(1.0, 0.6, 0.7), "table", SolidRole::Solid, "wood", FeatureKind::Object);
    if (block)
        b.box(*block - Vec3(0.5, 0.5, 0.0), *block + Vec3(0.5, 0.5, 2.6), "pillar", SolidRole::Solid, "brick",
              FeatureKind::Wall);
    b.start({1, 1, 0}, 0.0);
    b.start({11, 1, 0}, 0.0);
    Flat made;
    made.scene = b.share();
    const WalkerSize size = walker_size(*made.scene, 0.25);
    auto navigation =
        Navigation::make(*made.scene, walker_measures(*made.scene, size.radius_m, size.height_m, size.step_up_m));
    EXPECT_TRUE(navigation);
    made.navigation = *navigation;
    made.graph = make_rooms(*made.scene, made.navigation->space());
    give_names(made.graph, made.navigation->space(), {{{1, 1, 0}, "Shop"}});
    return made;
}

SavedRoute to_the_table() {
    SavedRoute way{
        "There and in",
        {stop("Shop", {1, 1, 0}), stop("Table", {2, 3.5, 0}), stop("", {8.5, 4, 0}), stop("Far end", {11, 2.5, 0})},
        "before",
        {}};
    way.stops[0].room = "Shop";
    way.stops[1].thing = "table";
    way.stops[1].thing_m = 0.4;
    return way;
}

std::string unfit(const Flat& flat, const SavedRoute& way = to_the_table()) {
    const FoundRoute found = look_up(way, *flat.scene, SideFile(), *flat.navigation, flat.graph);
    return fault_words(found, [](double way_m) { return fmt::format("{:.1f} metres", way_m); });
}

TEST(SavedRoutes, are_checked_against_the_world_and_misfits_are_reported_by_name) {
    const Vec3 table(2.4, 3.2, 0);
    EXPECT_EQ(unfit(flat(table)), "");
    EXPECT_EQ(unfit(flat(table - Vec3(0.3, 0, 0))), "");  // The table has moved by less than half a metre.
    EXPECT_EQ(unfit(flat({})), "Table no longer exists");
    EXPECT_EQ(unfit(flat(table, true)), "no walking route from Table to Far end");
    EXPECT_EQ(unfit(flat(table, false, Vec3(10.9, 2.5, 0))), "there is no place to stand at Far end");
    EXPECT_EQ(unfit(flat(table, false, Vec3(7.5, 2.5, 0))), "");  // The walker can go round the block.
    // The table is found at another place, and the route leads there.
    const Flat moved = flat(Vec3(9.5, 0.3, 0));
    const FoundRoute found = look_up(to_the_table(), *moved.scene, SideFile(), *moved.navigation, moved.graph);
    ASSERT_EQ(found.faults.size(), 1U);
    EXPECT_EQ(found.faults[0].kind, StopFault::Kind::ThingMoved);
    EXPECT_NEAR(found.faults[0].moved_m, std::hypot(9.5 - 2.0, 3.5 - 0.9),
                1e-9);  // the distance from (2, 3.5) to the corner of the table at (9.5, 0.9)
    EXPECT_LT(glm::length(found.stops[1].place_m - Vec3(9.5, 0.9, 0)), 0.6);
    // If a corner of a trail is inside a pillar, the fault names the stop after that corner.
    EXPECT_THAT(unfit(flat(table, false, Vec3(8.5, 4.0, 0))),
                HasSubstr("there is no place to stand on the route to Far end"));
}

TEST(SavedRoutes, know_rooms_by_all_their_names) {
    Flat one = flat(Vec3(2.4, 3.2, 0));
    SavedRoute way = to_the_table();
    way.stops[0].room = "Larder";
    EXPECT_EQ(unfit(one, way), "Larder no longer exists");
    one.graph.rooms[room_at(one.graph, one.navigation->space(), {1, 1, 0})].map_name = "larder";
    EXPECT_EQ(unfit(one, way), "");
    EXPECT_EQ(unfit(one), "");
    // Another room, on the other side, now has the name, so the stop is found there.
    one = flat(Vec3(2.4, 3.2, 0));
    for (Room& room : one.graph.rooms) room.name = "other";
    give_names(one.graph, one.navigation->space(), {{{11, 2.5, 0}, "Shop"}});
    const FoundRoute found = look_up(to_the_table(), *one.scene, SideFile(), *one.navigation, one.graph);
    ASSERT_EQ(found.faults.size(), 1U);
    EXPECT_EQ(found.faults[0].kind, StopFault::Kind::RoomMoved);
    EXPECT_GT(found.stops[0].place_m.x, 6.0);
}

TEST(SavedRoutes, through_several_places_consist_of_consecutive_legs) {
    const Flat flat_one = flat(Vec3(2.4, 3.2, 0));
    Navigation& navigation = *flat_one.navigation;
    std::vector<Vec3> places{{1, 4, 0}, {11, 4, 0}, {11, 0.5, 0}, {1, 0.5, 0}};
    std::mt19937 random(test::seed_of_run());
    for (int round = 0; round < 6; ++round) {
        std::vector<double> at_m;
        const Route all = plan_through(navigation, {3, 1, 0}, places, &at_m);
        ASSERT_TRUE(all.reaches);
        ASSERT_EQ(at_m.size(), places.size());
        double sum = 0.0;
        Vec3 from(3, 1, 0);
        for (std::size_t i = 0; i < places.size(); ++i) {
            sum += navigation.plan(from, places[i]).length_m;
            EXPECT_NEAR(at_m[i], sum, 1e-9);
            EXPECT_LT(glm::length(place_along(all.points_m, at_m[i]) - places[i]), 0.1);
            from = places[i];
        }
        EXPECT_NEAR(all.length_m, sum, 1e-9);
        EXPECT_NEAR(length_of(all.points_m), sum, 0.05 * places.size());
        for (std::size_t i = 1; i < all.passages.size(); ++i)
            EXPECT_LE(all.passages[i - 1].at_m, all.passages[i].at_m + 1e-9);
        std::shuffle(places.begin(), places.end(), random);
    }
    const Flat cut = flat(Vec3(2.4, 3.2, 0), true);
    const Route stuck = plan_through(*cut.navigation, {3, 1, 0}, std::vector<Vec3>{{1, 4, 0}, {11, 4, 0}, {1, 0.5, 0}});
    EXPECT_FALSE(stuck.reaches);
    EXPECT_LT(stuck.points_m.back().x, 6.0);
    EXPECT_TRUE(plan_through(*cut.navigation, {3, 1, 0}, {}).points_m.empty());
    EXPECT_TRUE(plan_through(*cut.navigation, {100, 100, 0}, std::vector<Vec3>{{1, 4, 0}}).points_m.empty());
}

// ---- trails ----

// Compares every point of the trail with every line between two corners. Returns the largest distance.
double farthest_off_m(const std::vector<Vec3>& trail, const std::vector<Vec3>& corners) {
    double worst = 0.0;
    for (const Vec3& p : trail) {
        double best = 1e300;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            for (int k = 0; k <= 1000; ++k)
                best = std::min(best, glm::length(p - (corners[i] + (corners[i + 1] - corners[i]) * (k / 1000.0))));
        if (corners.size() == 1) best = glm::length(p - corners[0]);
        worst = std::max(worst, best);
    }
    return worst;
}

TEST(Trails, keep_few_corners_and_stay_within_the_given_tolerance) {
    std::mt19937 random(test::seed_of_run());
    RecordProperty("seed", static_cast<int>(test::seed_of_run()));
    for (int round = 0; round < 30; ++round) {
        const Vec3 far_off = round % 3 == 0 ? Vec3(1e5, -1e5, 50.0) : Vec3(0.0);
        std::vector<Vec3> trail{far_off};
        double heading = 0.0;
        for (std::uint32_t n = random() % 120; n > 0; --n) {
            if (random() % 5 == 0) heading = static_cast<double>(random() % 8) * kPi / 4.0;
            trail.push_back(random() % 20 == 0 ? trail.back() : trail.back() + forward_of_heading(heading) * 0.25);
        }
        for (const bool backwards : {false, true}) {
            std::vector<Vec3> one = trail;
            if (backwards) std::reverse(one.begin(), one.end());
            const std::vector<Vec3> corners = corners_of(one, 0.4);
            ASSERT_FALSE(corners.empty());
            EXPECT_EQ(corners.front(), one.front());
            EXPECT_EQ(corners.back(), one.back());
            EXPECT_LE(farthest_off_m(one, corners), 0.4 + 0.01);
            EXPECT_LE(corners.size(), one.size());
            // The corners are in the same order as the trail.
            std::size_t at = 0;
            for (const Vec3& corner : corners) {
                while (at < one.size() && one[at] != corner) ++at;
                EXPECT_LT(at, one.size());
            }
        }
    }
    EXPECT_TRUE(corners_of({}, 0.4).empty());
    EXPECT_EQ(corners_of(std::vector<Vec3>{{1, 1, 1}}, 0.4).size(), 1U);
    std::vector<Vec3> straight;  // 20 metres with a bend in the middle; only the two ends and the bend remain
    for (int i = 0; i <= 40; ++i) straight.push_back({0.25 * i, 0, 0});
    for (int i = 1; i <= 40; ++i) straight.push_back({10, 0.25 * i, 0});
    EXPECT_EQ(corners_of(straight, 0.4), (std::vector<Vec3>{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}));
}

TEST(Trails, since_a_place_start_at_the_latest_nearest_approach_to_it) {
    std::vector<Vec3> trail;
    for (int i = 0; i <= 40; ++i) trail.push_back({0.25 * i, 0, 0});  // a trail 10 metres to the east and back to x = 6
    for (int i = 1; i <= 16; ++i) trail.push_back({10 - 0.25 * i, 0, 0});
    EXPECT_EQ(trail_since(trail, {2, 0.5, 0}, 1.0).front(), Vec3(2, 0, 0));
    EXPECT_EQ(trail_since(trail, {7, 0, 0}, 1.0).size(), 5U);  // the part from x = 7 on the way back to x = 6
    EXPECT_TRUE(trail_since(trail, {2, 5, 0}, 1.0).empty());
    EXPECT_TRUE(trail_since({}, {2, 5, 0}, 1.0).empty());
    EXPECT_EQ(length_of(trail_since(trail, {0, 0, 0}, 1.0)), 14.0);
    EXPECT_EQ(length_of({}), 0.0);
}

}  // namespace saved_routes_test
}  // namespace handrail
