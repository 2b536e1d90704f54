// Where one can stand and the rooms found there, kept for the next start.
#include "worlds/stored/stored_ways.h"
#include "tests/support/project_root.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <random>

#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/validate_ways.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/made_door.h"

namespace handrail {
namespace stored_ways_test {

namespace fs = std::filesystem;

struct World {
    Scene scene;
    WalkBody body;
    WalkSpace space;
    RoomGraph graph;
    WaysFrom from;

    explicit World(const char* file, double radius_m = 0.25) {
        Result<Scene> read = read_world(test::project_root() / file);
        EXPECT_TRUE(read.has_value());
        if (!read) return;
        scene = std::move(*read);
        body = walk_body(scene, radius_m, 1.8, 0.25);
        Result<WalkSpace> found = make_walk_space(scene, body);
        EXPECT_TRUE(found.has_value());
        if (!found) return;
        space = std::move(*found);
        graph = make_rooms(scene, space);
        from = ways_made_of(scene, body);
    }
    std::string bytes() const { return stored_ways(from, space, graph); }
};

bool same(const WalkSpan& a, const WalkSpan& b) {
    return a.floor_m == b.floor_m && a.ceiling_m == b.ceiling_m && a.cell == b.cell &&
           std::equal(std::begin(a.next), std::end(a.next), std::begin(b.next)) && a.ground == b.ground &&
           a.door == b.door && a.clearance_m == b.clearance_m && a.beside == b.beside && a.near_edge == b.near_edge &&
           a.liquid == b.liquid && a.stairs == b.stairs;
}

void expect_same(const FoundWays& kept, const WalkSpace& space, const RoomGraph& graph) {
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

TEST(StoredWays, come_back_bit_for_bit) {
    for (const char* file : {"worlds/maps/house.map", "tests/unit/ifc/worlds/small_house.ifc"}) {
        SCOPED_TRACE(file);
        const World world(file);
        const std::string bytes = world.bytes();
        ASSERT_FALSE(bytes.empty());
        const std::optional<FoundWays> kept = ways_from(bytes, world.from, world.scene);
        ASSERT_TRUE(kept.has_value());
        expect_same(*kept, world.space, world.graph);
        EXPECT_EQ(stored_ways(world.from, kept->space, kept->graph), bytes) << "all else too";
        EXPECT_LT(bytes.size(), world.space.spans.size() * 12);
    }
}

TEST(StoredWays, hold_for_the_same_scene_body_and_build_alone) {
    const World world("tests/unit/ifc/worlds/small_house.ifc");
    const std::string bytes = world.bytes();
    ASSERT_TRUE(ways_from(bytes, world.from, world.scene).has_value());
    // With one more door, or one thing called otherwise; what is reported of the reading does not count.
    Scene other = with_made_doors(world.scene, std::vector{MadeDoor{{4.0, 3.0, 0.0}, 0.5 * kPi, 0.9, 0.3, "between"}});
    EXPECT_FALSE(ways_from(bytes, ways_made_of(other, world.body), other).has_value());
    other = world.scene;
    other.features[0].name += "s";
    EXPECT_FALSE(ways_from(bytes, ways_made_of(other, world.body), other).has_value());
    other = world.scene;
    other.report.guessed.emplace_back("a sentence");
    EXPECT_TRUE(ways_from(bytes, ways_made_of(other, world.body), other).has_value());
    WalkBody wider = world.body;
    wider.radius_m = 0.3;
    EXPECT_FALSE(ways_from(bytes, ways_made_of(world.scene, wider), world.scene).has_value());
    WaysFrom older = world.from;
    --older.version;
    EXPECT_FALSE(ways_from(bytes, older, world.scene).has_value());
}

TEST(StoredWays, are_named_in_the_language_that_is_spoken_now) {
    const World world("worlds/maps/house.map");
    const std::string bytes = world.bytes();
    const test::InLanguage german("de");
    const RoomGraph meant = make_rooms(world.scene, world.space);
    const std::optional<FoundWays> kept = ways_from(bytes, world.from, world.scene);
    ASSERT_TRUE(kept.has_value());
    expect_same(*kept, world.space, meant);
    EXPECT_NE(meant.rooms[0].name, world.graph.rooms[0].name);
}

TEST(StoredWays, cut_or_changed_anywhere_are_not_there) {
    const World world("tests/unit/ifc/worlds/small_house.ifc");
    const std::string whole = world.bytes();
    for (std::size_t at = 0; at < whole.size(); ++at)
        ASSERT_FALSE(ways_from(std::string_view(whole).substr(0, at), world.from, world.scene)) << "cut at " << at;
    EXPECT_FALSE(ways_from(whole + "x", world.from, world.scene));
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 700) {
        std::string other = whole;
        other[at] = static_cast<char>(other[at] ^ 0x10);
        ASSERT_FALSE(ways_from(other, world.from, world.scene)) << "changed at " << at;
    }
}

// Somebody who knows the form: other values under a right checksum.
TEST(StoredWays, made_up_with_a_right_checksum_hold_together_or_are_not_there) {
    const World world("worlds/maps/first_room.map");
    const std::string whole = world.bytes();
    // After the sum and the size of the rest: its first word, version, size and sum of the scene, the body's five
    // measures, and how many bytes there are when unpacked.
    const std::string head = whole.substr(12, 14 + 8 + 12 + 40 + 8);
    std::uint64_t size = 0;
    std::memcpy(&size, head.data() + head.size() - sizeof size, sizeof size);
    std::string values(size, '\0');
    auto length = static_cast<uLongf>(size);
    ASSERT_EQ(::uncompress(reinterpret_cast<Bytef*>(values.data()), &length,
                           reinterpret_cast<const Bytef*>(whole.data() + 12 + head.size()),
                           static_cast<uLong>(whole.size() - 12 - head.size())),
              Z_OK);
    const auto file_of = [&](const std::string& changed) {
        std::string packed(::compressBound(static_cast<uLong>(changed.size())), '\0');
        auto made = static_cast<uLongf>(packed.size());
        EXPECT_EQ(::compress2(reinterpret_cast<Bytef*>(packed.data()), &made,
                              reinterpret_cast<const Bytef*>(changed.data()), static_cast<uLong>(changed.size()), 1),
                  Z_OK);
        packed.resize(made);
        const std::string after = head + packed;
        const std::uint32_t sum = checksum(0, after);
        const std::uint64_t bytes = after.size();
        std::string file(12, '\0');
        std::memcpy(file.data(), &sum, 4);
        std::memcpy(file.data() + 4, &bytes, 8);
        return file + after;
    };
    ASSERT_TRUE(ways_from(file_of(values), world.from, world.scene).has_value()) << "as they were";
    std::mt19937 random(20261126);
    int refused = 0;
    for (int round = 0; round < 200; ++round) {
        std::string changed = values;
        for (std::uint32_t edits = 1 + random() % 3; edits > 0; --edits) {
            // Half of them where the counts and the rooms are: at the ends.
            const std::size_t reach = random() % 2 ? changed.size() : std::min<std::size_t>(changed.size(), 600);
            const std::size_t at = random() % reach;
            changed[random() % 4 ? at : changed.size() - 1 - at] = static_cast<char>(random() % 3 ? random() : 0xff);
        }
        const std::optional<FoundWays> made = ways_from(file_of(changed), world.from, world.scene);
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

TEST(StoredWays, lie_in_their_file_where_there_is_much_to_find) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "house.map.handrail.ways";
    const World house("worlds/maps/house.map"), room("worlds/maps/first_room.map");
    EXPECT_FALSE(take_ways(file, house.from, house.scene));
    keep_ways_in(file, house.from, house.scene, house.space, house.graph);
    const std::string bytes = test::content_of(file);
    EXPECT_EQ(bytes, house.bytes());
    EXPECT_TRUE(take_ways(file, house.from, house.scene));
    keep_ways_in(file, room.from, room.scene, room.space, room.graph);
    EXPECT_LT(room.space.spans.size(), kLeastKeptSpans);
    EXPECT_LT(room.scene.solids.size(), kLeastKeptShapes);
    EXPECT_EQ(test::content_of(file), bytes) << "a small room is found sooner";
    std::stop_source stop;
    stop.request_stop();
    keep_ways_in(folder.path() / "stopped", house.from, house.scene, house.space, house.graph, stop.get_token());
    EXPECT_FALSE(fs::exists(folder.path() / "stopped"));
    keep_ways_in("/proc/no/such/folder", house.from, house.scene, house.space,
                 house.graph);  // not kept, and no word about it
}

}  // namespace stored_ways_test
}  // namespace handrail
