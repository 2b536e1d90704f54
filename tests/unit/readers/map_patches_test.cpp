// Tests curved patches and brushDef in a map. The reader must cut them into triangles and report them. If a patch is
// damaged, only that patch may be lost, not the map.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/readers/reading.h"

namespace handrail {
namespace map_patches_test {

using test::box_brush;
using test::entity;
using test::key;
using test::Reading;
using test::reading_of;

const std::string kFloor = box_brush(0, 0, -32, 640, 640, 0);

// Returns a quarter of an arch, 64 units high and wide and 128 units deep, as an editor writes it.
std::string patch(const std::string& form = "patchDef2", const std::string& size = "3 3 0 0 0",
                  const std::string& texture = "base_wall/brick2") {
    std::string text = "{\n" + form + "\n{\n" + texture + "\n( " + size + " )\n(\n";
    for (const char* row : {"64 0 0", "64 0 64", "0 0 64"}) {
        int x = 0, y = 0, z = 0;
        std::sscanf(row, "%d %d %d", &x, &y, &z);
        text += "(";
        for (const int deep : {0, 64, 128}) text += fmt::format(" ( {} {} {} 0 0 )", x, y + deep, z);
        text += " )\n";
    }
    return text + ")\n}\n}\n";
}

Reading read(const std::string& brushes, const std::string& keys = {}) {
    return reading_of(read_quake_map(entity("worldspawn", keys, kFloor + brushes), "p.map"));
}

TEST(MapPatches, can_be_touched_on_the_side_that_their_entity_names) {
    const auto side_of = [](const std::string& value, std::vector<std::string>* said = nullptr) {
        Reading reading =
            reading_of(read_quake_map(entity("worldspawn", {}, kFloor) +
                                          entity("func_wall", value.empty() ? "" : key("touch_side", value), patch()),
                                      "p.map"));
        if (said) *said = reading.said;
        EXPECT_FALSE(reading.scene.triangles.empty());
        for (const MeshTriangle& t : reading.scene.triangles) EXPECT_EQ(t.side, reading.scene.triangles[0].side);
        return reading.scene.triangles.at(0).side;
    };
    EXPECT_EQ(side_of(""), TouchSide::Both);
    EXPECT_EQ(side_of("both"), TouchSide::Both);
    EXPECT_EQ(side_of("front"), TouchSide::Front);
    EXPECT_EQ(side_of("Back "), TouchSide::Back);
    std::vector<std::string> said;
    EXPECT_EQ(side_of("inside", &said), TouchSide::Both);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].find("is not one of these: both, front, back"), std::string::npos) << said[0];
    const Reading solid = reading_of(read_quake_map(entity("worldspawn", key("touch_side", "front"), kFloor), "p.map"));
    ASSERT_EQ(solid.said.size(), 1U);
    EXPECT_NE(solid.said[0].find("without curved patches"), std::string::npos) << solid.said[0];
}

TEST(MapPatches, become_triangles_within_a_millimetre_and_their_error_is_reported) {
    const Reading reading = read(patch());
    EXPECT_TRUE(reading.said.empty());
    EXPECT_EQ(reading.scene.report.patches, 1);
    EXPECT_EQ(reading.scene.report.brushes, 1);
    EXPECT_EQ(reading.scene.report.triangles, 12) << "of brushes only";
    ASSERT_GT(reading.scene.triangles.size(), 10U);
    ASSERT_EQ(reading.scene.report.simplified.size(), 1U);
    EXPECT_TRUE(reading.scene.report.simplified[0].starts_with(
        fmt::format("One curved patch became {} flat triangles, at most 0.", reading.scene.triangles.size())))
        << reading.scene.report.simplified[0];
    const Feature& arch = *reading.scene.find(reading.scene.triangles[0].feature);
    EXPECT_EQ(arch.name, "curved surface");
    EXPECT_EQ(reading.scene.material(arch.material).name, "brick");
    EXPECT_NEAR(arch.bounds_m.max_m.z, 2.0, 1e-12);
    EXPECT_NEAR(arch.bounds_m.max_m.y, 4.0, 1e-12);
    // The arch is a parabola from (2, 0) to (0, 2) with the control point (2, 2). The curve is 3.246 m long, and the
    // arch is 4 m deep.
    EXPECT_NEAR(arch.area_m2, 4.0 * 3.2465, 0.02);
    // A smaller permitted error must give more triangles, and a greater one fewer.
    const auto count = [](const char* error) {
        return read(patch(), key("curve_error", error)).scene.triangles.size();
    };
    EXPECT_GT(count("0.1"), reading.scene.triangles.size());
    EXPECT_LT(count("50"), reading.scene.triangles.size());
    EXPECT_EQ(read(patch(), key("curve_error", "-3")).said.size(), 1U);
    EXPECT_EQ(read(patch("patchDef3", "3 3 4 4 0 0 0")).scene.triangles.size(), reading.scene.triangles.size());
    const Reading alone = reading_of(read_quake_map(entity("worldspawn", {}, patch()), "p.map"));
    EXPECT_EQ(alone.scene.triangles.size(), reading.scene.triangles.size()) << "a map of curves alone";
}

TEST(MapPatches, of_a_named_entity_belong_to_it_and_untouchable_ones_are_counted) {
    const auto with = [](const std::string& class_name, const std::string& texture) {
        return reading_of(
            read_quake_map(entity("worldspawn", {}, kFloor) +
                               entity(class_name, key("name", "Arch"),
                                      box_brush(64, 0, 0, 80, 8, 64) + patch("patchDef2", "3 3 0 0 0", texture)),
                           "p.map"));
    };
    const Reading arch = with("func_group", "stone");
    EXPECT_EQ(arch.scene.triangles.at(0).feature, arch.scene.solids.at(1).feature);
    EXPECT_EQ(arch.scene.find(arch.scene.triangles[0].feature)->name, "Arch");
    for (const auto& [class_name, texture] :
         {std::pair{"trigger_once", "stone"}, {"func_group", "clip"}, {"func_group", "*water"}}) {
        const Reading none = with(class_name, texture);
        EXPECT_TRUE(none.scene.triangles.empty());
        EXPECT_EQ(none.scene.report.left_out.size(), 1U);
    }
}

TEST(MapPatches, that_are_damaged_cost_only_themselves) {
    const std::string good = patch();
    const auto broken = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return read(text + box_brush(128, 0, 0, 160, 32, 32));
    };
    for (const auto& [from, to] : {std::pair{"( 3 3 0", "( 4 3 0"},
                                   {"( 3 3 0", "( 3 2 0"},
                                   {"( 3 3 0", "( 1 1 0"},
                                   {"( 3 3 0", "( 5 3 0"},
                                   {"( 3 3 0", "( 3 5 0"},
                                   {"( 3 3 0", "( 3.5 3 0"},
                                   {"( 3 3 0", "( -3 3 0"},
                                   {"( 3 3 0", "( 1e9 3 0"},
                                   {"( 3 3 0", "( nan 3 0"},
                                   {"( 3 3 0", "( x 3 0"},
                                   {"( 64 0 0", "( nan 0 0"},
                                   {"( 64 0 0", "( inf 0 0"},
                                   {"( 64 0 0 0 0 )", "( 64 0 )"},
                                   {"( 64 0 0", "64 0 0"},
                                   {"( 64 0 0", "( 1e30 0 0"}}) {
        const Reading reading = broken(from, to);
        EXPECT_TRUE(reading.scene.triangles.empty()) << to;
        EXPECT_EQ(reading.scene.solids.size(), 2U) << "what comes after is read: " << to;
        ASSERT_EQ(reading.said.size(), 1U) << to;
        EXPECT_NE(reading.said[0].find("curved patch"), std::string::npos) << reading.said[0];
        EXPECT_EQ(reading.scene.report.left_out.size(), 1U);
    }
}

TEST(MapPatches, cut_at_every_byte_keep_all_complete_parts) {
    const std::string whole =
        entity("worldspawn", {}, kFloor + patch() + patch("patchDef3", "3 3 1 1 0 0 0")) +
        entity("func_wall", key("shape", "cone") + key("axis", "-x"), box_brush(0, 0, 0, 64, 16, 16));
    std::size_t most = 0;
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        const Result<Scene> scene = read_quake_map(std::string_view(whole).substr(0, length), "cut.map");
        if (!scene) continue;
        const Result<void> valid = validate(*scene);
        ASSERT_TRUE(valid) << valid.error().sentence();
        const std::size_t held = scene->triangles.size() + scene->solids.size();
        EXPECT_GE(held, most) << length;
        most = std::max(most, held);
    }
    EXPECT_GT(most, 20U);
}

TEST(MapPatches, in_brushDef_notation_give_the_same_brushes_as_the_plain_notation) {
    std::string def = "{\nbrushDef\n{\n";
    const std::string plain = box_brush(64, 64, 0, 96, 96, 32, "wood");
    for (std::size_t at = plain.find('('); at != std::string::npos; at = plain.find("( ", plain.find('\n', at))) {
        const std::size_t texture = plain.find("wood", at);
        def += plain.substr(at, texture - at) + "( ( 0.03 0 0 ) ( 0 0.03 0 ) ) base/wood 0 0 0\n";
        if (plain.find('\n', at) == std::string::npos) break;
    }
    def += "}\n}\n";
    const Reading a = read(plain), b = read(def);
    EXPECT_TRUE(b.said.empty()) << b.said.front();
    ASSERT_EQ(b.scene.solids.size(), 2U);
    EXPECT_EQ(b.scene.report.brushes, 2);
    ASSERT_EQ(a.scene.solids[1].shape.planes.size(), b.scene.solids[1].shape.planes.size());
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(a.scene.solids[1].shape.planes[i].normal, b.scene.solids[1].shape.planes[i].normal);
        EXPECT_EQ(a.scene.solids[1].shape.planes[i].offset_m, b.scene.solids[1].shape.planes[i].offset_m);
    }
    EXPECT_EQ(b.scene.material(b.scene.solids[1].face_materials[0]).name, "wood");
    // If a brush lacks its second brace or the numbers of its texture, only that brush may be lost.
    EXPECT_EQ(
        read("{\nbrushDef\n{\n( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) ( ( 1 0 ) x 0 0 0\n}\n}\n" + plain).scene.solids.size(),
        2U);
}

}  // namespace map_patches_test
}  // namespace handrail
