// Tests the walkable area and the rooms found in it, which the program stores for its next start.
#include "worlds/stored/stored_navigation.h"
#include "tests/support/project_root.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <random>

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/validate_ways.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/made_door.h"

namespace handrail {
namespace stored_navigation_test {

struct World {
    Scene scene;
    WalkerMeasures body;
    WalkSpace space;
    RoomGraph graph;

    explicit World(const char* file, double radius_m = 0.25) {
        Result<Scene> read = read_world(test::project_root() / file);
        EXPECT_TRUE(read.has_value());
        if (!read) return;
        scene = std::move(*read);
        body = walker_measures(scene, radius_m, 1.8, 0.25);
        Result<WalkSpace> found = make_walk_space(scene, body);
        EXPECT_TRUE(found.has_value());
        if (!found) return;
        space = std::move(*found);
        graph = make_rooms(scene, space);
    }
    std::string bytes() const { return stored_navigation(space, graph); }
    std::optional<FoundNavigation> from(std::string_view bytes) const {
        return navigation_from(unpacked_navigation(bytes), body, scene);
    }
};

bool same(const WalkSpan& a, const WalkSpan& b) {
    return a.floor_m == b.floor_m && a.ceiling_m == b.ceiling_m && a.cell == b.cell &&
           std::equal(std::begin(a.next), std::end(a.next), std::begin(b.next)) && a.ground == b.ground &&
           a.door == b.door && a.clearance_m == b.clearance_m && a.beside == b.beside && a.near_edge == b.near_edge &&
           a.liquid == b.liquid && a.stairs == b.stairs;
}

void expect_same(const FoundNavigation& kept, const WalkSpace& space, const RoomGraph& graph) {
    EXPECT_EQ(kept.space.origin_m, space.origin_m);
    EXPECT_EQ(kept.space.cell_m, space.cell_m);
    EXPECT_EQ(kept.space.body, space.body);
    EXPECT_EQ(kept.space.said, space.said);
    EXPECT_EQ(kept.space.first, space.first);
    EXPECT_EQ(kept.space.obstacle_features, space.obstacle_features);
    ASSERT_EQ(kept.space.spans.size(), space.spans.size());
    EXPECT_TRUE(std::equal(space.spans.begin(), space.spans.end(), kept.space.spans.begin(), same));
    ASSERT_EQ(kept.space.links.size(), space.links.size());
    EXPECT_EQ(kept.space.walls, nullptr);
    EXPECT_EQ(kept.graph.room_of_span, graph.room_of_span);
    EXPECT_EQ(kept.graph.language, graph.language);
    ASSERT_EQ(kept.graph.rooms.size(), graph.rooms.size());
    for (std::size_t i = 0; i < graph.rooms.size(); ++i) {
        EXPECT_EQ(kept.graph.rooms[i].name, graph.rooms[i].name);
        EXPECT_EQ(kept.graph.rooms[i].middle_m, graph.rooms[i].middle_m);
    }
    EXPECT_EQ(kept.graph.portals.size(), graph.portals.size());
}

TEST(StoredNavigation, are_bit_identical_after_loading) {
    for (const char* file : {"worlds/maps/house.map", "tests/unit/ifc/worlds/small_house.ifc"}) {
        SCOPED_TRACE(file);
        const World world(file);
        const std::string bytes = world.bytes();
        ASSERT_FALSE(bytes.empty());
        const std::optional<FoundNavigation> kept = world.from(bytes);
        ASSERT_TRUE(kept.has_value());
        expect_same(*kept, world.space, world.graph);
        EXPECT_EQ(stored_navigation(kept->space, kept->graph), bytes) << "all else too";
        EXPECT_LT(bytes.size(), world.space.spans.size() * 12);
    }
}

TEST(StoredNavigation, have_a_key_that_is_equal_only_for_the_same_scene_and_body) {
    const World world("tests/unit/ifc/worlds/small_house.ifc");
    const std::string key = navigation_key(world.scene, world.body);
    EXPECT_EQ(key.size(), 64U);
    EXPECT_EQ(navigation_key(Scene(world.scene), world.body), key);
    // The key of the stored file must change if the scene has one more door or a different name. The key must not
    // depend on warnings from reading the file.
    Scene other = with_made_doors(world.scene, std::vector{MadeDoor{{4.0, 3.0, 0.0}, 0.5 * kPi, 0.9, 0.3, "between"}});
    EXPECT_NE(navigation_key(other, world.body), key);
    other = world.scene;
    other.features[0].name += "s";
    EXPECT_NE(navigation_key(other, world.body), key);
    other = world.scene;
    other.report.guessed.emplace_back("a sentence");
    EXPECT_EQ(navigation_key(other, world.body), key);
    WalkerMeasures wider = world.body;
    wider.radius_m = 0.3;
    EXPECT_NE(navigation_key(world.scene, wider), key);
}

TEST(StoredNavigation, of_another_body_or_a_smaller_scene_are_rejected) {
    const World world("tests/unit/ifc/worlds/small_house.ifc");
    const std::string plain = unpacked_navigation(world.bytes());
    ASSERT_TRUE(navigation_from(plain, world.body, world.scene).has_value());
    WalkerMeasures wider = world.body;
    wider.radius_m = 0.3;
    EXPECT_FALSE(navigation_from(plain, wider, world.scene).has_value());
    EXPECT_FALSE(navigation_from(plain, world.body, Scene{}).has_value()) << "they name things that are not in it";
}

TEST(StoredNavigation, are_named_in_the_currently_spoken_language) {
    const World world("worlds/maps/house.map");
    const std::string bytes = world.bytes();
    const test::InLanguage german("de");
    const RoomGraph meant = make_rooms(world.scene, world.space);
    const std::optional<FoundNavigation> kept = world.from(bytes);
    ASSERT_TRUE(kept.has_value());
    expect_same(*kept, world.space, meant);
    EXPECT_NE(meant.rooms[0].name, world.graph.rooms[0].name);
}

// The cache detects changes by its digest, which unit_cache tests. Truncation must be detected even without the digest,
// by the reader of stored routes itself.
TEST(StoredNavigation, cut_anywhere_are_rejected) {
    const World world("tests/unit/ifc/worlds/small_house.ifc");
    const std::string whole = world.bytes(), plain = unpacked_navigation(whole);
    ASSERT_FALSE(plain.empty());
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 300)
        ASSERT_EQ(unpacked_navigation(std::string_view(whole).substr(0, at)), "") << "cut at " << at;
    for (std::size_t at = 0; at < plain.size(); at += 1 + plain.size() / 700)
        ASSERT_FALSE(navigation_from(std::string_view(plain).substr(0, at), world.body, world.scene))
            << "cut at " << at;
    EXPECT_FALSE(navigation_from(plain + "x", world.body, world.scene));
}

TEST(StoredNavigation, that_claim_an_impossible_size_allocate_no_memory) {
    const World world("tests/unit/ifc/worlds/small_house.ifc");
    std::string bytes = world.bytes();
    for (int byte = 0; byte < 8; ++byte) bytes[static_cast<std::size_t>(byte)] = '\x7f';
    EXPECT_EQ(unpacked_navigation(bytes), "");
}

// Simulates an attacker who knows the format. The attacker changes values and compresses them correctly.
TEST(StoredNavigation, that_were_forged_are_consistent_or_rejected) {
    const World world("worlds/maps/first_room.map");
    const std::string values = unpacked_navigation(world.bytes());
    // Returns a file with the size before compression, followed by the compressed bytes.
    const auto file_of = [&](const std::string& changed) {
        std::string packed(::compressBound(static_cast<uLong>(changed.size())), '\0');
        auto made = static_cast<uLongf>(packed.size());
        EXPECT_EQ(::compress2(reinterpret_cast<Bytef*>(packed.data()), &made,
                              reinterpret_cast<const Bytef*>(changed.data()), static_cast<uLong>(changed.size()), 1),
                  Z_OK);
        packed.resize(made);
        const std::uint64_t bytes = changed.size();
        std::string file(8, '\0');
        std::memcpy(file.data(), &bytes, 8);
        return file + packed;
    };
    ASSERT_TRUE(world.from(file_of(values)).has_value()) << "as they were";
    std::mt19937 random(20261126);
    int refused = 0;
    for (int round = 0; round < 200; ++round) {
        std::string changed = values;
        for (std::uint32_t edits = 1 + random() % 3; edits > 0; --edits) {
            // Half of the edits are near the two ends of the data, which contain the counts and the rooms.
            const std::size_t reach = random() % 2 ? changed.size() : std::min<std::size_t>(changed.size(), 600);
            const std::size_t at = random() % reach;
            changed[random() % 4 ? at : changed.size() - 1 - at] = static_cast<char>(random() % 3 ? random() : 0xff);
        }
        // The result must be the same whether the data comes through the reader process or directly.
        EXPECT_EQ(navigation_from(changed, world.body, world.scene).has_value(),
                  world.from(file_of(changed)).has_value());
        const std::optional<FoundNavigation> made = navigation_from(changed, world.body, world.scene);
        if (!made) {
            ++refused;
            continue;
        }
        ASSERT_TRUE(validate(made->space).has_value());
        ASSERT_TRUE(validate(made->graph, made->space).has_value());
        ASSERT_TRUE(Navigation::over(world.scene, made->space).has_value());
    }
    EXPECT_GT(refused, 50);
}

TEST(StoredNavigation, are_worth_storing_if_there_is_much_to_find) {
    const World house("worlds/maps/house.map"), room("worlds/maps/first_room.map");
    EXPECT_TRUE(worth_keeping(house.space, house.scene));
    EXPECT_FALSE(worth_keeping(room.space, room.scene)) << "a small room is found sooner";
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(stored_navigation(house.space, house.graph, stop.get_token()), "");
}

}  // namespace stored_navigation_test
}  // namespace handrail
