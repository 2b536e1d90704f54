// Tests forces in space, as a map defines them. Every key must change the force that the reader defines. The reader
// must refuse impossible values with the name of the key, and load the rest.
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/unit/readers/reading.h"

namespace handrail::test {
namespace map_effects_test {
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFloor = entity("worldspawn", {}, box_brush(0, 0, -8, 320, 320, 0));

Reading read(const std::string& entities) {
    ReadOptions options;
    options.guess_materials = false;
    return reading_of(read_quake_map(kFloor + entities, "effects.map", options));
}

std::string effect_entity(const std::string& kind, const std::string& keys = {},
                          const std::string& brushes = box_brush(32, 32, 32, 64, 64, 64)) {
    return entity("haptic_effect", key("effect", kind) + keys, brushes);
}

TEST(MapEffects, take_their_defaults_from_the_effect_table) {
    for (const EffectSpec& spec : effect_table()) {
        const Reading reading = read(effect_entity(std::string(spec.name)));
        EXPECT_THAT(reading.said, IsEmpty()) << spec.name;
        ASSERT_EQ(reading.scene.effects.size(), 1U) << spec.name;
        const Effect& effect = reading.scene.effects[0];
        EXPECT_EQ(effect.kind, spec.kind);
        EXPECT_EQ(effect.strength_n, spec.strength_n);
        EXPECT_EQ(effect.width_hand_m, spec.width_hand_m);
        EXPECT_EQ(effect.edge_hand_m, spec.edge_hand_m);
        EXPECT_EQ(std::get<ConvexSolid>(effect.where).bounds_m.min_m, Vec3(1.0));
        EXPECT_EQ(reading.scene.solids.size(), 1U) << "neither seen nor touched";
        EXPECT_EQ(reading.scene.report.brushes, 2) << "but counted";
        EXPECT_EQ(reading.scene.bounds_m.max_m.z, 0.0) << "and it makes the building no larger";
    }
}

TEST(MapEffects, accept_every_key) {
    const Reading reading =
        read(entity("func_wall", key("name", "Pillar"), box_brush(0, 0, 0, 16, 16, 64)) +
             effect_entity("Magnet", key("strength", "-1.5") + key("width", "0.02") + key("edge", "0.005") +
                                         key("pull", "line")) +
             effect_entity("vibration", key("frequency", "50") + key("direction", "0 3 4")) +
             effect_entity("inertia", key("mass", "0.2")) +
             effect_entity("magnet", key("pull", "object") + key("target", "pillar")) +
             effect_entity("force", key("origin", "32 64 96") + key("radius", "16"), "") +
             effect_entity("flypaper", key("origin", "32 64 96") + key("end", "64 64 96") + key("radius", "8"), ""));
    EXPECT_THAT(reading.said, IsEmpty());
    const std::vector<Effect>& effects = reading.scene.effects;
    ASSERT_EQ(effects.size(), 6U);
    EXPECT_EQ(effects[0].strength_n, -1.5);
    EXPECT_EQ(effects[0].width_hand_m, 0.02);
    EXPECT_EQ(effects[0].edge_hand_m, 0.005);
    EXPECT_EQ(effects[0].pull, MagnetPull::Line);
    EXPECT_EQ(effects[1].frequency_hz, 50.0);
    EXPECT_NEAR(glm::length(effects[1].direction - Vec3(0, 0.6, 0.8)), 0.0, 1e-15);
    EXPECT_EQ(effects[2].mass_kg, 0.2);
    EXPECT_EQ(effects[3].pull, MagnetPull::Object);
    ASSERT_NE(reading.scene.find(effects[3].belongs_to), nullptr);
    EXPECT_EQ(reading.scene.find(effects[3].belongs_to)->name, "Pillar");
    EXPECT_EQ(std::get<EffectBall>(effects[4].where).centre_m, Vec3(1, 2, 3));
    EXPECT_EQ(std::get<EffectBall>(effects[4].where).radius_m, 0.5);
    EXPECT_EQ(std::get<EffectCapsule>(effects[5].where).b_m, Vec3(2, 2, 3));
    EXPECT_EQ(effects[5].kind, EffectKind::FlyPaper);
}

TEST(MapEffects, without_size_are_refused_by_name_and_the_rest_loads) {
    std::string open = box_brush(32, 32, 32, 64, 64, 64);
    const std::size_t last_face = open.rfind("( ", open.rfind("plain"));
    const std::size_t line = open.rfind('\n', last_face);
    open.erase(line, open.rfind('}') - 1 - line);
    const auto named = [](const std::string& kind, const std::string& keys, const std::string& brushes) {
        return effect_entity(kind, key("name", "Snag") + keys, brushes);
    };
    const std::string cube = box_brush(0, 0, 0, 8, 8, 8);
    for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
             {named("magnet", key("width", "0"), cube), "has no width"},
             {named("detent", key("width", "-0.01"), cube), "has no width"},
             {named("force", key("origin", "1 2 3") + key("radius", "0"), ""), "has no radius"},
             {named("force", key("origin", "1 2 3"), ""), "has an origin but no radius"},
             {named("force", "", ""), "has neither brushes nor an origin"},
             {named("force", "", open), "not closed"},
             {named("force", "", box_brush(0, 0, 0, 0, 8, 8)), "a brush of the effect Snag"},
             {entity("haptic_effect", key("name", "Snag"), cube), "needs the key effect to say which effect it is"}}) {
        const Reading reading = read(text + effect_entity("fly-paper"));
        ASSERT_EQ(reading.said.size(), 1U) << text << testing::PrintToString(reading.said);
        EXPECT_THAT(reading.said[0],
                    AllOf(HasSubstr("Snag"), HasSubstr(why), HasSubstr("left out"), HasSubstr("effects.map, line")));
        ASSERT_EQ(reading.scene.effects.size(), 1U) << "the rest loads";
        EXPECT_EQ(reading.scene.effects[0].kind, EffectKind::FlyPaper);
    }
}

TEST(MapEffects, suggest_the_nearest_name_and_use_the_nearest_legal_value) {
    const Reading unknown = read(effect_entity("magnett"));
    EXPECT_THAT(unknown.said, ElementsAre(HasSubstr("there is no effect \"magnett\". The nearest name is magnet.")));
    EXPECT_THAT(unknown.scene.effects, IsEmpty());

    const Reading wild =
        read(effect_entity("magnet", key("strength", "9") + key("width", "many") + key("edge", "0") +
                                         key("pull", "hole") + key("direction", "0 0 0") + key("target", "Pilar")) +
             effect_entity("vibration", key("frequency", "1e9") + key("direction", "up")) +
             effect_entity("inertia", key("mass", "nan")) +
             entity("func_wall", key("name", "Pillar"), box_brush(0, 0, 0, 16, 16, 64)));
    ASSERT_EQ(wild.scene.effects.size(), 3U);
    EXPECT_EQ(wild.scene.effects[0].strength_n, 4.0);
    EXPECT_EQ(wild.scene.effects[0].width_hand_m, 0.01);
    EXPECT_EQ(wild.scene.effects[0].edge_hand_m, 0.001);
    EXPECT_EQ(wild.scene.effects[0].direction, Vec3(0, 0, 1));
    EXPECT_FALSE(wild.scene.effects[0].belongs_to);
    EXPECT_EQ(wild.scene.effects[1].frequency_hz, 250.0);
    EXPECT_EQ(wild.scene.effects[2].mass_kg, 0.1);
    EXPECT_THAT(wild.said, ElementsAre(HasSubstr("strength"), HasSubstr("width"), HasSubstr("edge"),
                                       HasSubstr("direction of the effect magnet has no length"), HasSubstr("pull"),
                                       HasSubstr("frequency"), HasSubstr("direction is not three numbers"),
                                       HasSubstr("mass"), HasSubstr("nearest name is Pillar")));
}

TEST(MapEffects, give_liquids_buoyancy_film_and_flow) {
    const auto pool = [](const std::string& keys) {
        return read(
            entity("thing", key("cs_name", "liquid") + key("name", "Pool") + keys, box_brush(0, 0, 0, 64, 64, 32)));
    };
    const Reading all =
        pool(key("viscosity", "4") + key("buoyancy", "0.5") + key("film", "0.3") + key("flow", "0.1 0 -0.2"));
    EXPECT_THAT(all.said, IsEmpty());
    const Solid& solid = all.scene.solids.back();
    EXPECT_EQ(solid.buoyancy_n, 0.5);
    EXPECT_EQ(solid.film_n, 0.3);
    EXPECT_EQ(solid.flow_hand_m_per_s, Vec3(0.1, 0, -0.2));
    const Reading wild = pool(key("viscosity", "4") + key("buoyancy", "7") + key("film", "-1") + key("flow", "3 4 0"));
    EXPECT_EQ(wild.scene.solids.back().buoyancy_n, 1.0);
    EXPECT_EQ(wild.scene.solids.back().film_n, 0.0);
    EXPECT_NEAR(glm::length(wild.scene.solids.back().flow_hand_m_per_s - Vec3(0.3, 0.4, 0.0)), 0.0, 1e-12);
    EXPECT_EQ(wild.said.size(), 3U);
    EXPECT_THAT(pool(key("flow", "0.1 0 0")).said, ElementsAre(HasSubstr("this liquid has none")));
}

TEST(MapSoft, sides_yield_as_written) {
    const auto thing = [](const std::string& keys) {
        return read(entity("func_wall", key("name", "Seat") + keys, box_brush(0, 0, 0, 32, 32, 16)));
    };
    const Reading plain = thing(key("soft", "Elastic"));
    EXPECT_THAT(plain.said, IsEmpty());
    ASSERT_TRUE(plain.scene.solids.back().soft);
    const SoftFace& soft = *plain.scene.solids.back().soft;
    EXPECT_EQ(plain.scene.solids.back().shape.planes[soft.face].normal, Vec3(0, 0, 1));
    EXPECT_EQ(soft.depth_m, 0.25) << "half of what there is";
    EXPECT_EQ(soft.stiffness_fraction, 0.2);
    EXPECT_EQ(soft.recovery_s, 0.5);
    EXPECT_FALSE(soft.plastic);
    const Reading all = thing(key("soft", "plastic") + key("soft_side", "west") + key("soft_depth", "8") +
                              key("soft_stiffness", "0.5") + key("soft_yield", "2"));
    EXPECT_THAT(all.said, IsEmpty());
    const Solid& solid = all.scene.solids.back();
    EXPECT_EQ(solid.shape.planes[solid.soft->face].normal, Vec3(-1, 0, 0));
    EXPECT_EQ(solid.soft->depth_m, 0.25);
    EXPECT_EQ(solid.soft->stiffness_fraction, 0.5);
    EXPECT_EQ(solid.soft->yield_n, 2.0);
    EXPECT_TRUE(solid.soft->plastic);

    EXPECT_THAT(thing(key("soft", "fluffy")).said,
                ElementsAre(HasSubstr("neither elastic nor plastic. It stays hard.")));
    EXPECT_THAT(thing(key("soft", "elastic") + key("soft_depth", "0")).said,
                ElementsAre(HasSubstr("the key soft_depth must be above 0")));
    EXPECT_FALSE(thing(key("soft", "elastic") + key("soft_depth", "0")).scene.solids.back().soft);
    const Reading deep = thing(key("soft", "elastic") + key("soft_depth", "16") + key("soft_stiffness", "7") +
                               key("soft_recovery", "x") + key("soft_side", "nort"));
    EXPECT_EQ(deep.said.size(), 4U) << testing::PrintToString(deep.said);
    EXPECT_NEAR(deep.scene.solids.back().soft->depth_m, 0.9 * 0.5, 1e-12) << "something hard is left underneath";
    EXPECT_EQ(deep.scene.solids.back().soft->stiffness_fraction, 0.6);
}

TEST(MapEffects, survive_being_cut_at_every_byte) {
    const std::string text =
        kFloor + effect_entity("magnet", key("pull", "object") + key("target", "x") + key("strength", "1")) +
        effect_entity("force", key("origin", "32 64 96") + key("end", "1 2 3") + key("radius", "16"), "");
    ReadOptions options;
    for (std::size_t length = kFloor.size(); length < text.size(); ++length) {
        const Result<Scene> scene = read_quake_map(text.substr(0, length), "cut.map", options);
        ASSERT_TRUE(scene.has_value()) << length;
        ASSERT_TRUE(validate(*scene).has_value()) << length;
    }
}

}  // namespace map_effects_test
}  // namespace handrail::test
