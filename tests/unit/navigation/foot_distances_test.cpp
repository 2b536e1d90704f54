// Tests walking distances from doorway to doorway. All pairs by the Floyd-Warshall algorithm are the reference.
#include "worlds/navigation/foot_distances.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace handrail {
namespace foot_distances_test {

constexpr double kNever_m = std::numeric_limits<double>::infinity();

RoomGraph random_building(std::mt19937& random, int rooms, int portals) {
    RoomGraph graph;
    graph.rooms.resize(static_cast<std::size_t>(rooms));
    std::uniform_real_distribution<double> at(-30.0, 30.0);
    for (int i = 0; i < portals; ++i) {
        Portal portal;
        const auto any = [&] { return static_cast<std::uint32_t>(random() % static_cast<unsigned>(rooms)); };
        portal.rooms = {any(), random() % 16 == 0 ? kNothing : any()};
        portal.place_m = {at(random), at(random), random() % 4 == 0 ? 3.0 : 0.0};
        portal.one_way = random() % 5 == 0;
        graph.portals.push_back(portal);
    }
    return graph;
}

// Returns the shortest distance over all places at once. Each doorway gives two of the places, one for the room on each
// side.
double shortest_m(const RoomGraph& graph, std::uint32_t from, const Vec3& from_m, std::uint32_t to, const Vec3& to_m) {
    struct Place {
        std::uint32_t room;
        Vec3 at_m;
    };
    std::vector<Place> places{{from, from_m}, {to, to_m}};
    for (const Portal& portal : graph.portals)
        for (const std::uint32_t room : portal.rooms) places.push_back({room, portal.place_m});
    const std::size_t n = places.size();
    std::vector<double> d(n * n, kNever_m);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (places[i].room == places[j].room && places[i].room != kNothing)
                d[i * n + j] = glm::length(places[i].at_m - places[j].at_m);
    for (std::size_t p = 0; p < graph.portals.size(); ++p) {
        const std::size_t first = 2 + 2 * p, second = first + 1;
        if (graph.portals[p].rooms[0] == kNothing || graph.portals[p].rooms[1] == kNothing) continue;
        d[first * n + second] = 0.0;
        if (!graph.portals[p].one_way) d[second * n + first] = 0.0;
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) d[i * n + j] = std::min(d[i * n + j], d[i * n + k] + d[k * n + j]);
    return d[1];
}

// Returns the distance through these portals, one after the other.
double through_m(const RoomGraph& graph, const std::vector<std::uint32_t>& portals, Vec3 at_m, const Vec3& to_m) {
    double all_m = 0.0;
    for (const std::uint32_t p : portals) {
        all_m += glm::length(graph.portals[p].place_m - at_m);
        at_m = graph.portals[p].place_m;
    }
    return all_m + glm::length(to_m - at_m);
}

TEST(FootDistances, are_correct_for_all_pairs_of_doorways_in_random_buildings) {
    std::random_device seeds;
    const unsigned seed = seeds();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    int reached = 0, not_reached = 0;
    for (int building = 0; building < 60; ++building) {
        const int rooms = 1 + static_cast<int>(random() % 8);
        const RoomGraph graph = random_building(random, rooms, static_cast<int>(random() % 14));
        const Vec3 from_m(1.0, 2.0, 0.0), to_m(-4.0, 7.0, 3.0);
        for (std::uint32_t from = 0; from < graph.rooms.size(); ++from) {
            const FootDistances on_foot(graph, from, from_m);
            for (std::uint32_t to = 0; to < graph.rooms.size(); ++to) {
                const auto reported = on_foot.to(to, to_m);
                const double twin_m = shortest_m(graph, from, from_m, to, to_m);
                ASSERT_EQ(reported.has_value(), twin_m < kNever_m);
                EXPECT_NEAR(reported.value_or(0.0), reported ? twin_m : 0.0, 1e-9);
                const std::vector<std::uint32_t> portals = on_foot.portals_to(to, to_m);
                if (reported) EXPECT_NEAR(through_m(graph, portals, from_m, to_m), twin_m, 1e-9);
                else EXPECT_TRUE(portals.empty());
                ++(reported ? reached : not_reached);
            }
        }
    }
    EXPECT_GT(reached, 100);
    EXPECT_GT(not_reached, 10);
}

TEST(FootDistances, from_an_unreachable_start_reach_nothing) {
    RoomGraph graph;
    graph.rooms.resize(2);
    graph.portals.push_back({.rooms = {0, 1}});
    const FootDistances on_foot(graph, kNothing, {});
    EXPECT_FALSE(on_foot.to(0, {}));
    EXPECT_FALSE(on_foot.to_portal(0));
    EXPECT_FALSE(on_foot.to_portal(7));
    EXPECT_FALSE(on_foot.to(9, {}));
    EXPECT_TRUE(on_foot.portals_to(0, {}).empty());
    EXPECT_TRUE(on_foot.portals_to(9, {}).empty());
}

}  // namespace foot_distances_test
}  // namespace handrail
