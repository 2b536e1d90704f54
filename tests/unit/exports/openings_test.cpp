// On a sheet two rooms are open to each other where the route graph has a way through, and nowhere else.
#include "worlds/exports/openings.h"

#include <gtest/gtest.h>

#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/exports/plans.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail::test {
namespace openings_test {

const WallLook kLook{kWallLine_mm, kLeastGap_mm + 0.2, kLeastSymbol_mm + 0.2, 4.0};

// As on a sheet, at 1 to 200 or smaller where the storey is large.
struct Drawn {
    explicit Drawn(const Storey& storey) {
        const Vec2 size = storey.max_m - storey.min_m;
        const double mm_per_m = std::min(5.0, 400.0 / std::max(size.x, size.y));
        on_paper = {storey.min_m, Vec2(10.0), mm_per_m};
        walls = ink_of_walls(storey, on_paper, size.x * mm_per_m + 20.0, size.y * mm_per_m + 20.0, kLook);
    }
    OnPaper on_paper;
    WallInk walls;
};

TEST(Openings, are_found_where_a_wall_lacks_and_where_a_door_is_closed) {
    const Storey storey = two_rooms();
    const Drawn drawn(storey);
    const OpeningCheck sound = check_openings(drawn.walls.ink, storey, drawn.on_paper);
    EXPECT_TRUE(sound.lacking.empty() && sound.leaking.empty());
    Storey open = storey;
    open.walls_m.pop_back();
    Drawn leaks(open);
    EXPECT_EQ(check_openings(leaks.walls.ink, open, leaks.on_paper).leaking.size(), 1U)
        << "the northern half of the wall between them is not there";
    Storey closed = storey;
    closed.gaps.clear();
    closed.walls_m.push_back({{6.0, 1.0}, {6.2, 1.0}, {6.2, 3.0}, {6.0, 3.0}});
    Drawn shut(closed);
    const OpeningCheck found = check_openings(shut.walls.ink, closed, shut.on_paper);
    ASSERT_EQ(found.lacking.size(), 1U);
    EXPECT_EQ(found.lacking[0].rooms, (std::array<std::uint32_t, 2>{0, 1}));
    // And mended.
    EXPECT_EQ(mend_openings(shut.walls.ink, closed, shut.on_paper, kLook).opened, 1U);
    EXPECT_TRUE(check_openings(shut.walls.ink, closed, shut.on_paper).lacking.empty());
    EXPECT_EQ(mend_openings(leaks.walls.ink, open, leaks.on_paper, kLook).closed, 1U);
    EXPECT_TRUE(check_openings(leaks.walls.ink, open, leaks.on_paper).leaking.empty());
}

void are_those_of_the_graph(const std::string& file) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "takes too long here";
    const NamedStoreys* world = storeys_of(file);
    if (!world) GTEST_SKIP() << needs_real_world(file);
    ASSERT_FALSE(world->storeys.empty());
    for (const Storey& storey : world->storeys) {
        Drawn drawn(storey);
        mend_openings(drawn.walls.ink, storey, drawn.on_paper, kLook);
        const OpeningCheck found = check_openings(drawn.walls.ink, storey, drawn.on_paper);
        const auto told = [&](const char* what, const WrongOpening& wrong) {
            const Vec2 at = drawn.on_paper.world(wrong.at_mm);
            ADD_FAILURE() << file << ", storey " << storey.number << ": " << storey.rooms[wrong.rooms[0]].name
                          << " and " << storey.rooms[wrong.rooms[1]].name << " " << what << " at " << at.x << " "
                          << at.y;
        };
        for (const WrongOpening& wrong : found.lacking) told("lack their opening", wrong);
        for (const WrongOpening& wrong : found.leaking) told("are open to each other", wrong);
    }
}

struct OfWorld : testing::TestWithParam<const char*> {};
TEST_P(OfWorld, are_where_the_route_graph_has_them) { are_those_of_the_graph(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Openings, OfWorld,
                         testing::Values("house.map", "school.map", "first_room.map", "labyrinth1.map",
                                         "small_house.ifc", "institute.ifczip", "fzk-haus.ifc", "duplex-apartment.ifc",
                                         "smiley-west.ifc", "large-building.ifc", "office.map", "agdm01.map",
                                         "agtut01.map", "agtut03.map", "agtut05.map", "quake-start.map",
                                         "quake-dm3.map", "quake-e1m1.map", "wall-door-column-ifc4x3.ifc", "room.glb"));

// Reading plans starts threads.
struct OfPlan : testing::TestWithParam<const char*> {};
TEST_P(OfPlan, are_where_the_route_graph_has_them) { are_those_of_the_graph(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Openings, OfPlan,
                         testing::Values("apb-tu-dresden.osm", "aachen-university.osm", "addenbrookes.imdf.zip",
                                         "minimal.imdf.zip", "delft-station.osm", "frankfurt-hauptwache.osm",
                                         "cologne-central.osm", "london-waterloo.osm.pbf"));

}  // namespace openings_test
}  // namespace handrail::test
