// Checks the school map, and copies of it that have one deliberate fault each.
#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/main/commands.h"
#include "tests/support/box_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/check/faults.h"
#include "worlds/check/missing_doors.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace planted_faults_test {

const std::string& school() {
    static const std::string kText = test::content_of(test::bundled_world("school.map"));
    return kText;
}

// A map's text. Tests can change the entities of the map, which they identify by class and name.
class MapCopy {
public:
    explicit MapCopy(std::string text) : text_(std::move(text)) {}

    MapCopy& remove(const std::string& class_name, const std::string& name) {
        const auto [begin, end] = entity(class_name, name);
        text_.erase(begin, end - begin);
        return *this;
    }
    // Replaces `what` by `by` within one entity.
    MapCopy& replace(const std::string& class_name, const std::string& name, const std::string& what,
                     const std::string& by) {
        const auto [begin, end] = entity(class_name, name);
        std::string part = text_.substr(begin, end - begin);
        EXPECT_NE(part.find(what), std::string::npos) << name << " has no " << what;
        for (std::size_t at = 0; (at = part.find(what, at)) != std::string::npos; at += by.size())
            part.replace(at, what.size(), by);
        text_.replace(begin, end - begin, part);
        return *this;
    }
    MapCopy& repeat(const std::string& class_name, const std::string& name) {
        const auto [begin, end] = entity(class_name, name);
        text_ += text_.substr(begin, end - begin);
        return *this;
    }
    MapCopy& add(const std::string& entity_text) {
        text_ += entity_text;
        return *this;
    }
    // Removes the brush of worldspawn that contains the line `face`.
    MapCopy& remove_brush(const std::string& face) {
        const std::size_t at = text_.find(face);
        EXPECT_NE(at, std::string::npos) << face;
        const std::size_t from = text_.rfind("{\n", at), to = text_.find("}\n", at) + 2;
        text_.erase(from, to - from);
        return *this;
    }
    const std::string& text() const { return text_; }

private:
    std::pair<std::size_t, std::size_t> entity(const std::string& class_name, const std::string& name) const {
        const std::string head = "{\n\"classname\" \"" + class_name + "\"\n";
        const std::string named = "\"name\" \"" + name + "\"\n";
        for (std::size_t begin = 0; (begin = text_.find(head, begin)) != std::string::npos; ++begin) {
            std::size_t end = text_.find("\n}\n", begin) + 3;
            while (text_.compare(end, 2, "}\n") != 0 && text_.compare(end, 2, "{\n") == 0 &&
                   text_.compare(end, 3, "{\n\"") != 0)
                end = text_.find("\n}\n", end) + 3;  // the end of the entity, including its brushes
            if (text_.compare(end, 2, "}\n") == 0) end += 2;
            if (text_.substr(begin, end - begin).find(named) != std::string::npos) return {begin, end};
        }
        ADD_FAILURE() << "no " << class_name << " " << name;
        return {0, 0};
    }

    std::string text_;
};

std::string thing(const std::string& name, const std::string& brushes, const std::string& keys = {}) {
    return test::entity("thing", test::key("name", name) + keys, brushes);
}
std::string wall(const std::string& brushes) { return test::entity("func_group", {}, brushes); }

struct Found {
    Scene scene;
    std::vector<WorldFault> faults;
    RoomGraph graph;
};

// Returns the faults of a map. `state` may add to the scene what a file that states its rooms would contain.
Found faults_of(const std::string& map, const std::function<void(Scene&, const RoomGraph&)>& state = {}) {
    Found found;
    Result<Scene> scene = read_quake_map(map, "school.map");
    EXPECT_TRUE(scene);
    if (!scene) return found;
    found.scene = std::move(*scene);
    const Result<std::shared_ptr<Navigation>> navigation =
        Navigation::make(found.scene, walker_measures(found.scene, 0.25, 1.8, 0.25));
    if (!navigation) {
        found.faults = find_faults(found.scene, nullptr, nullptr);
        return found;
    }
    found.graph = make_rooms(found.scene, (*navigation)->space());
    if (state) state(found.scene, found.graph);
    found.faults = find_faults(found.scene, &(*navigation)->space(), &found.graph);
    return found;
}

std::string listed(const Found& found) {
    std::string list;
    for (const WorldFault& fault : found.faults)
        list += fmt::format("{} ({:.2f} {:.2f} {:.2f}, line {}): {} {}\n", row_of(fault.kind).word, fault.at_m.x,
                            fault.at_m.y, fault.at_m.z, fault.source.line, fault_words(found.scene, fault),
                            fault_advice(found.scene, fault));
    return list;
}

StatedRoom stated_room(const std::string& name, const Vec2& low, const Vec2& high, double floor_m) {
    StatedRoom room;
    room.name = name;
    room.rings = {{low, {high.x, low.y}, high, {low.x, high.y}}};
    room.floor_m = floor_m;
    room.height_m = 2.5;
    room.at_m = Vec3(0.5 * (low + high), floor_m);
    room.area_m2 = (high.x - low.x) * (high.y - low.y);
    room.source.line = 7;
    return room;
}

struct Planted {
    const char* what;
    FaultKind kind;
    const char* name;  // text that must be part of the message
    std::function<MapCopy(MapCopy)> plant;
    std::function<void(Scene&, const RoomGraph&)> state = {};
};

void PrintTo(const Planted& planted, std::ostream* out) { *out << planted.what; }

// Room 5 extends from 0 to 7.5 m east and from 11.1 to 19 m north on the ground floor. Its door is at 5.5 m east, in
// the wall at 11 m, and opens to the corridor south of it. 32 units are one metre.
const std::vector<Planted> kPlanted{
    {"a room without a name", FaultKind::UnnamedRoom, "has no name",
     [](MapCopy map) { return map.remove("info_room", "Room 2"); }},
    {"a hall without a name", FaultKind::UnnamedRoom, "has no name",
     [](MapCopy map) { return map.remove("info_room", "Library"); }},
    {"a room upstairs without a name", FaultKind::UnnamedRoom, "has no name",
     [](MapCopy map) { return map.remove("info_room", "Music room"); }},
    {"a door that is a wall", FaultKind::RoomOutOfReach, "Room 5",
     [](MapCopy map) {
         return map.replace("func_door", "Room 5 door", "\"classname\" \"func_door\"", "\"classname\" \"func_wall\"");
     }},
    {"a door upstairs that is a wall", FaultKind::RoomOutOfReach, "Room 8",
     [](MapCopy map) {
         return map.replace("func_door", "Room 8 door", "\"classname\" \"func_door\"", "\"classname\" \"func_wall\"");
     }},
    {"a doorway walled up before its door", FaultKind::RoomOutOfReach, "Room 5",
     [](MapCopy map) { return map.add(wall(test::box_brush(160, 353, 0, 192, 358, 67))); }},
    {"a cupboard before a door", FaultKind::ImpassableDoor, "Cupboard stands in the way",
     [](MapCopy map) { return map.add(thing("Cupboard", test::box_brush(150, 354, 0, 202, 370, 64))); }},
    {"a doorway half walled up", FaultKind::ImpassableDoor, "nobody can get through",
     [](MapCopy map) { return map.add(wall(test::box_brush(160, 349, 0, 180, 355, 67))); }},
    {"a door with a bar across it", FaultKind::ImpassableDoor, "nobody can get through",
     [](MapCopy map) { return map.add(wall(test::box_brush(150, 345, 28, 202, 350, 32))); }},
    {"a doorway too low", FaultKind::ImpassableDoor, "Room 5 door",
     [](MapCopy map) { return map.add(wall(test::box_brush(158, 349, 48, 194, 355, 68))); }},
    {"a door in the yard", FaultKind::DoorOnNoWall, "Lost door",
     [](MapCopy map) {
         return map.add(test::entity("func_door", test::key("name", "Lost door") + test::key("angle", "90"),
                                     test::box_brush(300, -200, 0, 332, -198, 67)));
     }},
    {"a door beside its wall", FaultKind::DoorOnNoWall, "Lost door",
     [](MapCopy map) {
         return map.add(test::entity("func_door", test::key("name", "Lost door") + test::key("angle", "90"),
                                     test::box_brush(60, 480, 0, 92, 482, 67)));
     }},
    {"a door that closes at nothing", FaultKind::DoorOnNoWall, "Lost door",
     [](MapCopy map) {
         return map.add(test::entity("func_door", test::key("name", "Lost door") + test::key("angle", "90"),
                                     test::box_brush(204, 480, 0, 236, 482, 67)));
     }},
    {"a door through the ceiling", FaultKind::DoorOverLevels, "Room 5 door",
     [](MapCopy map) { return map.replace("func_door", "Room 5 door", " 67.2 )", " 170 )"); }},
    {"another one", FaultKind::DoorOverLevels, "Room 1 door",
     [](MapCopy map) { return map.replace("func_door", "Room 1 door", " 67.2 )", " 180 )"); }},
    {"a crack between two walls", FaultKind::Crack, "1.9 centimetres",
     [](MapCopy map) {
         return map.add(
             wall(test::box_brush(300, -220, 0, 340, -210, 60) + test::box_brush(340.6, -220, 0, 380, -210, 60)));
     }},
    {"a crack as wide as fingers", FaultKind::Crack, "5 centimetres",
     [](MapCopy map) {
         return map.add(wall(test::box_brush(60, 470, 0, 90, 474, 40) + test::box_brush(91.6, 470, 0, 120, 474, 40)));
     }},
    {"a crack under a wall", FaultKind::Crack, "2.5 centimetres",
     [](MapCopy map) { return map.add(wall(test::box_brush(60, 470, 0.8, 120, 474, 40))); }},
    {"a yard without its fence", FaultKind::FloorEnds, "Yard: the floor ends",
     [](MapCopy map) { return map.remove_brush("( -256 -390.4 0 ) ( -262.4 -390.4 0 )"); }},
    {"a balcony without a rail", FaultKind::UnguardedDrop, "there is a drop",
     [](MapCopy map) {
         return map.add(
             wall(test::box_brush(300, -220, 0, 348, -172, 48) + test::box_brush(300, -172, 0, 348, -164, 40) +
                  test::box_brush(300, -164, 0, 348, -156, 32) + test::box_brush(300, -156, 0, 348, -148, 24) +
                  test::box_brush(300, -148, 0, 348, -140, 16) + test::box_brush(300, -140, 0, 348, -132, 8)));
     }},
    {"two names in one room", FaultKind::OverlappingRooms, "Study",
     [](MapCopy map) {
         return map.add(test::entity("info_room", test::key("name", "Study") + test::key("origin", "120 460 24")));
     }},
    {"two stated rooms over each other", FaultKind::OverlappingRooms, "Study", [](MapCopy map) { return map; },
     [](Scene& scene, const RoomGraph&) {
         auto stated = std::make_shared<StatedBuilding>();
         stated->rooms = {stated_room("Room 5", {0.0, 11.2}, {7.3, 18.8}, 0.0),
                          stated_room("Study", {6.0, 11.2}, {13.0, 18.8}, 0.0)};
         scene.stated = stated;
     }},
    {"an outline that crosses itself", FaultKind::CrossingOutline, "Room 5", [](MapCopy map) { return map; },
     [](Scene& scene, const RoomGraph&) {
         auto stated = std::make_shared<StatedBuilding>();
         stated->rooms = {stated_room("Room 5", {0.0, 11.2}, {7.3, 18.8}, 0.0)};
         std::swap(stated->rooms[0].rings[0][1], stated->rooms[0].rings[0][2]);
         scene.stated = stated;
     }},
    {"a door of the file where a wall is", FaultKind::UnlikeFile, "Room 5 and Study", [](MapCopy map) { return map; },
     [](Scene& scene, const RoomGraph& graph) {
         auto stated = std::make_shared<StatedBuilding>();
         stated->rooms = {stated_room("Room 5", {0.0, 11.2}, {7.3, 18.8}, 0.0), {}};
         for (const Room& room : graph.rooms)
             if (room.name == "Library")
                 stated->rooms[1] =
                     stated_room("Study", Vec2(room.middle_m) - 0.5, Vec2(room.middle_m) + 0.5, room.floor_m);
         StatedPortal door;
         door.name = "forgotten door";
         door.rooms = {0, 1};
         door.place_m = {7.5, 15.0, 0.0};
         door.source.line = 9;
         stated->portals.push_back(door);
         scene.stated = stated;
     }},
    {"materials that feel alike", FaultKind::AlikeMaterials, "cannot be told apart",
     [](MapCopy map) {
         return map
             .replace("thing", "Piano", "\"material\" \"wood\"",
                      "\"material\" \"metal\"\n\"stiffness\" \"0.9\"\n\"friction\" \"0.15\"")
             .add(
                 thing("Slab", test::box_brush(60, 480, 0, 80, 500, 30),
                       test::key("material", "glass") + test::key("stiffness", "0.9") + test::key("friction", "0.15")));
     }},
    {"a room without a landmark", FaultKind::NoLandmark, "Girls' toilet",
     [](MapCopy map) { return map.replace("thing", "Girls' wash basin", "\"landmark\" \"1\"\n", ""); }},
    {"a table far away", FaultKind::ThingOutside, "Lost table",
     [](MapCopy map) { return map.add(thing("Lost table", test::box_brush(3000, 0, 0, 3040, 40, 24))); }},
    {"a table above the roof", FaultKind::ThingOutside, "Lost table",
     [](MapCopy map) { return map.add(thing("Lost table", test::box_brush(100, 400, 900, 140, 440, 924))); }},
    {"a piano twice", FaultKind::ThingTwice, "Piano", [](MapCopy map) { return map.repeat("thing", "Piano"); }},
    {"a box under the floor", FaultKind::ThingBuried, "Lost box",
     [](MapCopy map) { return map.add(thing("Lost box", test::box_brush(100, 400, -60, 120, 420, -40))); }},
    {"a box in a floor", FaultKind::ThingBuried, "Lost box",
     [](MapCopy map) { return map.add(thing("Lost box", test::box_brush(100, 400, -10, 120, 420, -4))); }},
    {"a lamp that hangs in the air", FaultKind::ThingInTheAir, "Lost lamp",
     [](MapCopy map) { return map.add(thing("Lost lamp", test::box_brush(100, 480, 50, 110, 490, 60))); }},
    {"a start within a wall", FaultKind::StartLost, "stand at the start",
     [](MapCopy map) { return map.add(test::entity("info_player_coop", test::key("origin", "3000 0 24"))); }},
    {"a wall that is no solid", FaultKind::DamagedInFile, "",
     [](MapCopy map) { return map.add(wall("{\n( 0 0 0 ) ( 0 0 0 ) ( 0 0 0 ) plain 0 0 0 1 1\n}\n")); }},
    {"a house without a floor", FaultKind::NowhereToStand, "no floor",
     [](MapCopy) {
         return MapCopy(test::entity("worldspawn", test::key("building", "1"), test::box_brush(0, 0, 0, 10, 10, 300)) +
                        test::entity("info_player_start", test::key("origin", "500 0 24")));
     }},
};

TEST(CheckedSchool, has_no_faults) {
    const Found found = faults_of(school());
    EXPECT_TRUE(found.faults.empty()) << listed(found);
}

class CopyOfTheSchool : public testing::TestWithParam<Planted> {};

TEST_P(CopyOfTheSchool, gets_a_report_of_its_planted_fault_with_place_and_advice) {
    const Planted& planted = GetParam();
    const Found found = faults_of(planted.plant(MapCopy(school())).text(), planted.state);
    const auto fault = std::find_if(found.faults.begin(), found.faults.end(), [&](const WorldFault& one) {
        return one.kind == planted.kind && fault_words(found.scene, one).find(planted.name) != std::string::npos;
    });
    ASSERT_NE(fault, found.faults.end()) << listed(found);
    EXPECT_FALSE(fault_advice(found.scene, *fault).empty());
    if (planted.kind != FaultKind::NowhereToStand) {
        EXPECT_GT(fault->source.line, 0) << listed(found);
    }
    // The check may report no fault that is unrelated to the planted one. It may report consequences of the planted
    // fault, but only a few.
    EXPECT_LE(found.faults.size(), planted.state ? 60U : 6U) << listed(found);
}

// Counts the faults of kind `kind` in the scene.
std::size_t count_in(test::SceneBuilder& b, FaultKind kind) {
    const auto scene = b.share();
    const auto ways = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    EXPECT_TRUE(ways);
    const RoomGraph graph = make_rooms(*scene, (*ways)->space());
    const std::vector<WorldFault> faults = find_faults(*scene, &(*ways)->space(), &graph);
    return static_cast<std::size_t>(
        std::count_if(faults.begin(), faults.end(), [&](const WorldFault& fault) { return fault.kind == kind; }));
}

// Counts the faults of kind `kind` in a small room. The room's wall begins `joint_m` above the floor. One start is in
// the air in the upper storey. If `before_door` is true, that start belongs to a door.
std::size_t count_of(FaultKind kind, double joint_m, bool before_door) {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {8, 6, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({0, 2.8, joint_m}, {4, 3.2, 2.5}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    for (Feature& feature : b.scene().features) feature.made_name = true;
    b.start({2, 1, 0}, 0.0);
    b.start({2, 8, 3}, 0.0);
    b.scene().starts.back().source.line = 7;
    StatedBuilding stated;
    StatedPortal portal;
    portal.source.line = before_door ? 7 : 8;
    stated.portals.push_back(portal);
    b.scene().stated = std::make_shared<const StatedBuilding>(stated);
    return count_in(b, kind);
}

TEST(NoFault, is_reported_for_a_start_at_a_balcony_door_or_a_narrow_gap_under_a_beam) {
    EXPECT_EQ(count_of(FaultKind::StartLost, 0.03, true), 0U);
    EXPECT_EQ(count_of(FaultKind::StartLost, 0.03, false), 1U) << "nobody stands where its author put it";
    EXPECT_EQ(count_of(FaultKind::Crack, 0.015, true), 0U);
    EXPECT_EQ(count_of(FaultKind::Crack, 0.03, true), 1U);
}

// Counts the cracks between a wall and another part. The other part has the generated name `what` and is `joint_m` away
// from the wall.
std::size_t cracks_beside(const char* what, double joint_m) {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {8, 6, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({0, 2.8, 0}, {4, 3.2, 2.5}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({4 + joint_m, 2.8, 2.2}, {8, 3.2, 2.5}, what);
    for (Feature& feature : b.scene().features) feature.made_name = true;
    b.start({2, 1, 0}, 0.0);
    return count_in(b, FaultKind::Crack);
}

// Counts the impassable doors of a building whose upper storey has a room of 8 by 6 metres at a height of 3 metres. A
// door that nobody can get through leads from it to a balcony of this depth.
std::size_t impassable_balcony_doors(double depth_m) {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {8, 6, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({0, 0, 2.8}, {8, 6, 3}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({0, 6, 2.8}, {8, 6 + depth_m, 3}, "balcony", SolidRole::Solid, {}, FeatureKind::Floor);
    b.box({0, 5.9, 3}, {8, 6, 5.5}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({0, 6 + depth_m, 3}, {8, 6.02 + depth_m, 4}, "railing", SolidRole::Solid, {}, FeatureKind::Object);
    b.start({2, 1, 0}, 0.0);
    b.start({2, 1, 3}, 0.0);
    b.start({2, 6 + 0.5 * depth_m, 3}, 0.0);
    StatedBuilding stated;
    StatedRoom room;
    room.name = "Bedroom";
    room.rings = {{{0.0, 0.0}, {8.0, 0.0}, {8.0, 5.9}, {0.0, 5.9}}};
    room.floor_m = 3.0;
    room.height_m = 2.5;
    room.at_m = {4.0, 3.0, 3.0};
    stated.rooms.push_back(room);
    StatedPortal portal;
    portal.name = "Balcony door";
    portal.rooms = {0};
    portal.place_m = {4.0, 5.95, 3.0};
    portal.width_m = 1.0;
    portal.passable = false;
    stated.portals.push_back(portal);
    b.scene().stated = std::make_shared<const StatedBuilding>(stated);
    return count_in(b, FaultKind::ImpassableDoor);
}

TEST(NoFault, is_reported_for_a_door_to_a_balcony_on_which_nobody_can_stand) {
    EXPECT_EQ(impassable_balcony_doors(0.25), 0U);
    EXPECT_EQ(impassable_balcony_doors(1.5), 1U) << "people want to go there";
}

TEST(NoFault, is_reported_for_a_narrow_gap_next_to_a_beam) {
    EXPECT_EQ(cracks_beside("beam", 0.015), 0U);
    EXPECT_EQ(cracks_beside("beam", 0.03), 1U);
    EXPECT_EQ(cracks_beside("stairs", 0.015), 1U);
}

std::vector<Planted> planted_here() {
    std::vector<Planted> some;
    for (std::size_t i = 0; i < kPlanted.size(); ++i)
        if (test::tried(i, 5)) some.push_back(kPlanted[i]);
    return some;
}

INSTANTIATE_TEST_SUITE_P(Planted, CopyOfTheSchool, testing::ValuesIn(planted_here()));

TEST(CopyOfTheSchool, has_at_least_thirty_planted_faults) { EXPECT_GE(kPlanted.size(), 30U); }

TEST(CopyOfTheSchool, has_a_half_blocked_doorway_that_can_be_cut_free) {
    const Found found = faults_of(MapCopy(school())
                                      .add(wall(test::box_brush(160, 349, 0, 180, 355, 67)))
                                      .add(wall(test::box_brush(180, 349, 48, 194, 355, 68)))
                                      .text());
    const auto fault = std::find_if(found.faults.begin(), found.faults.end(),
                                    [](const WorldFault& one) { return one.kind == FaultKind::ImpassableDoor; });
    ASSERT_NE(fault, found.faults.end()) << listed(found);
    const std::optional<MadeDoor> door = doorway_cut_free(found.scene, *fault);
    ASSERT_TRUE(door.has_value());
    const Scene mended = with_made_doors(found.scene, std::vector{*door});
    const auto navigation = Navigation::make(mended, walker_measures(mended, 0.25, 1.8, 0.25));
    ASSERT_TRUE(navigation.has_value());
    const RoomGraph graph = make_rooms(mended, (*navigation)->space());
    const std::vector<WorldFault> left = find_faults(mended, &(*navigation)->space(), &graph);
    EXPECT_TRUE(std::none_of(left.begin(), left.end(), [](const WorldFault& one) { return blocks(one); }));
}

TEST(WorldFaults, have_a_sentence_and_advice_in_each_language) {
    for (const LanguageName& language : bundled_languages()) {
        ASSERT_TRUE(speak_language(language.code));
        for (std::uint8_t k = 0; k <= static_cast<std::uint8_t>(FaultKind::NoLandmark); ++k) {
            const auto kind = static_cast<FaultKind>(k);
            const std::string word(row_of(kind).word);
            EXPECT_TRUE(has_phrase("world_fault_do." + word)) << language.code << " " << word;
            if (kind != FaultKind::AlikeMaterials && kind != FaultKind::DamagedInFile) {
                EXPECT_TRUE(has_phrase("world_fault." + word)) << language.code << " " << word;
            }
        }
    }
    ASSERT_TRUE(speak_language("en"));
}

struct Outcome {
    int status = -1;
    std::string out, err;
};
Outcome check(const std::filesystem::path& world, bool json) {
    CheckArguments arguments;
    arguments.world = world;
    arguments.json = json;
    std::ostringstream out, err;
    const int status = run_check(arguments, out, err);
    return {status, out.str(), err.str()};
}

TEST(CheckCommand, exits_with_0_if_nothing_blocks_the_way_and_with_1_otherwise) {
    const test::TemporaryFolder folder;
    const Outcome good = check(test::bundled_world("school.map"), false);
    EXPECT_EQ(good.status, 0);
    EXPECT_EQ(good.out, "School, from school.map: no problems.\n");
    const Outcome unnamed =
        check(folder.write("unnamed.map", MapCopy(school()).remove("info_room", "Library").text()), false);
    EXPECT_EQ(unnamed.status, 0);
    EXPECT_THAT(unnamed.out, testing::HasSubstr("one problem."));
    const Outcome walled =
        check(folder.write("walled.map",
                           MapCopy(school()).replace("func_door", "Room 5 door", "func_door", "func_wall").text()),
              true);
    EXPECT_EQ(walled.status, 1);
    const nlohmann::json json = nlohmann::json::parse(walled.out);
    EXPECT_EQ(json["blocking"], 1);
    ASSERT_FALSE(json["faults"].empty());
    EXPECT_EQ(json["faults"][0]["kind"], "room_out_of_reach");
    EXPECT_EQ(json["faults"][0]["blocks"], true);
    EXPECT_EQ(json["faults"][0]["file"], "walled.map");
    EXPECT_GT(json["faults"][0]["line"], 0);
    EXPECT_EQ(json["faults"][0]["at_m"].size(), 3U);
    EXPECT_THAT(json["faults"][0]["do"], testing::HasSubstr("door"));
    EXPECT_EQ(check(folder.path() / "none.map", false).status, 1);
}

TEST(CheckCommand, suggests_possible_landmarks) {
    const Found found =
        faults_of(MapCopy(school()).replace("thing", "Girls' wash basin", "\"landmark\" \"1\"\n", "").text());
    ASSERT_EQ(found.faults.size(), 1U) << listed(found);
    ASSERT_FALSE(found.faults[0].candidates.empty());
    EXPECT_EQ(found.scene.features[found.faults[0].candidates[0].value].name, "Girls' wash basin");
    EXPECT_THAT(fault_advice(found.scene, found.faults[0]), testing::HasSubstr("such as Girls' wash basin"));
}

}  // namespace planted_faults_test
}  // namespace handrail
