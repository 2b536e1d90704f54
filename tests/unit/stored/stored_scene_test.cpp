// Tests the conversion of a Scene to bytes and back.
#include "worlds/stored/stored_scene.h"
#include "tests/support/project_root.h"

#include <random>

#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace stored_scene_test {

namespace fs = std::filesystem;

std::vector<fs::path> worlds() {
    std::vector<fs::path> all;
    const fs::path source = test::project_root();
    for (const fs::path& folder : {source / "worlds" / "maps", source / "tests" / "unit" / "ifc" / "worlds",
                                   source / "tests" / "fuzz" / "inputs" / "map" / "seeds",
                                   source / "tests" / "fuzz" / "inputs" / "osm" / "seeds",
                                   source / "tests" / "fuzz" / "inputs" / "gltf" / "seeds"})
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.path().extension() != ".toml") all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(StoredScene, is_bit_identical_after_loading) {
    int read = 0, movers = 0, bodies = 0, rooms = 0, triangles = 0;
    for (const fs::path& path : worlds()) {
        const Result<Scene> scene = read_world(path);
        if (!scene) continue;
        ++read;
        const std::string bytes = stored::stored(*scene);
        const Result<Scene> back = scene_from(bytes);
        ASSERT_TRUE(back.has_value()) << path << ": " << back.error().sentence();
        ASSERT_EQ(stored::stored(*back), bytes) << path;
        EXPECT_EQ(back->name, scene->name);
        ASSERT_EQ(back->solids.size(), scene->solids.size());
        for (std::size_t i = 0; i < scene->solids.size(); ++i) {
            EXPECT_EQ(back->solids[i].face_hidden, scene->solids[i].face_hidden);
            EXPECT_EQ(back->solids[i].source.line, scene->solids[i].source.line);
        }
        EXPECT_EQ(back->materials, scene->materials) << path;
        EXPECT_EQ(back->stated == nullptr, scene->stated == nullptr);
        movers += static_cast<int>(back->movers.size());
        bodies += static_cast<int>(back->bodies.size());
        triangles += static_cast<int>(back->triangles.size());
        rooms += back->stated ? static_cast<int>(back->stated->rooms.size()) : 0;
    }
    EXPECT_GE(read, 12);
    for (const int seen : {movers, bodies, rooms, triangles}) EXPECT_GT(seen, 0);
}

TEST(StoredScene, shares_everything_that_was_shared_before) {
    const Result<Scene> house = read_world(test::project_root() / "worlds/maps/first_room.map");
    ASSERT_TRUE(house.has_value());
    Scene scene = *house;
    const auto model = std::make_shared<const Scene>(*house);
    for (int i = 0; i < 2; ++i) scene.placed.push_back({{0}, model, kDefaultMaterial, {{i, 0, 0}, {}, 1.0}});
    // Adds two materials that share a picture, and a soft face, because no bundled world has them.
    const auto picture = std::make_shared<const HeightPicture>(HeightPicture{2, 1, {0.25F, 0.75F}});
    for (const double depth_m : {0.001, 0.002}) {
        Material material;
        material.name = "relief";
        material.picture = TexturePicture{picture, depth_m, 0.5, 0.1, scene.bounds_m};
        scene.materials.push_back(material);
    }
    scene.solids[0].soft = SoftFace{1, true, 0.02, 0.3, 0.4, 2.0};
    scene.effects.resize(3);
    scene.effects[0].where = scene.solids[0].shape;
    scene.effects[1].where = EffectBall{{1, 2, 3}, 0.5};
    scene.effects[2].where = EffectCapsule{{1, 2, 3}, {4, 5, 6}, 0.25};
    scene.effects[2].pull = MagnetPull::Object;
    const Result<Scene> back = scene_from(stored::stored(scene));
    ASSERT_TRUE(back.has_value()) << back.error().sentence();
    ASSERT_EQ(back->effects.size(), 3U);
    EXPECT_EQ(std::get<ConvexSolid>(back->effects[0].where).planes.size(), scene.solids[0].shape.planes.size());
    EXPECT_EQ(std::get<EffectBall>(back->effects[1].where).radius_m, 0.5);
    EXPECT_EQ(std::get<EffectCapsule>(back->effects[2].where).b_m, Vec3(4, 5, 6));
    EXPECT_EQ(back->effects[2].pull, MagnetPull::Object);
    const std::size_t last = back->materials.size() - 1;
    EXPECT_EQ(back->materials[last].picture->heights, back->materials[last - 1].picture->heights);
    EXPECT_EQ(back->materials[last].picture->heights->depths, picture->depths);
    EXPECT_EQ(back->materials[last].picture->depth_hand_m, 0.002);
    EXPECT_EQ(back->solids[0].soft->yield_n, 2.0);
    EXPECT_TRUE(back->solids[0].soft->plastic);
    ASSERT_EQ(back->placed.size(), 2U);
    EXPECT_EQ(back->placed[0].model, back->placed[1].model);
    EXPECT_EQ(stored::stored(*back->placed[0].model), stored::stored(*house));
}

TEST(StoredScene, cut_or_changed_anywhere_is_a_complete_scene_or_an_error_sentence) {
    const Result<Scene> scene = read_world(test::project_root() / "tests/unit/ifc/worlds/small_house.ifc");
    ASSERT_TRUE(scene.has_value());
    const std::string whole = stored::stored(*scene);
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 1500)
        ASSERT_FALSE(scene_from(whole.substr(0, at)).has_value()) << "cut at " << at;
    EXPECT_FALSE(scene_from(whole + "x").has_value());
    std::mt19937 random(20261124);
    for (int round = 0; round < 1500; ++round) {
        std::string other = whole;
        for (std::uint32_t edits = 1 + random() % 3; edits > 0; --edits)
            other[random() % other.size()] = static_cast<char>(random() % 3 == 0 ? 0xff : random());
        const Result<Scene> made = scene_from(other);
        EXPECT_TRUE(!made || validate(*made).has_value());
    }
}

}  // namespace stored_scene_test
}  // namespace handrail
