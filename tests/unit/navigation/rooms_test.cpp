// Tests rooms, what joins them, and routes between every pair of them.
#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "tests/support/box_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/navigation/grid_twin.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace rooms_test {

using testing::IsSupersetOf;

struct World {
    Scene scene;
    std::shared_ptr<Navigation> navigation;
    RoomGraph graph;
};

World world_of(const std::filesystem::path& path) {
    World world;
    auto scene = read_world(path);
    EXPECT_TRUE(scene) << path;
    world.scene = std::move(*scene);
    const WalkerSize size = walker_size(world.scene, 0.25);
    auto made =
        Navigation::make(world.scene, walker_measures(world.scene, size.radius_m, size.height_m, size.step_up_m));
    EXPECT_TRUE(made) << path;
    world.navigation = *made;
    world.graph = make_rooms(world.scene, world.navigation->space());
    return world;
}

std::filesystem::path bundled(const std::string& name) { return test::project_root() / "worlds" / "maps" / name; }

std::string described(const RoomGraph& graph) {
    std::string text;
    for (std::size_t r = 0; r < graph.rooms.size(); ++r)
        text +=
            fmt::format("{}: {} ({}), level {}, {:.1f} m2, z {:.1f}, middle {:.1f} {:.1f}\n", r, graph.rooms[r].name,
                        static_cast<int>(graph.rooms[r].kind), graph.rooms[r].level, graph.rooms[r].area_m2,
                        graph.rooms[r].floor_m, graph.rooms[r].middle_m.x, graph.rooms[r].middle_m.y);
    for (const Portal& portal : graph.portals)
        text += fmt::format("  {} - {}: kind {}, {:.2f} m wide at {:.1f} {:.1f} {:.1f}\n",
                            graph.rooms[portal.rooms[0]].name, graph.rooms[portal.rooms[1]].name,
                            static_cast<int>(portal.kind), portal.width_m, portal.place_m.x, portal.place_m.y,
                            portal.place_m.z);
    return text;
}

// Checks the rules that the rooms of every world must obey.
void is_sound(const World& world) {
    const RoomGraph& graph = world.graph;
    ASSERT_EQ(graph.room_of_span.size(), world.navigation->space().spans.size());
    std::set<std::string> names;
    for (const Room& room : graph.rooms) {
        EXPECT_FALSE(room.name.empty());
        EXPECT_TRUE(names.insert(room.name).second) << room.name << " twice";
        EXPECT_GT(room.area_m2, 0.0);
        EXPECT_FALSE(room.bounds_m.empty());
    }
    for (const std::uint32_t room : graph.room_of_span) ASSERT_LT(room, graph.rooms.size());
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r)
        EXPECT_EQ(room_at(graph, world.navigation->space(), graph.rooms[r].middle_m), r) << graph.rooms[r].name;
    for (const Portal& portal : graph.portals) {
        ASSERT_LT(portal.rooms[0], graph.rooms.size());
        ASSERT_LT(portal.rooms[1], graph.rooms.size());
        EXPECT_NE(portal.rooms[0], portal.rooms[1]);
        EXPECT_TRUE(is_finite(portal.place_m));
    }
}

TEST(Rooms, of_our_house_are_all_found_and_named_and_every_door_joins_two) {
    const World world = world_of(bundled("house.map"));
    is_sound(world);
    const auto room = [&](const std::string& name) {
        for (std::uint32_t r = 0; r < world.graph.rooms.size(); ++r)
            if (world.graph.rooms[r].name == name) return r;
        ADD_FAILURE() << name << " is missing among\n" << described(world.graph);
        return kNothing;
    };
    for (const char* name : {"Living room", "Kitchen", "Hall", "Study", "Bathroom", "Utility room", "Garden"})
        EXPECT_EQ(world.graph.rooms[room(name)].level, 0) << name;
    for (const char* name : {"Bedroom", "Child's room", "Landing", "Guest room", "Upper bathroom", "Music room"})
        EXPECT_EQ(world.graph.rooms[room(name)].level, 1) << name;
    const auto joins = [&](const std::string& door, const std::string& a, const std::string& b) {
        const std::set<std::uint32_t> wanted{room(a), room(b)};
        const bool found = std::any_of(world.graph.portals.begin(), world.graph.portals.end(), [&](const Portal& p) {
            return p.kind == PassageKind::Door && world.scene.find(p.feature)->name == door &&
                   std::set<std::uint32_t>{p.rooms[0], p.rooms[1]} == wanted;
        });
        EXPECT_TRUE(found) << door << " between " << a << " and " << b << " is missing among\n"
                           << described(world.graph);
    };
    joins("Front door", "Hall", "Garden");
    joins("Garden door", "Hall", "Garden");
    joins("Living room door", "Hall", "Living room");
    joins("Study door", "Hall", "Study");
    joins("Bathroom door", "Hall", "Bathroom");
    joins("Utility room door", "Hall", "Utility room");
    joins("Bedroom door", "Landing", "Bedroom");
    joins("Child's room door", "Landing", "Child's room");
    joins("Guest room door", "Landing", "Guest room");
    joins("Upper bathroom door", "Landing", "Upper bathroom");
    joins("Music room door", "Landing", "Music room");
    // The opening between living room and kitchen must be 1.6 m wide.
    const std::set<std::uint32_t> open{room("Living room"), room("Kitchen")};
    const auto opening = std::find_if(world.graph.portals.begin(), world.graph.portals.end(), [&](const Portal& p) {
        return p.kind == PassageKind::Opening && std::set<std::uint32_t>{p.rooms[0], p.rooms[1]} == open;
    });
    ASSERT_NE(opening, world.graph.portals.end()) << described(world.graph);
    EXPECT_NEAR(opening->width_m, 1.6, 0.25);
    EXPECT_TRUE(std::any_of(world.graph.rooms.begin(), world.graph.rooms.end(),
                            [](const Room& r) { return r.kind == RoomKind::Stairs; }));
}

// For each pair of rooms, a grid search must find a route if the program finds one, and only then. The lengths may
// differ by 5 % and the side of a square.
TEST(Rooms, are_connected_in_every_bundled_world_as_a_grid_search_finds) {
    for (const auto& entry : std::filesystem::directory_iterator(test::project_root() / "worlds" / "maps")) {
        if (entry.path().extension() != ".map") continue;
        SCOPED_TRACE(entry.path().filename().string());
        if (!test::tried(entry.path().filename() == "house.map" ? 0 : 1, 2)) continue;
        const World world = world_of(entry.path());
        is_sound(world);
        std::vector<Vec3> middles;
        for (const Room& room : world.graph.rooms)
            if (room.kind == RoomKind::Room) middles.push_back(room.middle_m);
        constexpr double kSide_m = 0.1;
        test::GridTwin twin(world.scene, walker_size(world.scene, 0.25), kSide_m);
        for (const Vec3& middle : middles) EXPECT_TRUE(twin.flood_from(middle));
        for (std::size_t source = 0; source < middles.size(); source += test::source_stride()) {
            const Vec3 from = middles[source];
            const std::vector<Vec3> others = test::from_on(middles, source);
            const auto lengths = twin.lengths(from, others);
            for (std::size_t i = 0; i < others.size(); ++i)
                for (const auto& [begin, end] : {std::pair(from, others[i]),
                                                 // The grid search gives the same length in both directions.
                                                 std::pair(others[i], from)}) {
                    const Route route = world.navigation->plan(begin, end, RoutePreference::Shortest);
                    // Routes with drops are skipped, because the grid search never steps off an edge.
                    if (route.drops) continue;
                    EXPECT_EQ(route.reaches, lengths[i].has_value()) << described(world.graph);
                    if (route.reaches && lengths[i]) {
                        EXPECT_NEAR(test::length_with_rides_m(route), *lengths[i], 0.05 * *lengths[i] + kSide_m)
                            << begin.x << " " << begin.y << " to " << end.x << " " << end.y;
                    }
                }
        }
    }
}

TEST(Rooms, of_complete_maps_are_many_and_connected_through_their_doors) {
    struct Expected {
        std::filesystem::path file;
        std::size_t least_rooms, most_rooms, least_doors;
    };
    std::vector<Expected> worlds{{bundled("house.map"), 8, 20, 6}, {bundled("school.map"), 8, 40, 8}};
    for (const Expected& real :
         {Expected{"agtut01.map", 2, 8, 1}, Expected{"agdm01.map", 9, 12, 4}, Expected{"office.map", 4, 60, 2}})
        for (const auto& path : test::with_real_worlds({}, {real.file.string()}))
            worlds.push_back({path, real.least_rooms, real.most_rooms, real.least_doors});
    for (const Expected& expected : worlds) {
        SCOPED_TRACE(expected.file);
        const World world = world_of(expected.file);
        is_sound(world);
        const auto rooms =
            static_cast<std::size_t>(std::count_if(world.graph.rooms.begin(), world.graph.rooms.end(),
                                                   [](const Room& r) { return r.kind == RoomKind::Room; }));
        const auto doors =
            static_cast<std::size_t>(std::count_if(world.graph.portals.begin(), world.graph.portals.end(),
                                                   [](const Portal& p) { return p.kind == PassageKind::Door; }));
        EXPECT_GE(rooms, expected.least_rooms) << described(world.graph);
        EXPECT_LE(rooms, expected.most_rooms) << described(world.graph);
        EXPECT_GE(doors, expected.least_doors) << described(world.graph);
    }
}

// Returns two rooms of 6 by 5 m. The wall between them has a gap of `gap_units`. `more` adds further entities.
std::string two_rooms(double gap_units, const std::string& more = {}) {
    using test::box_brush;
    const double low = 80.0 - 0.5 * gap_units, high = 80.0 + 0.5 * gap_units;
    return test::entity("worldspawn", test::key("building", "1"),
                        test::room_brushes(0, 0, 0, 400, 160, 96) + box_brush(196, 0, 0, 204, low, 96) +
                            box_brush(196, high, 0, 204, 160, 96)) +
           more + test::entity("info_player_start", test::key("origin", "40 80 24"));
}
RoomGraph rooms_of(const std::string& map, Scene* keep = nullptr, WalkSpace* space = nullptr) {
    auto scene = read_quake_map(map, "rooms.map");
    EXPECT_TRUE(scene);
    auto made = make_walk_space(*scene, WalkerMeasures{});
    EXPECT_TRUE(made);
    RoomGraph graph = make_rooms(*scene, *made);
    if (keep) *keep = std::move(*scene);
    if (space) *space = std::move(*made);
    return graph;
}

TEST(Rooms, are_separated_by_converging_walls_but_not_by_furniture) {
    const RoomGraph two = rooms_of(two_rooms(32.0));  // the gap is 1 m wide
    EXPECT_EQ(two.rooms.size(), 2U) << described(two);
    ASSERT_EQ(two.portals.size(), 1U);
    EXPECT_EQ(two.portals[0].kind, PassageKind::Opening);
    EXPECT_NEAR(two.portals[0].width_m, 1.0, 0.2);
    EXPECT_NEAR(two.portals[0].place_m.x, 6.25, 0.3);
    EXPECT_EQ(rooms_of(two_rooms(160.0)).rooms.size(), 1U);  // the gap is as wide as the room, so no wall remains
    // A cupboard stands across most of an undivided room.
    const RoomGraph one = rooms_of(two_rooms(
        160.0, test::entity("thing", test::key("name", "Cupboard"), test::box_brush(196, 0, 0, 204, 128, 40))));
    EXPECT_EQ(one.rooms.size(), 1U) << described(one);
}

// A platform has no walls, so the middle of a walker can be beyond its edges. A floor without a name that adjoins a
// platform must remain a room.
TEST(Rooms, that_a_file_states_include_their_rims_without_walls) {
    const auto across = [](double along_m, double aside_m) {
        return Vec2(0.96 * along_m - 0.28 * aside_m, 0.28 * along_m + 0.96 * aside_m);
    };
    const auto outline = [&](double from_m, double to_m) {
        return std::vector<Vec2>{across(0.0, from_m), across(60.0, from_m), across(60.0, to_m), across(0.0, to_m)};
    };
    for (const double cell_m : {0.05, 0.2})
        for (const double nameless_m : {0.0, 1.5}) {
            test::SceneBuilder builder;
            builder.prism(outline(0.0, 6.0 + nameless_m), -0.5, 0.0, "platform");
            StatedRoom platform;
            platform.name = "Platform 1";
            platform.rings = {outline(0.0, 6.0)};
            platform.height_m = 3.0;
            platform.at_m = Vec3(across(30.0, 3.0), 0.0);
            builder.start(platform.at_m, 0.0);
            StatedBuilding stated;
            stated.rooms = {platform};
            builder.scene().stated = std::make_shared<const StatedBuilding>(stated);
            WalkerMeasures body;
            body.cell_m = cell_m;
            const Result<WalkSpace> space = make_walk_space(builder.scene(), body);
            ASSERT_TRUE(space);
            const RoomGraph graph = make_rooms(builder.scene(), *space);
            const std::uint32_t named = room_at(graph, *space, platform.at_m),
                                rim = room_at(graph, *space, Vec3(across(30.0, -0.12), 0.0)),
                                nameless = room_at(graph, *space, Vec3(across(30.0, 6.75), 0.0));
            EXPECT_EQ(graph.rooms.size(), nameless_m > 0.0 ? 2U : 1U) << described(graph);
            EXPECT_EQ(rim, named);
            EXPECT_EQ(nameless != kNothing && nameless != named, nameless_m > 0.0);
        }
}

// Corridors without doors, 4 m wide. They form a ring around a block of 20 by 20 m, with an arm of 20 m to the west.
TEST(Rooms, are_the_straight_stretches_of_corridors_that_turn_and_branch) {
    using test::box_brush;
    const std::string block = box_brush(128, 128, 0, 768, 768, 96);
    const std::string arm_sides = box_brush(-640, 0, 0, 0, 384, 96) + box_brush(-640, 512, 0, 0, 896, 96);
    const RoomGraph ring = rooms_of(test::entity("worldspawn", test::key("building", "1"),
                                                 test::room_brushes(-640, 0, 0, 896, 896, 96) + block + arm_sides) +
                                    test::entity("info_player_start", test::key("origin", "64 64 24")));
    ASSERT_EQ(ring.rooms.size(), 5U) << described(ring);  // four sides and the arm
    for (const Room& room : ring.rooms) EXPECT_EQ(room.name.substr(0, 8), "corridor") << room.name;
    EXPECT_EQ(ring.portals.size(), 5U) << described(ring);  // four corners of the ring and the branch of the arm
    for (const Portal& portal : ring.portals) EXPECT_NEAR(portal.width_m, 4.0, 0.7) << described(ring);
    // A hall of the same size must be one room.
    const RoomGraph hall =
        rooms_of(test::entity("worldspawn", test::key("building", "1"), test::room_brushes(0, 0, 0, 896, 896, 96)) +
                 test::entity("info_player_start", test::key("origin", "64 64 24")));
    EXPECT_EQ(hall.rooms.size(), 1U) << described(hall);
}

TEST(Rooms, are_named_by_the_map_the_person_their_contents_or_size_and_place) {
    const std::string names =
        test::entity("info_room", test::key("name", "Workshop") + test::key("origin", "60 80 16"));
    const std::string stove = test::entity("thing", test::key("name", "Stove") + test::key("landmark", "1"),
                                           test::box_brush(360, 60, 0, 400, 100, 40));
    Scene scene;
    WalkSpace space;
    RoomGraph graph = rooms_of(two_rooms(32.0, names + stove), &scene, &space);
    ASSERT_EQ(graph.rooms.size(), 2U) << described(graph);
    EXPECT_EQ(graph.rooms[room_at(graph, space, {1.0, 2.5, 0.0})].name, "Workshop");
    EXPECT_EQ(graph.rooms[room_at(graph, space, {9.0, 2.5, 0.0})].name, "room with Stove");
    EXPECT_EQ(give_names(graph, space,
                         {{{9.0, 2.5, 0.0}, "My kitchen"}, {{500.0, 2.5, 0.0}, "Gone"}, {{9.5, 2.5, 0.0}, "Second"}}),
              (std::vector<std::string>{"Gone", "Second"}));
    EXPECT_EQ(graph.rooms[room_at(graph, space, {9.0, 2.5, 0.0})].name, "My kitchen");
    const RoomGraph plain = rooms_of(two_rooms(32.0));
    std::set<std::string> reported;
    for (const Room& room : plain.rooms) {
        EXPECT_TRUE(room.name == "room, east" || room.name == "room, west") << room.name;
        reported.insert(room.name.substr(room.name.rfind(' ') + 1));
    }
    EXPECT_EQ(reported, (std::set<std::string>{"east", "west"}));
    // If the map gives two names in one open space, they must divide the space into two rooms.
    const std::string both =
        names + test::entity("info_room", test::key("name", "Store") + test::key("origin", "340 80 16"));
    EXPECT_EQ(rooms_of(two_rooms(100.0, both)).rooms.size(), 2U);
}

// A hall of 20 by 10 m. Eight rooms of 2.5 by 2 m are along its north wall. Each opens to the hall with a gap of 0.9 m.
TEST(Rooms, that_look_alike_on_the_same_side_are_called_second_and_third) {
    using test::box_brush;
    std::string walls = test::room_brushes(0, 0, 0, 640, 400, 96);
    for (int i = 0; i < 8; ++i) {
        const int west = 80 * i, middle = west + 40;
        walls += box_brush(west, 328, 0, middle - 14, 336, 96) + box_brush(middle + 14, 328, 0, west + 80, 336, 96);
        if (i > 0) walls += box_brush(west - 4, 336, 0, west + 4, 400, 96);
    }
    RoomGraph graph = rooms_of(test::entity("worldspawn", test::key("building", "1"), walls) +
                               test::entity("info_player_start", test::key("origin", "320 100 24")));
    ASSERT_EQ(graph.rooms.size(), 9U) << described(graph);
    const auto names = [&] {
        std::set<std::string> all;
        for (const Room& room : graph.rooms) all.insert(room.name);
        return all;
    };
    EXPECT_THAT(names(), IsSupersetOf({"small room, north", "second small room, north"}));
    const test::InLanguage german("de");
    say_room_names(graph);
    EXPECT_THAT(names(), IsSupersetOf({"kleiner Raum, Norden", "kleiner Raum, Norden, Nummer 2"}));
}

TEST(Rooms, with_the_same_name_are_numbered_as_a_person_would) {
    const std::vector<std::pair<int, std::string>> ordinals{{2, "second"},  {7, "7th"},    {11, "11th"}, {12, "12th"},
                                                            {13, "13th"},   {21, "21st"},  {22, "22nd"}, {63, "63rd"},
                                                            {111, "111th"}, {152, "152nd"}};
    for (const auto& [number, ordinal] : ordinals)
        EXPECT_EQ(phrase("room_name.another", {{"room", "lobby"}, {"number", number}}), ordinal + " lobby");
}

TEST(Rooms, names_follow_the_language_except_those_given_by_the_person) {
    const std::string stove =
        test::entity("thing", test::key("name", "Stove") + test::key("name_de", "Ofen") + test::key("landmark", "1"),
                     test::box_brush(360, 60, 0, 400, 100, 40));
    Scene scene;
    WalkSpace space;
    RoomGraph graph = rooms_of(two_rooms(32.0, stove), &scene, &space);
    const std::uint32_t west = room_at(graph, space, {1.0, 2.5, 0.0}), east = room_at(graph, space, {9.0, 2.5, 0.0});
    const std::string english = graph.rooms[west].name;
    EXPECT_TRUE(english == "room, west") << english;
    {
        const test::InLanguage german("de");
        say_room_names(graph);
        EXPECT_EQ(graph.rooms[west].name, "Raum, Westen");
        EXPECT_EQ(graph.rooms[east].name, "Raum, darin Ofen");
        give_names(graph, space, {{{9.0, 2.5, 0.0}, "room"}});
    }
    say_room_names(graph);
    EXPECT_EQ(graph.rooms[west].name, english);
    EXPECT_EQ(graph.rooms[east].name, "room");
}

TEST(Rooms, names_of_the_map_follow_the_language_too) {
    const std::string shop =
        test::entity("info_room", test::key("name", "Workshop") + test::key("name_de", "Werkstatt") +
                                      test::key("origin", "60 80 16"));
    RoomGraph graph = rooms_of(two_rooms(32.0, shop));
    const auto names = [&] {
        std::set<std::string> all;
        for (const Room& room : graph.rooms) all.insert(room.name);
        return all;
    };
    EXPECT_TRUE(names().contains("Workshop"));
    {
        const test::InLanguage german("de");
        say_room_names(graph);
        EXPECT_TRUE(names().contains("Werkstatt"));
        EXPECT_FALSE(names().contains("Workshop"));
    }
    say_room_names(graph);
    EXPECT_TRUE(names().contains("Workshop"));
}

TEST(Rooms, list_their_exits_clockwise) {
    RoomGraph graph;
    graph.rooms.resize(5);
    const Vec3 places[] = {{0, 5, 0}, {-5, 0, 0}, {5, 0, 0}, {0, -5, 0}};
    for (std::uint32_t p = 0; p < 4; ++p)
        graph.portals.push_back({PassageKind::Opening, {0, p + 1}, places[p], 1.0, kNoFeature, false});
    // This drop is passable only into room 0.
    graph.portals.push_back({PassageKind::Drop, {1, 0}, {1, 1, 0}, 1.0, kNoFeature, true});
    EXPECT_EQ(exits_of(graph, 0, {0, 0, 0}, 0.0), (std::vector<std::uint32_t>{0, 2, 3, 1}));
    EXPECT_EQ(exits_of(graph, 0, {0, 0, 0}, kPi), (std::vector<std::uint32_t>{3, 1, 0, 2}));
    EXPECT_EQ(exits_of(graph, 1, {0, 0, 0}, 0.0).size(), 2U);
}

}  // namespace rooms_test
}  // namespace handrail
