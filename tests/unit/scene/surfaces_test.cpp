#include "worlds/scene/surfaces.h"

#include <random>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "worlds/geometry/clip.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace surfaces_test {

using test::box_brush;
using test::entity;
using test::key;
using testing::UnorderedElementsAre;

Scene read(const std::string& text) {
    Result<Scene> scene = read_quake_map(text, "test.map");
    EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().sentence());
    if (!scene) return {};
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << (valid ? "" : valid.error().sentence());
    EXPECT_EQ(scene->report.warnings_in_all, 0);
    return std::move(*scene);
}

Scene building(const std::string& brushes) { return read(entity("worldspawn", {}, brushes)); }

std::vector<std::string> names(const Scene& scene) {
    std::vector<std::string> all;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i) all.push_back(spoken_name(scene, {i}));
    return all;
}

const Feature& feature(const Scene& scene, const std::string& name) {
    for (const Feature& candidate : scene.features)
        if (candidate.name == name) return candidate;
    ADD_FAILURE() << "no " << name;
    static const Feature kNone;
    return kNone;
}

// Returns the name of the first face that a hand meets between `from_m` and `to_m`.
std::string met(const Scene& scene, const Vec3& from_m, const Vec3& to_m) {
    double nearest = 2.0;
    std::string name = "nothing";
    for (const Solid& solid : scene.solids) {
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover) continue;
        double enter = -1.0, leave = 1.0;
        std::size_t face = 0;
        for (std::size_t i = 0; i < solid.shape.planes.size(); ++i) {
            const double a = signed_distance(solid.shape.planes[i], from_m),
                         b = signed_distance(solid.shape.planes[i], to_m);
            if (a > 0.0 && b > 0.0) enter = 9.0;
            else if (a > 0.0 && a / (a - b) > enter) enter = a / (a - b), face = i;
            else if (b > 0.0) leave = std::min(leave, a / (a - b));
        }
        if (enter < 0.0 || enter > leave || enter >= nearest) continue;
        nearest = enter;
        name = spoken_name(scene, solid.face_features[face]);
    }
    return name;
}

const std::string kRoom = test::room_brushes(0, 0, 0, 256, 192, 96);  // a room of 8 x 6 x 3 m

TEST(Surfaces, of_a_closed_room_are_four_walls_floor_and_ceiling_inside_and_outside) {
    const Scene scene = building(kRoom);
    EXPECT_THAT(names(scene),
                UnorderedElementsAre("north wall", "east wall", "south wall", "west wall", "floor", "ceiling"));
    EXPECT_NEAR(feature(scene, "north wall").area_m2, 24.0, 1e-9);
    EXPECT_NEAR(feature(scene, "floor").area_m2, 48.0, 1e-9);
    EXPECT_EQ(feature(scene, "north wall").normal, Vec3(0, -1, 0))
        << "it faces south, towards whoever stands in the room";
    const Vec3 middle{4, 3, 1.5};
    EXPECT_EQ(met(scene, middle, {4, 9, 1.5}), "north wall");
    EXPECT_EQ(met(scene, middle, {9, 3, 1.5}), "east wall");
    EXPECT_EQ(met(scene, middle, {4, 3, -2}), "floor");
    EXPECT_EQ(met(scene, {4, 9, 1.5}, middle), "north wall") << "its outer side is the same wall";
    EXPECT_EQ(met(scene, {4, 3, 9}, middle), "ceiling");
}

// An L-shaped room must have six walls, a floor and a ceiling.
TEST(Surfaces, of_an_l_shaped_room_include_six_walls) {
    const Scene scene = building(box_brush(-16, -16, -16, 272, 272, 0) + box_brush(-16, -16, 96, 272, 272, 112) +
                                 box_brush(-16, -16, 0, 0, 272, 96) + box_brush(0, -16, 0, 272, 0, 96) +
                                 box_brush(256, 0, 0, 272, 144, 96) + box_brush(128, 128, 0, 256, 144, 96) +
                                 box_brush(128, 144, 0, 144, 272, 96) + box_brush(0, 256, 0, 128, 272, 96));
    EXPECT_THAT(names(scene), UnorderedElementsAre("north wall", "north wall", "east wall", "east wall", "south wall",
                                                   "west wall", "floor", "ceiling"));
    EXPECT_EQ(met(scene, {6, 2, 1}, {6, 20, 1}), "north wall");
    EXPECT_EQ(met(scene, {2, 6, 1}, {20, 6, 1}), "east wall");
}

TEST(Surfaces, of_a_wall_made_of_five_brushes_form_one_wall) {
    std::string pieces;
    for (int i = 0; i < 4; ++i) pieces += box_brush(64 * i, 192, 0, 64 * i + 64, 208, i == 1 ? 32 : 96);
    pieces += box_brush(64, 192, 32, 128, 208, 96);  // a piece that meets the others in T-junctions
    const Scene scene = building(box_brush(-16, -16, -16, 272, 208, 0) + box_brush(-16, -16, 96, 272, 208, 112) +
                                 box_brush(-16, -16, 0, 0, 208, 96) + box_brush(256, -16, 0, 272, 208, 96) +
                                 box_brush(0, -16, 0, 256, 0, 96) + pieces);
    EXPECT_THAT(names(scene),
                UnorderedElementsAre("north wall", "east wall", "south wall", "west wall", "floor", "ceiling"));
    EXPECT_NEAR(feature(scene, "north wall").area_m2, 24.0, 1e-9);
}

TEST(Surfaces, of_another_material_form_a_separate_wall) {
    const std::string half = box_brush(0, 192, 0, 128, 208, 96, "brick1") +
                             box_brush(128, 192, 0, 256, 208, 96, "brick2") +
                             box_brush(256, 192, 0, 384, 208, 96, "wood1");
    const Scene scene = building(half);
    EXPECT_THAT(names(scene), testing::IsSupersetOf({"north wall, brick", "north wall, wood"}));
    EXPECT_NEAR(feature(scene, "north wall").area_m2, 24.0, 1e-9);
    EXPECT_THAT(scene.report.guessed,
                testing::Contains("The material brick was guessed from the texture names brick1, brick2."));
}

TEST(Surfaces, of_small_free_standing_brushes_form_a_thing) {
    const Scene scene = building(kRoom + box_brush(112, 80, 0, 128, 96, 96) + box_brush(32, 32, 0, 64, 64, 16) +
                                 box_brush(192, 96, 0, 224, 128, 30));
    EXPECT_THAT(names(scene), UnorderedElementsAre("north wall", "east wall", "south wall", "west wall", "floor",
                                                   "ceiling", "pillar", "low block", "block"));
    EXPECT_EQ(met(scene, {4, 1, 0.2}, {1.5, 1.5, 0.2}), "low block");
    EXPECT_EQ(feature(scene, "pillar").kind, FeatureKind::Object);
    EXPECT_NEAR(feature(scene, "low block").area_m2, 1.0 + 4 * 0.5, 1e-9)
        << "four sides and the top; it stands on its bottom";
}

// A wall crosses the room and has a doorway near its end. The short rest of the wall and the piece above the doorway
// each show three sides.
TEST(Surfaces, of_short_pieces_next_to_a_doorway_belong_to_their_wall) {
    const std::string wall = box_brush(128, 64, 0, 136, 192, 96) + box_brush(128, 32, 70, 136, 64, 96);
    for (const std::string& piece : {std::string(), box_brush(128, 20, 0, 136, 32, 96)}) {
        const Scene scene = building(kRoom + wall + piece);
        for (const Feature& each : scene.features)
            EXPECT_EQ(each.kind == FeatureKind::Object ? each.name : std::string(), std::string());
        EXPECT_EQ(met(scene, {1, 1.5, 2.5}, {4.1, 1.5, 2.5}), met(scene, {1, 3, 1.5}, {4.1, 3, 1.5}));
    }
}

TEST(Surfaces, of_treads_and_risers_are_called_steps) {
    std::string stairs;
    for (int i = 0; i < 3; ++i)
        // Each step is 0.3 m deep and 0.19 m high. The last step is a platform.
        stairs += box_brush(64 + 10 * i, 0, 0, 256, 192, 6 * (i + 1));
    const Scene scene = building(kRoom + stairs);
    const std::vector<std::string> all = names(scene);
    EXPECT_EQ(std::count(all.begin(), all.end(), "step"), 2);
    EXPECT_EQ(std::count(all.begin(), all.end(), "floor"), 2) << "the room's and the platform's";
    EXPECT_EQ(met(scene, {2.2, 3, 2}, {2.2, 3, -1}), "step");
}

TEST(Surfaces, of_slanted_walls_and_slopes_are_named_by_their_side) {
    // A wall runs across the north-east corner, and a ramp rises to the north.
    const std::string corner =
        "{\n( 256 128 0 ) ( 192 192 0 ) ( 256 128 96 ) plain 0 0 0 1 1\n( 256 0 0 ) ( 256 0 96 ) ( 256 192 0 ) plain 0 "
        "0 0 1 1\n( 0 192 0 ) ( 256 192 0 ) ( 0 "
        "192 96 ) plain 0 0 0 1 1\n"
        "( 0 0 0 ) ( 256 0 0 ) ( 0 192 0 ) plain 0 0 0 1 1\n( 0 0 96 ) ( 0 192 96 ) ( 256 0 96 ) plain 0 0 0 1 1\n}\n";
    const std::string ramp =
        "{\n( 0 32 0 ) ( 0 160 64 ) ( 64 32 0 ) plain 0 0 0 1 1\n( 0 0 0 ) ( 0 192 0 ) ( 0 0 96 ) plain 0 0 0 1 1\n( "
        "64 0 0 ) ( 64 0 96 ) ( 64 192 0 ) plain 0 "
        "0 0 1 1\n"
        "( 0 160 0 ) ( 64 160 0 ) ( 0 160 96 ) plain 0 0 0 1 1\n( 0 0 0 ) ( 256 0 0 ) ( 0 192 0 ) plain 0 0 0 1 1\n}\n";
    const Scene scene = building(kRoom + corner + ramp);
    EXPECT_THAT(names(scene), testing::IsSupersetOf({"north-east wall", "slope rising north"}));
    EXPECT_EQ(met(scene, {6, 3, 1}, {8, 6, 1}), "north-east wall");
    EXPECT_EQ(compass_word(Vec3{1, 1, 0}), "north-east");
    EXPECT_EQ(compass_word(Vec3{-1, -0.1, 0}), "west");
    EXPECT_EQ(compass_word(Vec3{0.4, -1, 0}), "south");
    EXPECT_EQ(compass_word(0.0), "north");
    EXPECT_EQ(compass_word(radians_from_degrees(44.0)), "north-east");
    EXPECT_EQ(compass_word(radians_from_degrees(-90.0)), "west");
    EXPECT_EQ(compass_word(radians_from_degrees(360.0 * 5 + 180.0)), "south");
}

TEST(Surfaces, of_the_brushes_of_one_entity_form_one_named_thing) {
    const std::string table =
        box_brush(96, 80, 0, 100, 84, 24) + box_brush(140, 80, 0, 144, 84, 24) + box_brush(92, 76, 24, 148, 100, 28);
    const Scene scene =
        read(entity("worldspawn", {}, kRoom) +
             entity("func_group", key("name", "Table") + key("material", "wood") + key("landmark", "1"), table));
    EXPECT_EQ(scene.features.size(), 7U);
    const Feature& found = feature(scene, "Table");
    EXPECT_TRUE(found.landmark);
    EXPECT_FALSE(found.clue);
    EXPECT_EQ(met(scene, {4, 1, 0.8}, {4, 5, 0.8}), "Table, wood");
    EXPECT_EQ(met(scene, {3.06, 1, 0.2}, {3.06, 4, 0.2}), "Table, wood");
    EXPECT_TRUE(scene.report.guessed.empty()) << "the map said it is wood";
}

TEST(Surfaces, of_touching_liquid_brushes_form_one_pool) {
    const Scene scene =
        building(kRoom + box_brush(0, 0, 0, 64, 192, 16, "*water1") + box_brush(64, 0, 0, 128, 192, 16, "*water1") +
                 box_brush(192, 0, 0, 256, 192, 16, "*lava1"));
    const std::vector<std::string> all = names(scene);
    EXPECT_EQ(std::count(all.begin(), all.end(), "water"), 1);
    EXPECT_EQ(std::count(all.begin(), all.end(), "lava"), 1);
    EXPECT_EQ(scene.report.liquids, 3);
}

TEST(Surfaces, in_seams_and_hidden_faces_have_the_name_of_what_covers_them) {
    // This brush duplicates part of the north wall.
    const Scene scene = building(kRoom + box_brush(0, 192, 0, 64, 208, 96));
    EXPECT_EQ(scene.features.size(), 6U);
    for (const Solid& solid : scene.solids)
        for (const FeatureId id : solid.face_features) EXPECT_TRUE(static_cast<bool>(id));
}

TEST(Surfaces, do_not_depend_on_the_order_of_brushes_and_faces) {
    std::vector<std::string> brushes;
    for (std::size_t at = 0; at < kRoom.size();) {
        const std::size_t end = kRoom.find("}\n", at) + 2;
        brushes.push_back(kRoom.substr(at, end - at));
        at = end;
    }
    brushes.push_back(box_brush(112, 80, 0, 128, 96, 96));
    brushes.push_back(box_brush(0, 0, 0, 100, 64, 12, "wood1"));
    brushes.push_back(box_brush(100, 0, 0, 200, 64, 12, "wood1"));
    const auto summary = [&](const std::vector<std::string>& order) {
        std::string text;
        for (const std::string& brush : order) text += brush;
        const Scene scene = building(text);
        std::vector<std::string> lines;
        for (std::uint32_t i = 0; i < scene.features.size(); ++i) {
            const Feature& f = scene.features[i];
            lines.push_back(fmt::format("{} {:.6f} {:.6f} {:.6f} {:.6f}", spoken_name(scene, {i}), f.area_m2,
                                        f.bounds_m.min_m.x, f.bounds_m.max_m.y, f.bounds_m.max_m.z));
        }
        std::sort(lines.begin(), lines.end());
        return lines;
    };
    const std::vector<std::string> expected = summary(brushes);
    std::mt19937 random(5);
    for (int round = 0; round < 20; ++round) {
        std::shuffle(brushes.begin(), brushes.end(), random);
        for (std::string& brush : brushes) {  // rotates the order of each brush's faces by one place
            const std::size_t first = brush.find('(', 0), second = brush.find('\n', first) + 1, end = brush.rfind('}');
            brush = "{\n" + brush.substr(second, end - second) + brush.substr(first, second - first) + "}\n";
        }
        EXPECT_EQ(summary(brushes), expected);
    }
}

TEST(Surfaces, in_a_game_level_are_never_named_by_a_number_or_a_texture) {
    const auto ours = test::project_root() / "tests/scenarios/worlds/game_step.map";
    for (const auto& path : test::with_real_worlds(
             {ours}, {"quake-e1m1.map", "quake-start.map", "quake-dm3.map", "office.map", "house.map"})) {
        const Result<Scene> scene = read_world(path);
        ASSERT_TRUE(scene.has_value());
        ASSERT_FALSE(scene->features.empty()) << path;
        for (std::uint32_t i = 0; i < scene->features.size(); ++i) {
            const std::string spoken = spoken_name(*scene, {i});
            EXPECT_FALSE(spoken.empty());
            EXPECT_EQ(spoken.find_first_of("0123456789_+*{"), std::string::npos) << path << ": " << spoken;
        }
    }
}

TEST(SpokenName, puts_the_material_last_and_is_empty_for_unnamed_things) {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].name = "plaster";
    scene.features.resize(2);
    scene.features[0].name = "Table";
    scene.features[1].name = "north wall";
    scene.features[1].material = 1;
    EXPECT_EQ(spoken_name(scene, {0}), "Table");
    EXPECT_EQ(spoken_name(scene, {1}), "north wall, plaster");
    EXPECT_EQ(spoken_name(scene, kNoFeature), "");
}

TEST(Validate, finds_faults_in_a_scene) {
    const Scene good = building(kRoom);
    const auto broken = [&](const std::function<void(Scene&)>& damage) {
        Scene scene = good;
        damage(scene);
        return validate(scene).has_value();
    };
    EXPECT_TRUE(broken([](Scene&) {}));
    EXPECT_FALSE(broken([](Scene& s) { s.materials.clear(); }));
    EXPECT_FALSE(broken([](Scene& s) { s.features[0].name.clear(); }));
    EXPECT_FALSE(broken([](Scene& s) { s.features[0].material = 99; }));
    EXPECT_FALSE(broken([](Scene& s) { s.solids[0].face_features.pop_back(); }));
    EXPECT_FALSE(broken([](Scene& s) { s.solids[0].face_features[0] = {999}; }));
    EXPECT_FALSE(broken([](Scene& s) { s.solids[0].shape.planes[0].normal *= 2.0; }));
    EXPECT_FALSE(broken([](Scene& s) { s.solids[0].shape.faces[0].points_m[0].x = NAN; }));
    EXPECT_FALSE(broken([](Scene& s) { s.surfaces[0].polygon.points_m.resize(2); }));
    EXPECT_FALSE(broken([](Scene& s) { s.triangles.push_back({{NAN, 0, 0}, {}, {}}); }));
    EXPECT_FALSE(broken([](Scene& s) { s.starts.resize(1); }));
}

TEST(Materials, are_found_by_name_and_guessed_from_textures) {
    ASSERT_NE(find_material("Plaster"), nullptr);
    EXPECT_EQ(find_material("Plaster")->stiffness_fraction, 0.75);
    EXPECT_EQ(find_material("unobtainium"), nullptr);
    for (const MaterialSpec& spec : material_library()) {
        EXPECT_EQ(find_material(spec.name), &spec);
        EXPECT_GT(spec.stiffness_fraction, 0.0);
        EXPECT_LE(spec.stiffness_fraction, 1.0);
    }
    const auto guess = [](std::string_view texture) {
        return guess_material(texture) ? guess_material(texture)->name : std::string_view("none");
    };
    EXPECT_EQ(guess("SBRICK2A"), "brick");
    EXPECT_EQ(guess("base/wizwood1_4"), "wood");
    EXPECT_EQ(guess("+0slip"), "metal");
    EXPECT_EQ(guess("{grille_metal"), "steel grille");
    EXPECT_EQ(guess("plaster_white"), "plaster");
    EXPECT_EQ(guess("office_device"), "none") << "the ice in the middle of a word is no ice";
    EXPECT_EQ(guess("128"), "none");
}

}  // namespace surfaces_test
}  // namespace handrail
