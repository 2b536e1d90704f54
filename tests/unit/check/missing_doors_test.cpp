// Tests a wall that lacks a door. Finds and cuts the missing door, sends the walker and the hand through it, saves it
// in the world's side file and removes it again.
#include "worlds/check/missing_doors.h"

#include <gmock/gmock.h>

#include <cmath>

#include "app/core/kept/made_doors.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/check/faults.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/reach.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace missing_doors_test {

struct World {
    Scene scene;
    WalkSpace space;
    RoomGraph graph;

    explicit World(Scene read) : scene(std::move(read)) {
        const Result<void> valid = validate(scene);
        EXPECT_TRUE(valid) << valid.error().sentence();
        Result<WalkSpace> found = make_walk_space(scene, walker_measures(scene, 0.25, 1.8, 0.25));
        EXPECT_TRUE(found) << found.error().sentence();
        if (!found) return;
        space = std::move(*found);
        graph = make_rooms(scene, space);
    }
    std::uint32_t room(const std::string& name) const {
        for (std::uint32_t r = 0; r < graph.rooms.size(); ++r)
            if (graph.rooms[r].name == name) return r;
        ADD_FAILURE() << "no room " << name;
        return 0;
    }
    std::vector<std::string> out_of_reach() const {
        std::vector<std::string> names;
        for (const WorldFault& fault : find_faults(scene, &space, &graph))
            if (fault.kind == FaultKind::RoomOutOfReach) names.push_back(fault.name);
        return names;
    }
    bool joined(std::uint32_t a, std::uint32_t b) const {
        return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
            return (portal.rooms[0] == a && portal.rooms[1] == b) || (portal.rooms[0] == b && portal.rooms[1] == a);
        });
    }
};

Scene read_rooms(const std::string& text) {
    Result<Scene> scene = read_words(text, "two.rooms");
    EXPECT_TRUE(scene) << scene.error().sentence();
    return scene ? std::move(*scene) : Scene{};
}

// Returns three rooms. The kitchen has no door; the hall is to its west and the store to its north.
Scene three_rooms() {
    return read_rooms(
        "Building: Three rooms.\nWalls: 20 cm thick.\n\nRoom: Hall, 4 by 6 metres. Door outside in the south wall.\n\n"
        "Room: Kitchen, 4 by 4 metres, east of Hall, flush with its south end.\n\n"
        "Room: Store, 4 by 2 metres, north of Kitchen. Door to Hall.\n");
}

// Pushes the proxy from `from_m` towards `to_m`. Returns how far from `to_m` it ends, in metres.
double short_of(const HapticScene& haptic, const Vec3& from_m, const Vec3& to_m) {
    TouchState state;
    TouchTuning tuning;
    tuning.radius_m = 0.05;
    tuning.rated_stiffness_n_per_m = 1000.0;
    tuning.default_stiffness_fraction = 1.0;
    Vec3 proxy = from_m;
    const int steps = static_cast<int>(glm::length(to_m - from_m) / 2e-3);
    for (int i = 0; i <= steps + 200; ++i)
        proxy = touch_tick(state, haptic, tuning, from_m + (to_m - from_m) * std::min(1.0, double(i) / steps), 1e-3)
                    .proxy_m;
    return glm::length(proxy - to_m);
}

TEST(MissingDoors, are_found_in_the_walls_between_an_unreachable_room_and_its_neighbours) {
    const World world(three_rooms());
    EXPECT_THAT(world.out_of_reach(), testing::ElementsAre("Kitchen"));
    const std::vector<MissingDoor> doors = missing_doors(world.scene, world.space, world.graph, world.room("Kitchen"));
    ASSERT_EQ(doors.size(), 3U);
    std::vector<std::string> to;
    for (const MissingDoor& door : doors) to.push_back(world.graph.rooms[door.to].name);
    EXPECT_THAT(to, testing::ElementsAre("Hall", "Store", "ground outside")) << "the longest wall first, rooms before";
    for (const MissingDoor& door : doors) {
        EXPECT_NEAR(door.door.width_m, 0.9, 1e-9);
        EXPECT_GE(door.door.through_m, 0.2) << "at least as thick as the wall";
        EXPECT_LE(door.door.through_m, 0.5);
        EXPECT_NEAR(door.door.place_m.z, 0.0, 0.02);
        if (world.graph.rooms[door.to].name != "Hall") continue;
        // The hall extends from x 0 to 4, so the middle of its east wall is at x = 4. Kitchen and hall share that wall
        // from y 0 to 4.
        EXPECT_NEAR(door.door.place_m.x, 4.0, 0.1);
        EXPECT_NEAR(door.door.place_m.y, 2.0, 0.3);
    }
    EXPECT_TRUE(missing_doors(world.scene, world.space, world.graph, world.room("Hall")).size() >= 1);
}

TEST(MissingDoors, are_suggested_at_the_walkers_place_if_it_is_at_such_a_wall) {
    const World world(three_rooms());
    const Vec3 stood_m(4.0 - 0.4, 1.0, 0.0);  // the person stands in the hall, at the kitchen's wall
    const std::vector<MissingDoor> doors =
        missing_doors(world.scene, world.space, world.graph, world.room("Kitchen"), stood_m);
    ASSERT_FALSE(doors.empty());
    EXPECT_EQ(world.graph.rooms[doors[0].to].name, "Hall");
    EXPECT_NEAR(doors[0].door.place_m.y, 1.0, 0.06);
}

// Returns the model of a small house without its inner door, turned by `degrees` about the vertical.
Scene shut_house(double degrees) {
    std::string text = test::small_house();
    for (const char* instance : {"#122=", "#123=", "#124=", "#125="}) {
        const std::size_t at = text.find(std::string("\n") + instance) + 1;
        text.erase(at, text.find('\n', at) + 1 - at);
    }
    text = test::replaced(text, ",#108,#124,", ",#108,");
    text = test::replaced(text, "#12=IFCAXIS2PLACEMENT3D(#11,$,$)", "#12=IFCAXIS2PLACEMENT3D(#11,#2,#90001)");
    const double angle = radians_from_degrees(degrees);
    text = test::with_instances(
        text, fmt::format("#90001=IFCDIRECTION(({:.12f},{:.12f},0.));\n", std::cos(angle), std::sin(angle)));
    Result<Scene> scene = read_ifc(text, "house.ifc");
    EXPECT_TRUE(scene) << scene.error().sentence();
    return scene ? std::move(*scene) : Scene{};
}

TEST(MissingDoors, are_found_and_created_in_walls_of_any_direction) {
    for (const double degrees : {17.0, 135.0}) {
        SCOPED_TRACE(degrees);
        const double angle = radians_from_degrees(degrees);
        const auto turned = [&](const Vec3& p) {
            return Vec3(std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y,
                        p.z);
        };
        const World before(shut_house(degrees));
        EXPECT_THAT(before.out_of_reach(), testing::ElementsAre("Living room"));
        const std::uint32_t living = before.room("Living room"), kitchen = before.room("Küche");
        const std::vector<MissingDoor> doors = missing_doors(before.scene, before.space, before.graph, living);
        ASSERT_GE(doors.size(), 1U);
        ASSERT_EQ(doors[0].to, kitchen) << "rooms before the ground outside";
        const MadeDoor& door = doors[0].door;
        // The middle of the wall between the rooms is 4 m east of the house's corner. The wall is 4 m long and 0.1 m
        // thick.
        const Vec3 off = door.place_m - turned({4.0, 2.0, 0.0});
        EXPECT_NEAR(glm::dot(off, turned({1.0, 0.0, 0.0})), 0.0, 0.06);
        EXPECT_LT(std::abs(glm::dot(off, turned({0.0, 1.0, 0.0}))), 1.0);
        EXPECT_NEAR(std::abs(glm::dot(Vec3(std::sin(door.heading_rad), std::cos(door.heading_rad), 0.0),
                                      turned({1.0, 0.0, 0.0}))),
                    1.0, 1e-6);
        EXPECT_NEAR(door.width_m, 0.9, 1e-9);
        EXPECT_LE(door.through_m, 0.35);
        const World after(with_made_doors(before.scene, std::vector{door}));
        EXPECT_THAT(after.out_of_reach(), testing::IsEmpty());
        EXPECT_TRUE(after.joined(after.room("Living room"), after.room("Küche")));
        const Vec3 along(std::sin(door.heading_rad), std::cos(door.heading_rad), 0.0);
        EXPECT_TRUE(after.space.straight(door.place_m - along * 0.8, door.place_m + along * 0.8));
        // If a person stands at the wall, the offered door must be where the person stands.
        const Vec3 stood_m = turned({4.4, 3.2, 0.0});
        const auto near = missing_doors(before.scene, before.space, before.graph, living, stood_m, 1);
        ASSERT_EQ(near.size(), 1U);
        EXPECT_LT(glm::length(near[0].door.place_m - turned({4.0, 3.2, 0.0})), 0.1);
    }
}

TEST(ImpassableDoors, of_the_file_can_be_cut_free_of_a_wall_that_stands_in_them) {
    Scene scene = three_rooms();
    auto stated = std::make_shared<StatedBuilding>(*scene.stated);
    StatedPortal walled;
    walled.kind = StatedPortalKind::Door;
    walled.name = "kitchen door";
    walled.place_m = {4.0, 2.0, 0.0};
    walled.width_m = 0.9;
    walled.height_m = 2.0;
    walled.rooms = {0, 1};
    walled.passable = false;
    walled.source.line = 3;
    stated->portals.push_back(walled);
    scene.stated = stated;
    const auto impassable = [](const World& world) {
        for (const WorldFault& fault : find_faults(world.scene, &world.space, &world.graph))
            if (fault.kind == FaultKind::ImpassableDoor) return std::optional(fault);
        return std::optional<WorldFault>();
    };
    const World before(scene);
    const auto fault = impassable(before);
    ASSERT_TRUE(fault.has_value());
    const std::optional<MadeDoor> door = doorway_cut_free(before.scene, *fault);
    ASSERT_TRUE(door.has_value());
    EXPECT_NEAR(std::abs(std::sin(door->heading_rad)), 1.0, 1e-9);
    EXPECT_GE(door->through_m, 0.2);
    const World after(with_made_doors(before.scene, std::vector{*door}));
    EXPECT_FALSE(impassable(after).has_value());
    EXPECT_THAT(after.out_of_reach(), testing::IsEmpty());
    EXPECT_EQ(after.scene.stated->portals.size(), scene.stated->portals.size()) << "it is the same door";
    // doorway_cut_free() must return nothing if an object blocks the door, or if the fault is of another kind.
    WorldFault other = *fault;
    other.other = "Cupboard";
    EXPECT_FALSE(doorway_cut_free(before.scene, other).has_value());
    other = *fault;
    other.kind = FaultKind::DoorOnNoWall;
    EXPECT_FALSE(doorway_cut_free(before.scene, other).has_value());
}

TEST(MadeDoors, open_the_wall_to_body_and_hand_only_within_the_doorway) {
    const World before(three_rooms());
    const std::uint32_t kitchen = before.room("Kitchen"), hall = before.room("Hall");
    EXPECT_FALSE(before.joined(kitchen, hall));
    MadeDoor door;
    for (const MissingDoor& missing : missing_doors(before.scene, before.space, before.graph, kitchen))
        if (missing.to == hall) door = missing.door;
    door.name = "Kitchen, Hall";
    const World after(with_made_doors(before.scene, std::vector{door}));
    EXPECT_THAT(after.out_of_reach(), testing::IsEmpty());
    EXPECT_TRUE(after.joined(after.room("Kitchen"), after.room("Hall")));
    EXPECT_FALSE(after.joined(after.room("Kitchen"), after.room("Store")));
    EXPECT_EQ(after.graph.rooms.size(), before.graph.rooms.size());
    // The walker must pass straight through the door's place in the new world, but not in the old one.
    const Vec3 along(std::sin(door.heading_rad), std::cos(door.heading_rad), 0.0), across(along.y, -along.x, 0.0);
    EXPECT_TRUE(after.space.straight(door.place_m - along * 0.8, door.place_m + along * 0.8));
    EXPECT_FALSE(before.space.straight(door.place_m - along * 0.8, door.place_m + along * 0.8));
    // The hand must also pass through the whole width and height of the door. To the sides of the door and above it,
    // the wall must be unchanged.
    const auto was = compile_haptic(before.scene, MaterialSource::KeysOnly),
               is = compile_haptic(after.scene, MaterialSource::KeysOnly);
    const auto pushed = [&](const HapticScene& haptic, double right_m, double up_m) {
        const Vec3 at = door.place_m + across * right_m + Vec3(0.0, 0.0, up_m);
        return short_of(haptic, at - along * 0.5, at + along * 0.5);
    };
    for (const double right_m : {-0.35, 0.0, 0.35})
        for (const double up_m : {0.1, 1.0, 1.9}) {
            EXPECT_LT(pushed(*is, right_m, up_m), 0.02) << right_m << " " << up_m;
            EXPECT_GT(pushed(*was, right_m, up_m), 0.4) << right_m << " " << up_m;
        }
    for (const auto& [right_m, up_m] : {std::pair{-0.7, 1.0}, std::pair{0.7, 1.0}, std::pair{0.0, 2.3}})
        EXPECT_GT(pushed(*is, right_m, up_m), 0.4) << right_m << " " << up_m;
    // In the doorway, both sides and the top of the frame must stop the hand.
    const Vec3 within = door.place_m + Vec3(0.0, 0.0, 1.0);
    EXPECT_GT(short_of(*is, within, within + across * 0.7), 0.2);
    EXPECT_GT(short_of(*is, within, within - across * 0.7), 0.2);
    EXPECT_GT(short_of(*is, within, within + Vec3(0.0, 0.0, 1.3)), 0.2);
    // The building must now state the door as an opening between the two rooms.
    const StatedPortal& stated = after.scene.stated->portals.back();
    EXPECT_EQ(stated.kind, StatedPortalKind::Opening);
    ASSERT_EQ(stated.rooms.size(), 2U);
    EXPECT_EQ(after.scene.stated->portals.size(), before.scene.stated->portals.size() + 1);
}

// Two rooms of a .map. Between them is a double wall without a floor under it.
TEST(MadeDoors, cut_through_walls_of_several_layers_and_get_a_threshold_if_there_is_no_floor) {
    std::string brushes;
    const auto room = [&](double west) {
        brushes +=
            test::box_brush(west, 0, -8, west + 128, 128, 0) + test::box_brush(west, 0, 96, west + 128, 128, 104);
        brushes +=
            test::box_brush(west, -8, -8, west + 128, 0, 104) + test::box_brush(west, 128, -8, west + 128, 136, 104);
    };
    room(0), room(136);
    brushes += test::box_brush(-8, -8, -8, 0, 136, 104) + test::box_brush(264, -8, -8, 272, 136, 104);
    brushes += test::box_brush(128, -8, 0, 132, 136, 104) + test::box_brush(132, -8, 0, 136, 136, 104);
    const std::string map =
        test::entity("worldspawn", test::key("message", "Two") + test::key("building", "1"), brushes) +
        test::entity("info_player_start", test::key("origin", "64 64 24")) +
        test::entity("info_player_deathmatch", test::key("origin", "200 64 24"));
    Result<Scene> scene = read_quake_map(map, "two.map");
    ASSERT_TRUE(scene);
    const World before(std::move(*scene));
    ASSERT_EQ(before.graph.rooms.size(), 2U);
    const std::vector<MissingDoor> doors = missing_doors(before.scene, before.space, before.graph, 0);
    ASSERT_EQ(doors.size(), 1U);
    EXPECT_NEAR(doors[0].door.place_m.x, 132.0 / 32.0, 0.06);
    const World after(with_made_doors(before.scene, std::vector{doors[0].door}));
    EXPECT_TRUE(after.joined(0, 1));
    const Vec3 place = doors[0].door.place_m;
    EXPECT_TRUE(after.space.straight(place - Vec3(1, 0, 0), place + Vec3(1, 0, 0)));
    const auto haptic = compile_haptic(after.scene, MaterialSource::KeysOnly);
    EXPECT_GT(short_of(*haptic, place + Vec3(0, 0, 0.5), place - Vec3(0, 0, 0.3)), 0.2) << "the threshold is felt";
}

TEST(MadeDoors, are_saved_in_the_side_file_and_removed_from_it_again) {
    const test::TemporaryFolder folder;
    const auto world = folder.write("two.rooms", "bytes");
    MadeDoor door{{1.25, -2.5, 3.0}, 0.5 * kPi, 0.8, 0.3, "Kitchen, Hall"}, other = door;
    other.place_m.y = 4.0;
    {
        SideFile file = SideFile::of_world(world, folder.path());
        keep_made_door(file, door);
        keep_made_door(file, other);
        ASSERT_TRUE(file.save().has_value());
    }
    for (const std::vector<MadeDoor>& kept :
         {kept_doors(world, folder.path(), false), read_made_doors(SideFile::of_world(world, folder.path())),
          made_doors_in(test::content_of(folder.path() / "two.rooms.handrail.toml"))}) {
        ASSERT_EQ(kept.size(), 2U);
        EXPECT_EQ(kept[0].place_m, door.place_m);
        EXPECT_NEAR(kept[0].heading_rad, door.heading_rad, 1e-12);
        EXPECT_EQ(kept[0].width_m, door.width_m);
        EXPECT_EQ(kept[0].through_m, door.through_m);
        EXPECT_EQ(kept[0].name, door.name);
    }
    SideFile file = SideFile::of_world(world, folder.path());
    drop_made_door(file, door.place_m);
    ASSERT_TRUE(file.save().has_value());
    EXPECT_EQ(kept_doors(world, folder.path(), false).size(), 1U);
    drop_made_door(file, other.place_m);
    ASSERT_TRUE(file.save().has_value());
    EXPECT_TRUE(kept_doors(world, folder.path(), false).empty());
    EXPECT_EQ(test::content_of(world), "bytes") << "the world itself is as it was";
}

TEST(MadeDoors, with_invalid_data_are_ignored) {
    const auto doors_in = [](const char* fields) {
        return made_doors_in(std::string("[mended]\n[[mended.door]]\n") + fields).size();
    };
    EXPECT_EQ(doors_in("place_m = [0.0, 0.0, 0.0]\nheading_deg = 90.0\n"), 1U);
    EXPECT_EQ(doors_in("heading_deg = 90.0\n"), 0U) << "nowhere";
    EXPECT_EQ(doors_in("place_m = [0.0, 0.0]\n"), 0U);
    EXPECT_EQ(doors_in("place_m = [0.0, 0.0, 0.0]\nwidth_m = 100.0\n"), 0U);
    EXPECT_EQ(doors_in("place_m = [0.0, 0.0, 0.0]\nwidth_m = -1.0\n"), 0U);
    EXPECT_EQ(doors_in("place_m = [0.0, 0.0, 0.0]\nthrough_m = 50.0\n"), 0U);
    EXPECT_TRUE(made_doors_in("[mended]\ndoor = 3\n").empty());
    EXPECT_TRUE(made_doors_in("this is no TOML").empty());
}

}  // namespace missing_doors_test
}  // namespace handrail
