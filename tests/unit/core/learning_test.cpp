#include "app/core/learning/learning.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "app/core/scenario/session_log.h"
#include "app/core/session/session.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/unit/core/app_session.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace learning_test {

using test::SceneBuilder;

// Makes a world with its rooms, and a place to learn from the room around a point.
struct Ground {
    Ground(const SceneBuilder& b, const Vec3& feet_m) : scene(b.share()), world(scene) {
        const WalkerSize size = walker_size(*scene, 0.25);
        auto made = make_walk_space(*scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
        EXPECT_TRUE(made) << made.error().sentence();
        space = std::move(*made);
        graph = make_rooms(*scene, space);
        room = room_at(graph, space, feet_m);
        EXPECT_NE(room, kNothing);
        place = place_of_room(world, space, graph, room);
    }
    Learnt learnt(const LearningNotes& notes = {}) const {
        Learnt known(place);
        known.lay(notes);
        return known;
    }
    Progress progress(const LearningNotes& notes = {}) const { return progress_of(learnt(notes)); }
    std::shared_ptr<const Scene> scene;
    WalkerWorld world;
    WalkSpace space;
    RoomGraph graph;
    std::uint32_t room = kNothing;
    Place place;
};

// Makes a room whose south-west corner is at `at`, with a door of a metre in the south wall. If `block` is true, a
// free-standing block is in the room.
struct DoorRoom : Ground {
    static SceneBuilder built(const Vec3& at, double wide, double deep, bool block) {
        SceneBuilder b;
        b.box(at + Vec3(-1, -1, -0.2), at + Vec3(wide + 1, deep + 1, 0), "floor", SolidRole::Solid, "carpet",
              FeatureKind::Floor);
        b.box(at + Vec3(-0.2, deep, 0), at + Vec3(wide + 0.2, deep + 0.2, 2.6), "north wall", SolidRole::Solid,
              "plaster", FeatureKind::Wall);
        b.box(at + Vec3(-0.2, -0.2, 0), at + Vec3(1, 0, 2.6), "south wall", SolidRole::Solid, "plaster",
              FeatureKind::Wall);
        b.box(at + Vec3(2, -0.2, 0), at + Vec3(wide + 0.2, 0, 2.6), "south wall", SolidRole::Solid, "plaster",
              FeatureKind::Wall);
        b.box(at + Vec3(1, -0.15, 0), at + Vec3(2, 0, 2.6), "Door", SolidRole::Solid, "wood", FeatureKind::Door);
        b.box(at + Vec3(wide, 0, 0), at + Vec3(wide + 0.2, deep, 2.6), "east wall", SolidRole::Solid, "wood",
              FeatureKind::Wall);
        b.box(at + Vec3(-0.2, 0, 0), at + Vec3(0, deep, 2.6), "west wall", SolidRole::Solid, "brick",
              FeatureKind::Wall);
        if (block)
            b.box(at + Vec3(2, 2, 0), at + Vec3(2.8, 2.8, 0.9), "Table", SolidRole::Solid, "wood", FeatureKind::Object);
        b.start(at + Vec3(1.5, 0.5, 0), 0.0);
        return b;
    }
    DoorRoom(const Vec3& at, double wide, double deep, bool block = false)
        : Ground(built(at, wide, deep, block), at + Vec3(1.5, 0.5, 0)), at_m(at), wide_m(wide), deep_m(deep) {}
    Vec3 at_m;
    double wide_m, deep_m;
};

TEST(Learning, perimeter_and_floor_match_the_room_and_free_standing_things_are_not_walls) {
    std::mt19937 random(test::seed_of_run());
    for (int run = 0; run < 20; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const DoorRoom room(run % 3 == 0 ? Vec3(0.0) : Vec3(between(-900, 900), between(-900, 900), between(-9, 9)),
                            between(4, 9), between(4, 9), run % 2 == 1);
        const Progress none = room.progress();
        const double perimeter = 2.0 * (room.wide_m + room.deep_m), table = run % 2 == 1 ? 0.64 : 0.0;
        EXPECT_NEAR(none.perimeter_m, perimeter, 0.02 * perimeter);
        EXPECT_NEAR(none.floor_m2, room.wide_m * room.deep_m - table, 0.02 * room.wide_m * room.deep_m);
        EXPECT_EQ(none.exits, 1);
        EXPECT_TRUE(none.doors_only);
        EXPECT_EQ(none.exits_found, 0);
        EXPECT_EQ(none.touched_m, 0.0);
    }
}

TEST(Learning, reports_the_touched_share_of_the_walls_within_two_percent) {
    std::mt19937 random(test::seed_of_run());
    for (int run = 0; run < 40; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const DoorRoom room(Vec3(between(-900, 900), between(-900, 900), 0.0), between(4, 9), between(4, 9));
        LearningNotes notes;
        double truth_m = 0.0;
        const double reach = between(0.05, 0.3);
        const struct {
            Vec3 from, along, normal;
            double length;
        } walls[] = {{{0, room.deep_m, 0}, {1, 0, 0}, {0, -1, 0}, room.wide_m},
                     {{room.wide_m, 0, 0}, {0, 1, 0}, {-1, 0, 0}, room.deep_m},
                     {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, room.deep_m}};
        for (const auto& wall : walls) {
            const double begin = between(0, 0.6 * wall.length), end = between(begin, wall.length);
            for (double s = begin; s <= end; s += 0.05)
                notes.touched(room.at_m + wall.from + wall.along * s + Vec3(0, 0, 1), wall.normal, reach);
            truth_m += std::min(wall.length, begin + std::floor((end - begin) / 0.05) * 0.05 + reach) -
                       std::max(0.0, begin - reach);
        }
        const double perimeter = 2.0 * (room.wide_m + room.deep_m);
        EXPECT_NEAR(room.progress(notes).perimeter_share(), truth_m / perimeter, 0.02) << run;
    }
}

TEST(Learning, reports_the_walked_share_of_the_floor_within_two_percent) {
    std::mt19937 random(test::seed_of_run());
    for (int run = 0; run < 10; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const DoorRoom room(Vec3(between(-900, 900), between(-900, 900), 0.0), between(4, 8), between(4, 8));
        LearningNotes notes;
        std::vector<Vec3> way;
        Vec3 at(1.5, 0.5, 0.0);
        for (int leg = 0; leg < 4; ++leg) {
            const Vec3 to(between(0.3, room.wide_m - 0.3), between(0.3, room.deep_m - 0.3), 0.0);
            const int pieces = static_cast<int>(glm::length(to - at) / 0.05) + 1;
            for (int i = 0; i <= pieces; ++i) {
                way.push_back(room.at_m + at + (to - at) * (static_cast<double>(i) / pieces));
                notes.walked(way.back());
            }
            at = to;
        }
        // Compute the expected result from points three centimetres apart.
        int all = 0, walked = 0;
        for (double x = 0.015; x < room.wide_m; x += 0.03)
            for (double y = 0.015; y < room.deep_m; y += 0.03) {
                const Vec3 p = room.at_m + Vec3(x, y, 0.0);
                ++all;
                walked += std::any_of(way.begin(), way.end(),
                                      [&](const Vec3& w) { return glm::length(w - p) <= kFloorReach_m; });
            }
        EXPECT_NEAR(room.progress(notes).floor_share(), static_cast<double>(walked) / all, 0.02) << run;
    }
}

// Returns the nearest unknown stretch of wall, found by comparing every pair of samples.
std::optional<Vec3> nearest_unknown_wall(const Learnt& learnt, const Vec3& feet_m) {
    constexpr double kUnknown_m = 0.45;
    const std::vector<WallSample>& walls = learnt.place().walls;
    std::optional<Vec3> nearest;
    double nearest_m = 1e9;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        double beside_m = 0.0;
        for (std::size_t k = 0; k < walls.size() && !learnt.knows_wall(i); ++k)
            if (!learnt.knows_wall(k) && walls[k].feature == walls[i].feature &&
                glm::length(walls[k].point_m - walls[i].point_m) < kUnknown_m)
                beside_m += walls[k].length_m;
        const double way_m = std::hypot(walls[i].point_m.x - feet_m.x, walls[i].point_m.y - feet_m.y);
        if (beside_m < kUnknown_m || way_m >= nearest_m) continue;
        nearest_m = way_m;
        nearest = walls[i].point_m;
    }
    return nearest;
}

TEST(Learning, uses_coarser_cells_in_a_huge_place_with_the_same_measurements) {
    const double wide = 60.0, deep = 40.0;
    const DoorRoom hall(Vec3(0.0), wide, deep, false);
    EXPECT_LE(hall.place.free.size(), 400'000U) << "memory and time are those of a large hall";
    EXPECT_GT(hall.place.cell_m, 0.05);
    EXPECT_NEAR(hall.place.area_m2(), wide * deep, 0.01 * wide * deep);
    EXPECT_NEAR(hall.progress().perimeter_m, 2.0 * (wide + deep), 0.02 * 2.0 * (wide + deep));
    EXPECT_EQ(hall.progress().exits, 1);
    LearningNotes notes;
    for (double x = 0.25; x < wide; x += 0.5)
        for (double y = 0.1; y < deep; y += 0.1) notes.walked({x, y, 0.0});
    for (double s = 0.0; s <= wide; s += 0.05) notes.touched({s, 0, 1}, {0, 1, 0}, 0.1);
    for (const Vec3& feet : {Vec3(1.5, 0.5, 0.0), Vec3(55.0, 3.0, 0.0), Vec3(30.0, 30.0, 0.0)}) {
        const Learnt learnt = hall.learnt(notes);
        const auto left = nearest_unexplored(learnt, feet);
        ASSERT_TRUE(left);
        EXPECT_TRUE(left->wall);
        EXPECT_EQ(left->point_m, nearest_unknown_wall(learnt, feet));
    }
}

TEST(Learning, finds_the_nearest_unexplored_part_first_until_nothing_is_left) {
    const DoorRoom room(Vec3(0.0), 6.0, 4.0);
    LearningNotes notes;
    const Vec3 feet(1.5, 0.5, 0.0);
    auto left = nearest_unexplored(room.learnt(notes), feet);
    ASSERT_TRUE(left);
    for (double x = 0.25; x < 6.0; x += 0.5)
        for (double y = 0.1; y < 4.0; y += 0.1) notes.walked({x, y, 0.0});
    left = nearest_unexplored(room.learnt(notes), feet);
    ASSERT_TRUE(left);
    EXPECT_TRUE(left->wall) << "the floor is done";
    for (double s = 0.0; s <= 6.0; s += 0.05)
        notes.touched({s, 0, 1}, {0, 1, 0}, 0.1), notes.touched({s, 4, 1}, {0, -1, 0}, 0.1);
    for (double s = 0.0; s <= 4.0; s += 0.05) notes.touched({0, s, 1}, {1, 0, 0}, 0.1);
    left = nearest_unexplored(room.learnt(notes), feet);
    ASSERT_TRUE(left);
    EXPECT_EQ(room.scene->features[left->feature.value].name, "east wall");
    for (double s = 0.0; s <= 4.0; s += 0.05) notes.touched({6, s, 1}, {-1, 0, 0}, 0.1);
    EXPECT_FALSE(nearest_unexplored(room.learnt(notes), feet));
    const Progress all = room.progress(notes);
    EXPECT_GT(all.perimeter_share(), 0.99);
    EXPECT_GT(all.floor_share(), 0.99);
    EXPECT_EQ(all.exits_found, 1);
    for (const Lane& lane : lanes_of(room.learnt(notes))) EXPECT_TRUE(lane.done() || !lane.north);
}

TEST(Learning, lanes_are_a_metre_apart_in_both_directions) {
    const DoorRoom room(Vec3(0.0), 6.0, 4.0);
    const std::vector<Lane> lanes = lanes_of(room.learnt());
    EXPECT_EQ(std::count_if(lanes.begin(), lanes.end(), [](const Lane& lane) { return lane.north; }), 6);
    EXPECT_EQ(lanes.size(), 10U);
    EXPECT_NEAR(lanes[1].at_m - lanes[0].at_m, 1.0, 0.11);
    LearningNotes notes;
    for (double y = 0.3; y < 3.8; y += 0.05) notes.walked({lanes[2].at_m, y, 0.0});
    const std::vector<Lane> after = lanes_of(room.learnt(notes));
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].done(), i == 2) << i;
}

// The outline of a room. The corners are in an order that has the room on the left, and all of them are right angles.
// There may be a free-standing pillar.
struct Outline {
    const char* name = "";
    std::vector<Vec3> corners;
    std::optional<Aabb> pillar;
    Vec3 start{1.5, 0.5, 0.0};
    double lap_s = 0.0;  // more than enough time for one lap

    Vec3 corner(std::size_t i) const { return corners[i % corners.size()]; }
    bool inside(const Vec3& p) const {
        bool in = false;  // changes its value at each side of the outline to the east
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 a = corner(i), b = corner(i + 1);
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x) in = !in;
        }
        return in && !(pillar && p.x > pillar->min_m.x && p.x < pillar->max_m.x && p.y > pillar->min_m.y &&
                       p.y < pillar->max_m.y);
    }
    double perimeter_m() const {
        double sum_m = 0.0;
        for (std::size_t i = 0; i < corners.size(); ++i) sum_m += glm::length(corner(i + 1) - corner(i));
        return sum_m;
    }
    // Calls `look` with points of the walls, a centimetre apart, and with the direction into the room.
    template <class Look>
    void along_walls(Look look) const {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 a = corner(i), side = corner(i + 1) - a, along = side / glm::length(side);
            for (double s = 0.005; s < glm::length(side); s += 0.01) look(a + along * s, Vec3(-along.y, along.x, 0.0));
        }
    }
    // Calls `look` with points of the floor three centimetres apart.
    template <class Look>
    void over_floor(Look look) const {
        for (double x = 0.015; x < 12.0; x += 0.03)
            for (double y = 0.015; y < 12.0; y += 0.03)
                if (inside({x, y, 0.0})) look(Vec3(x, y, 0.0));
    }
    SceneBuilder build() const {
        SceneBuilder b;
        b.box({-1, -1, -0.2}, {13, 13, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 from = corner(i), to = corner(i + 1), along = (to - from) / glm::length(to - from),
                       out(along.y, -along.x, 0.0);
            // A wall continues round an outer corner. At an inner corner it ends, and the next wall begins slightly
            // behind its face.
            const Vec3 a = from - along * 0.2, c = to + along * 0.2;
            const auto turn = [](const Vec3& one, const Vec3& other) { return one.x * other.y - one.y * other.x; };
            const Vec3 before = from - corner(i + corners.size() - 1), after = corner(i + 2) - to;
            const Vec3 begin = turn(before, along) > 0.0 ? a : from + along * 0.02,
                       end = turn(along, after) > 0.0 ? c : to;
            b.box(glm::min(glm::min(begin, end), glm::min(begin + out * 0.2, end + out * 0.2)),
                  glm::max(glm::max(begin, end), glm::max(begin + out * 0.2, end + out * 0.2)) + Vec3(0, 0, 2.6),
                  "wall " + std::to_string(i + 1), SolidRole::Solid, "plaster", FeatureKind::Wall);
        }
        if (pillar) b.box(pillar->min_m, pillar->max_m, "Pillar", SolidRole::Solid, "stone", FeatureKind::Object);
        b.start(start, 0.0);
        return b;
    }
};
const Outline kOblong{"oblong", {{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {0, 4, 0}}, {}, {1.5, 0.5, 0}, 26.0};
const Outline kAngle{
    "angle", {{0, 0, 0}, {7, 0, 0}, {7, 3.2, 0}, {3.3, 3.2, 0}, {3.3, 7.4, 0}, {0, 7.4, 0}}, {}, {1.5, 0.5, 0}, 36.0};
const Outline kPillared{"pillared",
                        {{0, 0, 0}, {6, 0, 0}, {6, 5, 0}, {0, 5, 0}},
                        Aabb{{2.6, 2.1, 0}, {3.4, 2.9, 2.6}},
                        {1.5, 0.5, 0},
                        28.0};
// The pillar touches the east wall, so it is part of the room's boundary.
const Outline kRecessed{
    "recessed",
    {{0, 0, 0}, {6, 0, 0}, {6, 1.8, 0}, {5.2, 1.8, 0}, {5.2, 2.9, 0}, {6, 2.9, 0}, {6, 5, 0}, {0, 5, 0}},
    {},
    {1.5, 0.5, 0},
    32.0};

class Outlines : public testing::TestWithParam<Outline> {};
INSTANTIATE_TEST_SUITE_P(Learning, Outlines, testing::Values(kOblong, kAngle, kPillared, kRecessed),
                         [](const auto& test) { return test.param.name; });

TEST_P(Outlines, have_the_true_length_and_area_within_two_percent) {
    const Outline& outline = GetParam();
    const Ground room(outline.build(), outline.start);
    const Progress none = room.progress();
    std::size_t points = 0;
    outline.over_floor([&](const Vec3&) { ++points; });
    EXPECT_NEAR(none.perimeter_m / outline.perimeter_m(), 1.0, 0.02);
    EXPECT_NEAR(none.floor_m2 / (static_cast<double>(points) * 0.03 * 0.03), 1.0, 0.02);
    EXPECT_EQ(none.exits, 0);
    EXPECT_EQ(std::count_if(none.walls.begin(), none.walls.end(),
                            [](const WallProgress& wall) { return wall.length_m > 0.0; }),
              static_cast<std::ptrdiff_t>(outline.corners.size()));
    for (const WallProgress& wall : none.walls) {
        const std::size_t i = std::stoul(room.scene->features[wall.feature.value].name.substr(5)) - 1;
        EXPECT_NEAR(wall.length_m, glm::length(outline.corner(i + 1) - outline.corner(i)), 0.06) << i;
    }
}

// A person who walks a lap by keys, with the positions of the walker's feet.
struct Lap : test::AppSession {
    explicit Lap(std::shared_ptr<const Scene> scene) {
        app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0);
        run(0.1);
    }
    void walk(double seconds) {
        for (const double until = now + seconds; now < until - 1e-9;) {
            run(1.0 / 60.0);
            feet.push_back(app.feet_m());
        }
    }
    void walk(Command command, double seconds) {
        app.apply(CommandDown{command}, now);
        walk(seconds);
        app.apply(CommandUp{command}, now);
    }
    bool reported(const char* words) const {
        return std::any_of(said.begin(), said.end(),
                           [&](const std::string& line) { return words_in_order(words, line); });
    }
    std::vector<Vec3> feet;
};

// For a lap by keys, what the session reports must match the actual path on the floor.
TEST_P(Outlines, of_a_lap_by_keys_are_reported_within_two_percent_at_every_part) {
    const Outline& outline = GetParam();
    const std::shared_ptr<const Scene> scene = outline.build().share();
    for (const double share : {0.2, 0.35, 0.55, 1.0}) {
        if (share < 1.0 && test::kSanitizerScale < 1.0) continue;
        Lap lap(scene);
        lap.request(Command::LearnPlace);
        lap.walk(Command::TrailLeft, share * outline.lap_s);
        lap.walk(0.5);
        const std::string report = lap.request(Command::ProgressReport);
        int all = 0, touched = 0, floor = 0, walked = 0;
        outline.along_walls([&](const Vec3& wall, const Vec3& normal) {
            ++all;
            touched += std::any_of(lap.feet.begin(), lap.feet.end(), [&](const Vec3& f) {
                const Vec3 way = f - wall;
                const double off = glm::dot(way, normal);
                return off > 0.0 && off < 0.25 + Trail::kGap_m + 0.02 &&
                       std::abs(-way.x * normal.y + way.y * normal.x) <= 0.25;
            });
        });
        outline.over_floor([&](const Vec3& place) {
            ++floor;
            walked += std::any_of(lap.feet.begin(), lap.feet.end(),
                                  [&](const Vec3& f) { return glm::length(f - place) <= kFloorReach_m; });
        });
        ASSERT_EQ(report.rfind("Walls ", 0), 0U) << report;
        EXPECT_NEAR(std::stod(report.substr(6)), 100.0 * touched / all, 2.0) << report << " of " << share;
        EXPECT_NEAR(std::stod(report.substr(report.find("floor ") + 6)), 100.0 * walked / floor, 2.0)
            << report << " of " << share;
        if (share < 1.0) continue;
        EXPECT_GT(100.0 * touched / all, 95.0);
        EXPECT_TRUE(lap.reported("Wall 1 done"));
        EXPECT_TRUE(lap.reported("All walls done"));
    }
}

// A pocket that is too small for any walker has a wall. Without that wall, 95 percent of the walls have been touched.
// The session used to report that as all walls.
TEST(Learning, untouched_walls_are_not_reported_as_done) {
    SceneBuilder b;
    const auto wall = [&](const Vec3& from, const Vec3& to, const char* name) {
        b.box(from, to, name, SolidRole::Solid, "plaster", FeatureKind::Wall);
    };
    b.box({-1, -1, -0.2}, {8, 6, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    wall({-0.2, 4, 0}, {6.8, 4.2, 2.6}, "north wall");
    wall({-0.2, -0.2, 0}, {6.8, 0, 2.6}, "south wall");
    wall({-0.2, 0, 0}, {0, 4, 2.6}, "west wall");
    wall({6, 0, 0}, {6.3, 1.9, 2.6}, "east wall");
    wall({6, 2.2, 0}, {6.3, 4, 2.6}, "east wall");
    wall({6.3, 1.5, 0}, {6.8, 2.6, 2.6}, "back of the pocket");
    b.start({3, 1, 0}, 0.0);
    Lap lap(b.share());
    lap.request(Command::LearnPlace);
    lap.walk(Command::TrailLeft, 60.0);
    lap.walk(0.5);
    EXPECT_TRUE(lap.reported("All walls done except")) << testing::PrintToString(lap.said);
    for (const std::string& line : lap.said) EXPECT_EQ(line.find("All walls done,"), std::string::npos) << line;
}

TEST(Learning, a_lap_past_a_door_finds_the_door) {
    const DoorRoom room(Vec3(0.0), 6.0, 4.0);
    Lap lap(room.scene);
    lap.request(Command::LearnPlace);
    lap.walk(Command::Forward, 1.0);
    EXPECT_NE(lap.request(Command::ProgressReport).find("0 of 1 door"), std::string::npos) << lap.said.back();
    lap.walk(Command::TrailLeft, 26.0);
    lap.run(1.0);
    EXPECT_NE(lap.request(Command::ProgressReport).find("1 of 1 door"), std::string::npos) << lap.said.back();
    EXPECT_TRUE(lap.reported("North wall done"));
}

// Makes two rooms with an open gap of a metre between them.
SceneBuilder two_rooms() {
    SceneBuilder b;
    b.box({-1, -1, -0.2}, {12, 6, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-0.2, -0.2, 0}, {10.2, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({-0.2, 4, 0}, {10.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 4, 2.6}, "west wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({10, 0, 0}, {10.2, 4, 2.6}, "east wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({5, 0, 0}, {5.2, 1.5, 2.6}, "middle wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({5, 2.5, 0}, {5.2, 4, 2.6}, "middle wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.scene().room_names = {RoomName{Vec3(2, 2, 0), "Study"}, RoomName{Vec3(8, 2, 0), "Kitchen"}};
    b.start({2, 2, 0}, kPi / 2.0);
    return b;
}

TEST(Learning, uses_the_room_of_the_graph_as_the_place_and_its_portals_as_exits) {
    const SceneBuilder b = two_rooms();
    const Ground study(b, {2, 2, 0}), kitchen(b, {8, 2, 0});
    ASSERT_NE(study.room, kitchen.room);
    EXPECT_EQ(study.graph.rooms[study.room].name, "Study");
    for (const Ground* one : {&study, &kitchen}) {
        const Progress none = one->progress();
        // Each room has three walls, and a fourth with a gap of a metre. The room graph decides which parts of the
        // jambs belong to which room.
        EXPECT_NEAR(none.perimeter_m, 2.0 * (one == &study ? 5.0 : 4.8) + 8.0 - 1.0 + 0.2, 0.4);
        EXPECT_NEAR(none.floor_m2, (one == &study ? 5.0 : 4.8) * 4.0, 0.5);
        EXPECT_EQ(none.exits, 1);
        EXPECT_FALSE(none.doors_only);
        EXPECT_EQ(none.exits_found, 0);
    }
    // Every part of the floor belongs to exactly one room.
    EXPECT_NEAR(study.place.area_m2() + kitchen.place.area_m2(), 9.8 * 4.0 + 0.2, 0.02 * 39.4);
    LearningNotes notes;
    for (double x = 2.0; x < 8.0; x += 0.05) notes.walked({x, 2.0, 0.0});
    EXPECT_EQ(study.progress(notes).exits_found, 1);
    EXPECT_EQ(kitchen.progress(notes).exits_found, 1);
}

TEST(Learning, keeps_progress_of_a_room_after_leaving_it_and_can_report_on_all_rooms) {
    Lap lap(two_rooms().share());
    EXPECT_TRUE(words_in_order("Learning Study The base is here", lap.request(Command::LearnPlace)));
    lap.walk(Command::TrailLeft, 4.0);
    const std::string before = lap.request(Command::ProgressReport);
    const auto percents = [](const std::string& report) { return report.substr(0, report.find(" percent, floor")); };
    // Places the walker in the other room, so that it touches nothing on the way there.
    lap.app.apply(Placed{{8, 2, 0}, 0.0}, lap.now);
    lap.run(1.5);
    EXPECT_TRUE(lap.reported("Next room to learn Kitchen The base is here")) << lap.said.back();
    EXPECT_TRUE(words_in_order("Walls 0 percent", lap.request(Command::ProgressReport))) << lap.said.back();
    lap.walk(Command::TrailLeft, 2.0);
    lap.app.apply(CommandDown{Command::LearntRooms}, lap.now);
    lap.run(0.1);
    const DialogueView list = lap.app.dialogue().view();
    EXPECT_EQ(list.title, "Rooms learnt: 0 of 2");
    ASSERT_EQ(list.items.size(), 2U);
    EXPECT_EQ(list.items[0].name, "Kitchen");
    EXPECT_EQ(list.items[1].name, "Study");
    EXPECT_EQ("W" + list.items[1].value.substr(1, list.items[1].value.find(" percent, floor") - 1), percents(before));
    lap.app.apply(KeyTapped{"Escape"}, lap.now);
    lap.app.apply(Placed{{2, 1, 0}, 0.0}, lap.now);
    lap.run(1.5);
    EXPECT_TRUE(lap.reported("Learning continues Study")) << lap.said.back();
    EXPECT_EQ(percents(lap.request(Command::ProgressReport)), percents(before));
}

TEST(Learning, an_unexplored_room_is_listed_as_unexplored) {
    Lap lap(two_rooms().share());
    lap.app.apply(CommandDown{Command::LearntRooms}, lap.now);
    lap.run(0.1);
    EXPECT_EQ(lap.app.dialogue().view().items.at(1).value, "nothing yet");
}

}  // namespace learning_test
}  // namespace handrail
