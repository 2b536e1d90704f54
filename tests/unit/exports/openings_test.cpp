// Tests that two rooms are open to each other on a sheet where the route graph has a passage, and nowhere else.
#include "worlds/exports/openings.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/exports/plans.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail::test {
namespace openings_test {

const WallLook kLook{kWallLine_mm, kLeastGap_mm + 0.2, kLeastSymbol_mm + 0.2, 4.0};

// Draws part of a storey as one of several sheets at 1 to 200. Neighbouring sheets share a strip, so the tests ignore
// the rim of a sheet and check that place on the neighbouring sheet.
constexpr double kPerMetre_mm = 5.0, kSheet_mm = 400.0, kRim_mm = 30.0;
struct Drawn {
    explicit Drawn(const Storey& storey) : Drawn(storey, storey.min_m, storey.max_m) {}
    Drawn(const Storey& storey, const Vec2& min_m, const Vec2& max_m, double per_metre_mm = kPerMetre_mm) {
        const Vec2 size = (max_m - min_m) * per_metre_mm;
        on_paper = {min_m, Vec2(10.0), per_metre_mm};
        walls = ink_of_walls(storey, on_paper, size.x + 20.0, size.y + 20.0, kLook);
    }
    OnPaper on_paper;
    WallInk walls;
};

TEST(Openings, are_checked_for_missing_walls_and_closed_doorways_and_repaired) {
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
    // mend_openings() must open the closed doorway and close the gap in the wall.
    EXPECT_EQ(mend_openings(shut.walls.ink, closed, shut.on_paper, kLook).opened, 1U);
    EXPECT_TRUE(check_openings(shut.walls.ink, closed, shut.on_paper).lacking.empty());
    EXPECT_EQ(mend_openings(leaks.walls.ink, open, leaks.on_paper, kLook).closed.size(), 1U);
    EXPECT_TRUE(check_openings(leaks.walls.ink, open, leaks.on_paper).leaking.empty());
}

TEST(Openings, beside_a_flight_of_stairs_need_no_wall) {
    Storey open = two_rooms();
    open.walls_m.pop_back();
    open.rooms[1].kind = RoomKind::Stairs;
    const Drawn drawn(open);
    EXPECT_TRUE(check_openings(drawn.walls.ink, open, drawn.on_paper).leaking.empty());
}

TEST(Openings, that_run_around_a_corner_have_no_bar) {
    // The kitchen is around two sides of the other room, without a wall between them.
    Storey open = two_rooms();
    open.walls_m.resize(4);
    open.gaps.clear();
    open.things.clear();
    open.rooms[0].loops_m = {{{0.25, 0.25}, {5.0, 0.25}, {5.0, 2.0}, {8.95, 2.0}, {8.95, 3.75}, {0.25, 3.75}}};
    open.rooms[0].max_m = {8.95, 3.75};
    open.rooms[1].loops_m = {{{5.0, 0.25}, {8.95, 0.25}, {8.95, 2.0}, {5.0, 2.0}}};
    open.rooms[1].min_m = {5.0, 0.25};
    open.rooms[1].max_m = {8.95, 2.0};
    open.rooms[1].middle_m = {7.0, 1.1};
    open.portals = {{PassageKind::Opening, {0, 1}, {5.0, 1.0}, 1.5}};
    lay_floor(open);
    const Drawn closed(open);
    EXPECT_FALSE(check_openings(closed.walls.ink, open, closed.on_paper).leaking.empty());
    StoreyCrossings crossings{{0, 1}, {}};
    for (double y = 0.3; y < 2.0; y += 0.2) crossings.places_m.emplace_back(5.0, y);
    for (double x = 5.1; x < 8.9; x += 0.2) crossings.places_m.emplace_back(x, 2.0);
    open.crossings = {crossings};
    const Drawn drawn(open);
    EXPECT_TRUE(check_openings(drawn.walls.ink, open, drawn.on_paper).leaking.empty());
}

TEST(Openings, to_another_storey_have_no_bar) {
    Storey open = two_rooms();
    open.walls_m.pop_back();
    const Drawn drawn(open);
    ASSERT_FALSE(check_openings(drawn.walls.ink, open, drawn.on_paper).leaking.empty());
    open.exits.push_back({PassageKind::Opening, 0, "Cellar", {6.1, 3.2}, 1.5});
    EXPECT_TRUE(check_openings(drawn.walls.ink, open, drawn.on_paper).leaking.empty());
}

// Returns whether an opening is correct on a sheet of a larger scale. The function is needed because some openings are
// too small to be drawn at 1 to 200.
bool is_right_at_a_larger_scale(const Storey& storey, const std::array<std::uint32_t, 2>& rooms, const Vec2& at) {
    constexpr double kAround_m = 8.0, kLooked_m = 4.0, kLarge_mm = 20.0;
    Drawn drawn(storey, glm::max(storey.min_m, at - Vec2(kAround_m)), glm::min(storey.max_m, at + Vec2(kAround_m)),
                kLarge_mm);
    mend_openings(drawn.walls.ink, storey, drawn.on_paper, kLook);
    const OpeningCheck found = check_openings(drawn.walls.ink, storey, drawn.on_paper);
    const auto is_it = [&](const WrongOpening& wrong) {
        return wrong.rooms == rooms && glm::distance(drawn.on_paper.world(wrong.at_mm), at) < kLooked_m;
    };
    return std::none_of(found.lacking.begin(), found.lacking.end(), is_it) &&
           std::none_of(found.leaking.begin(), found.leaking.end(), is_it);
}

void are_those_of_the_graph(const std::string& file, const Storey& storey, const Vec2& low, const Vec2& high) {
    Drawn drawn(storey, low, high);
    mend_openings(drawn.walls.ink, storey, drawn.on_paper, kLook);
    const OpeningCheck found = check_openings(drawn.walls.ink, storey, drawn.on_paper);
    const auto reported = [&](const char* what, const WrongOpening& wrong) {
        const Vec2 at = drawn.on_paper.world(wrong.at_mm);
        for (const int axis : {0, 1}) {
            const double rim_m = kRim_mm / kPerMetre_mm;
            if (low[axis] > storey.min_m[axis] && at[axis] < low[axis] + rim_m) return;
            if (high[axis] < storey.max_m[axis] && at[axis] > high[axis] - rim_m) return;
        }
        if (is_right_at_a_larger_scale(storey, wrong.rooms, at)) return;
        ADD_FAILURE() << file << ", storey " << storey.number << (storey.upper ? ", upper floors: " : ": ")
                      << storey.rooms[wrong.rooms[0]].name << " and " << storey.rooms[wrong.rooms[1]].name << " "
                      << what << " at " << at.x << " " << at.y;
    };
    for (const WrongOpening& wrong : found.lacking) reported("lack their opening", wrong);
    for (const WrongOpening& wrong : found.leaking) reported("are open to each other", wrong);
}

void are_those_of_the_graph(const std::string& file) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "takes too long here";
    const NamedStoreys* world = storeys_of(file);
    if (!world) GTEST_SKIP() << needs_real_world(file);
    ASSERT_FALSE(world->storeys.empty());
    for (const Storey& storey : world->storeys) {
        const auto columns = [&](int axis) {
            const double size_mm = (storey.max_m - storey.min_m)[axis] * kPerMetre_mm;
            return std::max(1, static_cast<int>(std::ceil((size_mm - 2.0 * kRim_mm) / (kSheet_mm - 2.0 * kRim_mm))));
        };
        const Vec2 step = Vec2(kSheet_mm - 2.0 * kRim_mm) / kPerMetre_mm;
        for (int y = 0; y < columns(1); ++y)
            for (int x = 0; x < columns(0); ++x) {
                const Vec2 low = storey.min_m + Vec2(x, y) * step;
                const Vec2 high = glm::min(storey.max_m, low + Vec2(kSheet_mm / kPerMetre_mm));
                are_those_of_the_graph(file, storey, low, high);
            }
    }
}

struct OfWorld : testing::TestWithParam<const char*> {};
TEST_P(OfWorld, openings_agree_with_the_route_graph) { are_those_of_the_graph(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Openings, OfWorld,
                         testing::Values("house.map", "school.map", "first_room.map", "labyrinth1.map",
                                         "small_house.ifc", "institute.ifczip", "fzk-haus.ifc", "duplex-apartment.ifc",
                                         "smiley-west.ifc"));

// Each plan has a separate test, because reading plans starts threads.
struct OfPlan : testing::TestWithParam<const char*> {};
TEST_P(OfPlan, openings_agree_with_the_route_graph) { are_those_of_the_graph(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Openings, OfPlan, testing::Values("minimal.imdf.zip", "delft-station.osm"));

// Each world has a separate test, because the tests take minutes.
struct OfManyWorlds : testing::TestWithParam<const char*> {};
TEST_P(OfManyWorlds, openings_agree_with_the_route_graph) {
    if (!std::getenv("HANDRAIL_ALL_ROUTES")) GTEST_SKIP() << "takes minutes; HANDRAIL_ALL_ROUTES=1 tries it";
    are_those_of_the_graph(GetParam());
}
INSTANTIATE_TEST_SUITE_P(Openings, OfManyWorlds,
                         testing::Values("large-building.ifc", "office.map", "agdm01.map", "agtut01.map", "agtut03.map",
                                         "agtut05.map", "quake-start.map", "quake-dm3.map", "quake-e1m1.map",
                                         "wall-door-column-ifc4x3.ifc", "room.glb", "apb-tu-dresden.osm",
                                         "aachen-university.osm", "addenbrookes.imdf.zip", "cologne-central.osm",
                                         "london-waterloo.osm.pbf", "frankfurt-hauptwache.osm"));

}  // namespace openings_test
}  // namespace handrail::test
