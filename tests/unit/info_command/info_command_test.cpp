#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "app/main/commands.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace info_command_test {

struct Outcome {
    int status = -1;
    std::string out, err;
};

Outcome info(const std::filesystem::path& world, bool json, std::optional<double> scale = std::nullopt) {
    InfoArguments arguments;
    arguments.world = world;
    arguments.json = json;
    arguments.common.map_scale_m_per_unit = scale;
    std::ostringstream out, err;
    Outcome run;
    run.status = run_info(arguments, out, err);
    run.out = out.str();
    run.err = err.str();
    return run;
}

const std::string kMap = test::entity("worldspawn", test::key("message", "A small room"),
                                      test::room_brushes(0, 0, 0, 256, 192, 96, 16, "brick1") +
                                          test::box_brush(0, 0, 0, 64, 64, 8, "*water1") + "{\n}\n") +
                         test::entity("func_door", {}, test::box_brush(100, 192, 0, 132, 208, 64, "wood1")) +
                         test::entity("info_player_start", test::key("origin", "128 96 24"));

TEST(InfoCommand, lists_the_force_effects_in_space) {
    const std::string world = (test::project_root() / "tests/scenarios/worlds/every_property.map").string();
    EXPECT_THAT(
        info(world, false).out,
        testing::HasSubstr(
            "Forces in open space: magnet 4, detent 1, button 1, fly-paper 1, inertia 1, force 3, vibration 1."));
    EXPECT_EQ(nlohmann::json::parse(info(world, true).out)["effects"], 12);
}

TEST(InfoCommand, says_which_dense_meshes_are_felt_coarser_and_how_far_off_they_are) {
    const test::TemporaryFolder folder;
    std::string obj = "o globe\n";
    const TriangleMesh sphere = test::sphere_mesh(23, 0.5);
    for (const Vec3& p : sphere.points_m) obj += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const Corners& t : sphere.triangles) obj += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    const std::filesystem::path world = folder.write("globe.obj", obj);
    const nlohmann::json json = nlohmann::json::parse(info(world, true).out);
    EXPECT_LT(json["touch_model"]["triangles"], 10'580 / 4);
    EXPECT_THAT(
        json["simplified"].dump(),
        testing::ContainsRegex("Globe: felt with [0-9]+ of 10580 triangles, at most 0[.][0-9]+ millimetres off"));
    EXPECT_THAT(info(world, false).out, testing::HasSubstr("removed by making the mesh coarser"));
}

TEST(InfoCommand, prints_every_key_as_one_json_object) {
    const test::TemporaryFolder folder;
    const Outcome run = info(folder.write("room.map", kMap), true);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const nlohmann::json json = nlohmann::json::parse(run.out);
    for (const char* number : {"brushes",   "polygons",    "polygons_hidden",  "polygons_kept",
                               "triangles", "liquids",     "movers",           "starts",
                               "spaces",    "doors",       "windows",          "stairs",
                               "storeys",   "furnishings", "portals",          "largest_connected_spaces",
                               "features",  "openings",    "openings_cut",     "scale_m_per_unit",
                               "load_s",    "all_s",       "peak_memory_bytes"})
        EXPECT_TRUE(json.contains(number) && json[number].is_number()) << number;
    for (const char* list :
         {"materials", "guessed", "simplified", "left_out", "warnings", "bounds_min_m", "bounds_max_m"})
        EXPECT_TRUE(json.contains(list) && json[list].is_array()) << list;
    EXPECT_EQ(json["format"], "map");
    EXPECT_EQ(json["brushes"], 9);    // six walls, water, one empty brush, the door
    EXPECT_EQ(json["polygons"], 48);  // the polygons of eight boxes
    EXPECT_EQ(json["triangles"], 96);
    EXPECT_EQ(json["liquids"], 1);
    EXPECT_EQ(json["movers"], 1);
    EXPECT_EQ(json["doors"], 1);
    EXPECT_EQ(json["starts"], 1);
    EXPECT_EQ(json["features"], 8);  // four walls, floor, ceiling, water and door
    EXPECT_EQ(json["materials"], nlohmann::json({"brick", "wood"}));
    EXPECT_EQ(json["bounds_min_m"], nlohmann::json({-0.5, -0.5, -0.5}));
    EXPECT_EQ(json["scale_m_per_unit"], 1.0 / 32.0);
    EXPECT_EQ(json["guessed"].size(), 3U);  // the third one is about the rooms
    // The touch model contains the following. The list of stages that are off names those that this world does not
    // need.
    EXPECT_EQ(json["touch_model"]["boxes"], 7);  // six walls and the door; the water is no obstacle
    EXPECT_EQ(json["touch_model"]["brushes"], 0);
    EXPECT_EQ(json["touch_model"]["triangles"], 0);
    EXPECT_EQ(json["touch_model"]["bodies"], 1);  // the door, which is a separate body, as in a session
    EXPECT_EQ(json["touch_model"]["liquids"], 1);
    EXPECT_EQ(json["touch_model"]["liquids_with_drag"], 0);
    EXPECT_EQ(json["touch_model"]["magnets"], 0);
    EXPECT_EQ(json["touch_model"]["materials_with_friction"], 2);  // brick and wood
    EXPECT_THAT(json["touch_stages_on"].get<std::vector<std::string>>(), testing::IsSupersetOf({"liquids", "bodies"}));
    EXPECT_THAT(json["touch_stages_off"].get<std::vector<std::string>>(),
                testing::IsSupersetOf({"effects", "liquid surfaces"}));
    ASSERT_EQ(json["warnings"].size(), 1U);
    EXPECT_EQ(json["warnings"][0]["file"], "room.map");
    EXPECT_EQ(json["warnings"][0]["line"],
              60);  // class and message take three lines; seven boxes of eight lines each follow from line 4
    EXPECT_EQ(json["warnings"][0]["column"], 1);
    EXPECT_GT(json["peak_memory_bytes"].get<double>(), 1e5);
    EXPECT_GT(json["all_s"].get<double>(), json["load_s"].get<double>())
        << "rooms, ways and what is felt take time too";
    EXPECT_EQ(nlohmann::json::parse(info(folder.path() / "room.map", true, 0.01).out)["scale_m_per_unit"], 0.01);
}

TEST(InfoCommand, gives_the_same_facts_in_sentences) {
    const test::TemporaryFolder folder;
    const Outcome run = info(folder.write("room.map", kMap), false);
    EXPECT_EQ(run.status, 0);
    for (const char* said :
         {"A small room, from room.map.\n",
          "9 metres from west to east, 7 metres from south to north and 4 metres high",
          "The world contains 8 named things to touch, 1 door, 1 moving part, 1 liquid and 1 starting place.",
          "Materials: brick, wood.", "Modelled for touch: 7 boxes, 1 movable body, 1 liquid, 1 texture, 3 materials",
          "Not computed, because nothing here needs it: one-sided sheets, liquid surfaces, ",
          "The material brick was guessed",
          "1 problem:\n  room.map, line 60, column 1: warning: this brush has no faces. It was left out.", "Read in "})
        EXPECT_THAT(run.out, testing::HasSubstr(said));
}

TEST(InfoCommand, reports_how_exploring_changes_a_mesh) {
    const test::TemporaryFolder folder;
    // The world is a wall and a floor of four triangles. One of the triangles occurs twice.
    const std::filesystem::path file = folder.write(
        "hall.obj",
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 0\nv 0 0 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 1 2 5\nf 1 2 6\n");
    const nlohmann::json json = nlohmann::json::parse(info(file, true).out);
    EXPECT_EQ(json["triangles"], 6);
    EXPECT_EQ(json["simplified"],
              nlohmann::json({"One triangle that repeats another was left out.",
                              "4 triangles were merged into one flat polygon, at most 0 millimetres "
                              "out of plane (bound 0.01 millimetres)."}));
}

TEST(InfoCommand, counts_as_moving_only_things_that_can_go_somewhere) {
    const test::TemporaryFolder folder;
    // The first door is 64 units wide and slides by its width less the lip. The lip of the second door is as wide as
    // the door, so the door cannot move.
    const std::string world =
        test::entity("worldspawn", test::key("building", "0"), test::box_brush(0, 0, -8, 512, 512, 0));
    const std::string door = test::box_brush(100, 100, 0, 164, 108, 80);
    EXPECT_EQ(nlohmann::json::parse(
                  info(folder.write("a.map", world + test::entity("func_door", test::key("angle", "0"), door)), true)
                      .out)["movers"],
              1);
    EXPECT_EQ(
        nlohmann::json::parse(
            info(folder.write("b.map", world + test::entity("func_door",
                                                            test::key("angle", "0") + test::key("lip", "64"), door)),
                 true)
                .out)["movers"],
        0);
}

TEST(InfoCommand, counts_soft_sides) {
    const std::filesystem::path world = test::project_root() / "tests/scenarios/worlds/every_property.map";
    EXPECT_GT(nlohmann::json::parse(info(world, true).out)["touch_model"]["soft_sides"], 0);
}

TEST(InfoCommand, reports_which_edges_are_rounded_and_which_stay_sharp_and_why) {
    const test::TemporaryFolder folder;
    // A block of a metre, a plate of a centimetre, and two blocks whose ends meet in part, so that neither end covers
    // the other.
    const std::filesystem::path file = folder.write(
        "edges.map",
        test::entity("worldspawn", "", test::box_brush(0, 0, 0, 100, 100, 100)) +
            test::entity("func_wall", test::key("name", "Plate"), test::box_brush(300, 0, 0, 400, 100, 1)) +
            test::entity("func_wall", test::key("name", "Left"), test::box_brush(600, 0, 0, 700, 100, 100)) +
            test::entity("func_wall", test::key("name", "Right"), test::box_brush(700, 50, 0, 800, 150, 100)));
    const nlohmann::json json = nlohmann::json::parse(info(file, true, 0.01).out);
    EXPECT_EQ(json["touch_model"]["rounded_solids"], 1);
    EXPECT_EQ(json["simplified"],
              nlohmann::json({"Edges of 1 solid feel rounded, with a radius of 0.09 metres in the world.",
                              "1 solid keeps sharp edges: too thin to be rounded (Plate).",
                              "2 solids keep sharp edges: a groove would open where they join others (Left, Right)."}));
}

TEST(InfoCommand, lists_what_is_too_small_to_feel_at_a_scale_on_request) {
    const auto at = [](const std::string& scale) {
        InfoArguments arguments;
        arguments.world = test::project_root() / "worlds/maps/house.map";
        arguments.json = true;
        arguments.scale = scale;
        std::ostringstream out, err;
        const int status = run_info(arguments, out, err);
        return std::tuple(status, status == 0 ? nlohmann::json::parse(out.str())["simplified"] : nlohmann::json(),
                          err.str());
    };
    const auto [status, truly, nothing] = at("");
    EXPECT_EQ(status, 0);
    const nlohmann::json building = std::get<1>(at("Building"));
    EXPECT_THAT(building, testing::Contains("Front door: feels 1.7 metres wide but is really 1 metre."));
    EXPECT_THAT(building, testing::Contains("Coat stand: left out."));
    EXPECT_THAT(
        building,
        testing::Contains("Opening between Living room and Kitchen: feels 1.7 metres wide but is really 1.6 metres."));
    EXPECT_EQ(building.size(), truly.size() + 18) << "11 doors, an opening and 6 things";
    EXPECT_EQ(std::get<1>(at("60")).back(), "Globe's stand: left out.");
    EXPECT_TRUE(std::get<1>(at("detail")).empty()) << "edges are sharp at this scale, and nothing is left out";
    for (const char* wrong : {"large", "0", "-3", "1e9", "nan", "60 m"}) {
        EXPECT_EQ(std::get<0>(at(wrong)), 2) << wrong;
        EXPECT_THAT(std::get<2>(at(wrong)), testing::HasSubstr(wrong));
    }
}

TEST(InfoCommand, reports_rooms_that_cannot_be_reached_on_foot) {
    const test::TemporaryFolder folder;
    // A second room without a door is next to the first room. The map names the second room. It is empty at first; then
    // it contains a chest that the map's author placed.
    const std::string vault = test::entity("func_group", {}, test::room_brushes(300, 0, 0, 460, 192, 96, 16)) +
                              test::entity("info_room", test::key("name", "Vault") + test::key("origin", "380 96 24"));
    const std::string chest =
        test::entity("func_wall", test::key("name", "chest"), test::box_brush(320, 20, 0, 350, 50, 30));
    for (const std::string& within : {std::string(), chest}) {
        const auto path = folder.write("vault.map", kMap + vault + within);
        EXPECT_THAT(info(path, false).out, testing::HasSubstr("Vault cannot be reached on foot."));
        EXPECT_THAT(nlohmann::json::parse(info(path, true).out)["guessed"].dump(),
                    testing::HasSubstr("Vault cannot be reached on foot."));
    }
    for (const char* ours : {"house.map", "school.map", "first_room.map"})
        EXPECT_EQ(info(test::project_root() / "worlds/maps" / ours, false).out.find("on foot"), std::string::npos)
            << ours;
}

TEST(InfoCommand, fails_with_one_sentence_and_an_empty_standard_output) {
    const test::TemporaryFolder folder;
    for (const bool json : {false, true}) {
        const Outcome missing = info(folder.path() / "none.map", json);
        EXPECT_EQ(missing.status, 1);
        EXPECT_EQ(missing.out, "");
        EXPECT_EQ(missing.err, "none.map: This file cannot be opened: No such file or directory.\n");
        EXPECT_EQ(info(folder.write("empty.map", "{\n}\n"), json).status, 1);
    }
    EXPECT_EQ(info(folder.write("room.map", kMap), true, -1.0).status, 2);
}

TEST(InfoCommand, gives_the_same_counts_for_the_real_maps_as_an_independent_reader) {
    struct Expected {
        const char* file;
        int brushes, polygons, triangles, doors;
    };
    for (const Expected& expected :
         {Expected{"quake-e1m1.map", 1257, 7523, 15006, 21}, Expected{"quake-start.map", 1274, 7578, 14990, 5},
          Expected{"quake-dm3.map", 726, 4296, 8472, 0}, Expected{"office.map", 150, 896, 1784, 8},
          Expected{"agtut05.map", 199, 1135, 2150, 4}}) {
        const auto path = test::real_world(expected.file);
        if (!path) GTEST_SKIP() << test::needs_real_world(expected.file);
        const nlohmann::json json = nlohmann::json::parse(info(*path, true).out);
        EXPECT_EQ(json["brushes"], expected.brushes) << expected.file;
        EXPECT_EQ(json["polygons"], expected.polygons) << expected.file;
        EXPECT_EQ(json["triangles"], expected.triangles) << expected.file;
        EXPECT_EQ(json["doors"], expected.doors) << expected.file;
        EXPECT_EQ(json["warnings_in_all"], 0) << expected.file;
        // On these maps, between 16 and 43 percent of the surface is hidden, and about a third of the polygons.
        EXPECT_GT(json["polygons_hidden"].get<double>(), 0.2 * expected.polygons) << expected.file;
        EXPECT_EQ(json["polygons_hidden"].get<int>() + json["polygons_kept"].get<int>(), expected.polygons)
            << expected.file;
    }
}

TEST(InfoCommand, reports_honestly_what_it_understood_of_a_generated_office) {
    const test::TemporaryFolder folder;
    const test::OfficeIfc office = test::office_ifc({2, 1, 3});
    const nlohmann::json honesty =
        nlohmann::json::parse(info(folder.write("office.ifc", office.text), true).out)["honesty"];
    const nlohmann::json& understood = honesty["understood"];
    EXPECT_EQ(understood["rooms"], office.rooms);
    EXPECT_EQ(understood["doors"], office.doors);
    EXPECT_EQ(understood["windows"], office.windows);
    EXPECT_EQ(understood["stairs"], office.flights);
    EXPECT_EQ(honesty["doors_joining_two_rooms"], office.doors - 1) << "all but the front door";
    EXPECT_EQ(honesty["doors_of_one_room"], 1);
    EXPECT_EQ(honesty["openings_uncut"], 0);
    ASSERT_EQ(honesty["rooms_by_storey"].size(), 2U);
    EXPECT_EQ(honesty["rooms_by_storey"][1]["rooms"], office.rooms / 2);
}

TEST(InfoCommand, reports_honestly_what_it_understood_of_an_architects_model) {
    const auto duplex = test::real_world("duplex-apartment.ifc");
    if (!duplex) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    const nlohmann::json honesty = nlohmann::json::parse(info(*duplex, true).out)["honesty"];
    const nlohmann::json& understood = honesty["understood"];
    EXPECT_EQ(understood["rooms"], 21);
    EXPECT_EQ(understood["doors"], 14);
    EXPECT_EQ(understood["windows"], 24);
    EXPECT_EQ(understood["stairs"], 2);
    EXPECT_EQ(understood["furnishings"], 61);
    EXPECT_EQ(understood["landmarks"], 0);
    EXPECT_EQ(honesty["doors_joining_two_rooms"], 10);
    EXPECT_EQ(honesty["doors_of_one_room"], 4);
    EXPECT_EQ(honesty["openings_uncut"], 0);
    ASSERT_EQ(honesty["rooms_by_storey"].size(), 4U);
    EXPECT_EQ(honesty["rooms_by_storey"][1]["rooms"], 10);
    ASSERT_FALSE(honesty["check"].empty());
    EXPECT_EQ(honesty["check"][0]["kind"], "odd_name");
    EXPECT_EQ(honesty["check"][0]["what"], "Room B105 contains stairs, but its name does not say so");
    EXPECT_EQ(honesty["check"][0]["file"], "duplex-apartment.ifc");
    EXPECT_EQ(honesty["check"][0]["line"], 3533);
    EXPECT_THAT(
        info(*duplex, false).out,
        testing::HasSubstr(
            "21 rooms on 3 of 4 storeys, 14 doors, 24 windows and 2 flights of stairs. It also has 61 pieces of "
            "furniture and no landmarks. Check this first: Room B105 contains stairs"));
}

TEST(InfoCommand, gives_the_height_of_a_storey_in_metres_even_if_the_file_uses_millimetres) {
    const std::string worlds = (test::project_root() / "tests/unit/ifc/worlds/").string();
    const nlohmann::json metres = nlohmann::json::parse(info(worlds + "small_house.ifc", true).out)["honesty"],
                         millimetres =
                             nlohmann::json::parse(info(worlds + "small_house_millimetres.ifc", true).out)["honesty"];
    EXPECT_EQ(metres["sentence"], millimetres["sentence"]);
    EXPECT_EQ(metres["check"].size(), millimetres["check"].size());
    EXPECT_NEAR(millimetres["rooms_by_storey"][0]["floor_m"].get<double>(),
                metres["rooms_by_storey"][0]["floor_m"].get<double>(), 1e-9);
    const test::TemporaryFolder folder;
    EXPECT_TRUE(nlohmann::json::parse(info(folder.write("room.map", kMap), true).out)["honesty"].is_null())
        << "a .map states no rooms";
}

TEST(InfoCommand, exits_with_status_1_and_names_both_materials_if_they_feel_the_same) {
    const test::TemporaryFolder folder;
    const auto lint = [&](const std::string& wood_stiffness) {
        InfoArguments arguments;
        arguments.world = folder.write(
            "board.map",
            test::entity("func_wall", test::key("material", "wood") + wood_stiffness,
                         test::box_brush(0, 0, 0, 20, 4, 20)) +
                test::entity("func_wall", test::key("material", "rubber"), test::box_brush(32, 0, 0, 52, 4, 20)));
        arguments.lint = true;
        std::ostringstream out, err;
        const int status = run_info(arguments, out, err);
        EXPECT_EQ(err.str(), "");
        return std::pair(status, out.str());
    };
    EXPECT_EQ(lint(""), std::pair(0, std::string("All materials here can be told apart by touch.\n")));
    const auto [status, said] = lint(test::key("stiffness", "0.32"));
    EXPECT_EQ(status, 1);
    EXPECT_TRUE(said.starts_with("Wood and rubber cannot be told apart by touch:")) << said;
}

}  // namespace info_command_test
}  // namespace handrail
