// Tests things of a map that can move freely. The map declares them by the original's class names or by the key `free`.
// The reader must report faults of their keys with file and line, and load the rest.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/readers/reading.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace map_bodies_test {

using test::box_brush;
using test::entity;
using test::key;
using test::Reading;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kCube = box_brush(0, 0, 0, 32, 32, 32);  // a cubic metre
const std::string kFloor = box_brush(-320, -320, -32, 320, 320, 0);

Reading read(const std::string& entities) {
    return test::reading_of(read_quake_map(entity("worldspawn", {}, kFloor) + entities, "test.map"));
}
Reading thing(const std::string& keys, const std::string& brushes = kCube) {
    return read(entity("thing", key("name", "Crate") + keys, brushes));
}

TEST(MapBodies, of_the_original_programs_three_kinds_are_free_and_weigh_as_much_as_wood) {
    for (const char* kind : {"dynamic_box", "dynamic_sphere", "dynamic_cylinder"}) {
        const Reading reading = thing(key("cs_name", kind));
        EXPECT_THAT(reading.said, IsEmpty());
        ASSERT_EQ(reading.scene.bodies.size(), 1U) << kind;
        const double volume_m3 = kind == std::string("dynamic_box")      ? 1.0
                                 : kind == std::string("dynamic_sphere") ? 3.14159265358979 / 6.0
                                                                         : 3.14159265358979 / 4.0;
        const FreeBody& body = reading.scene.bodies[0];
        EXPECT_NEAR(body.mass_kg, 600.0 * volume_m3, 1e-6) << kind;
        EXPECT_TRUE(body.by_density);
        EXPECT_EQ(reading.scene.features[body.feature.value].name, "Crate");
        EXPECT_THAT(thing(key("cs_name", kind) + key("free", "0")).scene.bodies, IsEmpty()) << "fixed when it says so";
    }
}

TEST(MapBodies, an_entity_with_the_key_free_becomes_one_body_of_all_its_brushes) {
    const Reading reading = thing(key("free", "1") + key("density", "100"), kCube + box_brush(0, 0, 32, 32, 32, 64));
    EXPECT_THAT(reading.said, IsEmpty());
    ASSERT_EQ(reading.scene.bodies.size(), 1U);
    EXPECT_NEAR(reading.scene.bodies[0].mass_kg, 200.0, 1e-9);
    std::vector<int> thing_of_body;
    const Scene apart = with_bodies_apart(reading.scene, 100, thing_of_body);
    ASSERT_THAT(thing_of_body, ElementsAre(0));
    EXPECT_EQ(apart.placed.at(0).model->solids.size(), 2U);
    EXPECT_EQ(apart.placed[0].at.position_m, Vec3(0.5, 0.5, 1.0)) << "the middle of its box";
    EXPECT_EQ(apart.solids.size(), reading.scene.solids.size() - 2);
    EXPECT_TRUE(validate(apart).has_value());
    EXPECT_THAT(with_bodies_apart(reading.scene, 0, thing_of_body).placed, IsEmpty())
        << "no more than there is room for";
    EXPECT_THAT(thing_of_body, ElementsAre(-1));
}

TEST(MapBodies, keys_set_mass_friction_elasticity_and_rolling) {
    const Reading reading = thing(key("free", "1") + key("mass", "4") + key("friction", "0.5") +
                                  key("friction_static", "0.6") + key("elasticity", "0.6") + key("rolling", "0.02"));
    EXPECT_THAT(reading.said, IsEmpty());
    ASSERT_EQ(reading.scene.bodies.size(), 1U);
    const FreeBody& body = reading.scene.bodies[0];
    EXPECT_EQ(body.mass_kg, 4.0);
    EXPECT_FALSE(body.by_density);
    EXPECT_EQ(body.friction, 0.5);
    EXPECT_EQ(body.friction_static, 0.6);
    EXPECT_EQ(body.elasticity, 0.6);
    EXPECT_EQ(body.rolling, 0.02);
    EXPECT_EQ(thing(key("free", "1")).scene.bodies.at(0).friction_static, 0.5) << "a quarter more than while it slides";
}

TEST(MapBodies, bad_numbers_are_reported_with_file_and_line_and_the_rest_loads) {
    for (const auto& [keys, words, kg] :
         {std::tuple(key("mass", "0"), "of the key mass is out of range", 0.01),
          std::tuple(key("mass", "-3"), "of the key mass is out of range", 0.01),
          std::tuple(key("mass", "nan"), "\"nan\" of the key mass is not a number", 600.0),
          std::tuple(key("mass", "1e9"), "of the key mass is out of range", 10000.0),
          std::tuple(key("mass", "4") + key("elasticity", "2"), "of the key elasticity is out of range", 4.0),
          std::tuple(key("mass", "4") + key("rolling", "inf"), "of the key rolling is not a number", 4.0),
          std::tuple(key("density", "nan"), "of the key density is not a number", 600.0),
          std::tuple(key("density", "20000"), "20000 kilograms", 10000.0)}) {
        const Reading reading = thing(key("free", "1") + keys);
        EXPECT_THAT(reading.said, ElementsAre(testing::AllOf(HasSubstr("test.map, line "), HasSubstr(words)))) << keys;
        ASSERT_EQ(reading.scene.bodies.size(), 1U) << keys;
        EXPECT_NEAR(reading.scene.bodies[0].mass_kg, kg, 1e-9) << keys;
    }
}

TEST(MapBodies, a_rubber_string_is_tied_to_a_named_point_at_any_place_in_the_file) {
    const std::string point = entity("info_null", key("origin", "32 64 96") + key("targetname", "hook"));
    const std::string tied = key("free", "1") + key("mass", "1") + key("string", " hook ");
    for (const bool first : {false, true}) {
        const std::string ball = entity("thing", tied + key("stiffness_n_per_m", "40"), kCube);
        const Reading reading = test::reading_of(
            read_quake_map(entity("worldspawn", {}, kFloor) + (first ? point + ball : ball + point), "test.map"));
        EXPECT_THAT(reading.said, IsEmpty());
        ASSERT_EQ(reading.scene.bodies.size(), 1U);
        EXPECT_EQ(reading.scene.bodies[0].string_at_m, Vec3(1.0, 2.0, 3.0));
        EXPECT_EQ(reading.scene.bodies[0].string_n_per_m, 40.0);
    }
    for (const auto& [string, words] :
         {std::pair(key("string", "nowhere"), "no place with an origin and the targetname nowhere"),
          std::pair(key("string", ""), "does not name anything to tie"),
          std::pair(key("string", "hook") + key("stiffness_n_per_m", "nan"),
                    "of the key stiffness_n_per_m is not a number")}) {
        const Reading reading =
            test::reading_of(read_quake_map(entity("worldspawn", {}, kFloor) + point +
                                                entity("thing", key("free", "1") + key("mass", "1") + string, kCube),
                                            "test.map"));
        EXPECT_THAT(reading.said, ElementsAre(testing::AllOf(HasSubstr("test.map, line "), HasSubstr(words))));
        ASSERT_EQ(reading.scene.bodies.size(), 1U);
    }
}

TEST(MapBodies, that_cannot_be_free_stay_in_place_and_are_reported) {
    const auto stays = [](const std::string& text, const char* words) {
        const Reading reading = test::reading_of(read_quake_map(text, "test.map"));
        EXPECT_THAT(reading.said, testing::Contains(testing::AllOf(HasSubstr("test.map, line "), HasSubstr(words),
                                                                   HasSubstr("It stays where it is."))));
        EXPECT_THAT(reading.scene.bodies, IsEmpty());
        EXPECT_FALSE(reading.scene.solids.empty());
    };
    const std::string floor = entity("worldspawn", {}, kFloor);
    stays(entity("worldspawn", key("free", "1"), kFloor), "only a separate thing can be free to move");
    stays(floor + entity("func_door", key("free", "1") + key("angle", "90"), kCube),
          "only a separate thing can be free to move");
    stays(floor + entity("trigger_multiple", key("free", "1"), kCube), "only a separate thing can be free to move");
    // The patch states a density but encloses no volume.
    const std::string patch =
        "{\npatchDef2\n{\nplain\n( 3 3 0 0 0 )\n(\n"
        "( ( 0 0 0 0 0 ) ( 0 32 0 0 0 ) ( 0 64 0 0 0 ) )\n"
        "( ( 32 0 16 0 0 ) ( 32 32 16 0 0 ) ( 32 64 16 0 0 ) )\n"
        "( ( 64 0 0 0 0 ) ( 64 32 0 0 0 ) ( 64 64 0 0 0 ) )\n)\n}\n}\n";
    stays(floor + entity("thing", key("free", "1") + key("density", "100"), patch),
          "none of its brushes gives it a volume");
}

TEST(MapBodies, beyond_the_maximum_number_stay_fixed) {
    std::string things;
    for (int i = 0; i < 5000; ++i) {
        const double x = 4.0 * (i % 100), y = 4.0 * (i / 100);
        things += entity("thing", key("free", "1") + key("name", "Brick " + std::to_string(i)),
                         box_brush(x, y, 0, x + 2, y + 2, 2));
    }
    const Reading reading = read(things);
    EXPECT_EQ(reading.scene.bodies.size(), FreeBody::kMost);
    EXPECT_THAT(reading.said,
                ElementsAre(testing::AllOf(HasSubstr("test.map, line "),
                                           HasSubstr("more than 2,048 things are free to move; there are 2,952 more "
                                                     "from here on."),
                                           HasSubstr("The others stay where they are."))));
}

}  // namespace map_bodies_test
}  // namespace handrail
