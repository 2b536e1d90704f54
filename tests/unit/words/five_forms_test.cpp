// Tests one house in five forms. The first is an architect's model in metres and in millimetres. The others are made
// from that model: a map, OpenStreetMap, a mesh and room descriptions. Each form must have the same rooms, doors,
// routes and distances.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/words/other_forms.h"
#include "tests/unit/words/words_text.h"
#include "worlds/exports/as_words.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace words_five_forms_test {

std::string ifc_text(const std::string& name) {
    return test::content_of(test::project_root() / "tests/unit/ifc/worlds" / name);
}

Scene world_of(Result<Scene> read) {
    EXPECT_TRUE(read.has_value()) << read.error().sentence();
    if (!read) return {};
    EXPECT_TRUE(validate(*read).has_value());
    return std::move(*read);
}

// A passage between two of the places.
struct Join {
    std::pair<int, int> places;
    PassageKind kind = PassageKind::Opening;
    Vec2 at_m{0.0};
    double width_m = 0.0;
};

struct Seen {
    std::vector<std::string> rooms;  // names of the rooms at the places
    std::vector<Join> joins;
    std::vector<double> way_m;  // route lengths from place to place
    std::size_t in_all = 0;
};

// The places are in front of the front door, in the kitchen and in the living room, measured in the architect's model.
const std::vector<Vec3> kPlaces{{1.5, -1.2, 0.0}, {1.2, 3.0, 0.0}, {7.2, 0.8, 0.0}};
constexpr double kSame_m = 0.05 + 1e-9;
constexpr double kHalfWall_m = 0.1, kBodyRadius_m = 0.25;
// In OpenStreetMap, rooms touch one another and the thickness of walls is unknown. So a route may pass the edges of a
// door frame more closely than in the other forms, whose walls are thicker.
constexpr double kThinWalls_m = 0.1;

Seen seen_in(const Scene& scene, const Vec3& shift_m = Vec3(0.0)) {
    Seen seen;
    const auto ways = Navigation::make(scene, walker_measures(scene, kBodyRadius_m, 1.8, 0.25));
    EXPECT_TRUE(ways.has_value()) << ways.error().sentence();
    if (!ways) return seen;
    const RoomGraph graph = make_rooms(scene, (*ways)->space());
    std::vector<std::uint32_t> at;
    for (const Vec3& place : kPlaces) {
        at.push_back(room_at(graph, (*ways)->space(), (*ways)->nearest_place(place + shift_m).value_or(place)));
        seen.rooms.push_back(at.back() == kNothing ? "nowhere" : graph.rooms[at.back()].name);
    }
    seen.in_all = graph.rooms.size();
    for (const Portal& portal : graph.portals) {
        const auto a = std::find(at.begin(), at.end(), portal.rooms[0]),
                   b = std::find(at.begin(), at.end(), portal.rooms[1]);
        if (a == at.end() || b == at.end()) continue;
        seen.joins.push_back({std::minmax(static_cast<int>(a - at.begin()), static_cast<int>(b - at.begin())),
                              portal.kind, Vec2(portal.place_m - shift_m), portal.width_m});
    }
    std::sort(seen.joins.begin(), seen.joins.end(), [](const Join& a, const Join& b) { return a.places < b.places; });
    for (std::size_t i = 0; i < kPlaces.size(); ++i)
        for (std::size_t k = i + 1; k < kPlaces.size(); ++k) {
            const Route route = (*ways)->plan(kPlaces[i] + shift_m, kPlaces[k] + shift_m, RoutePreference::Shortest);
            double length = 0.0;
            for (std::size_t p = 1; p < route.points_m.size(); ++p)
                length += glm::length(route.points_m[p] - route.points_m[p - 1]);
            seen.way_m.push_back(length);
        }
    return seen;
}

Vec2 least_corner(const std::vector<Vec2>& ring) {
    Vec2 least(1e300);
    for (const Vec2& p : ring) least = glm::min(least, p);
    return least;
}

TEST(FiveForms, of_one_house_have_the_same_rooms_doors_routes_and_distances) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const Scene ifc = world_of(read_ifc(ifc_text("small_house.ifc"), "house.ifc"));
    const WordsHouse house = test::to_the_middle_of_walls(stated_house(ifc, WordLanguage::English));
    const Seen model = seen_in(ifc);
    ASSERT_EQ(model.in_all, 3U);
    ASSERT_EQ(model.rooms[1], "Küche");
    ASSERT_EQ(model.rooms[2], "Living room");
    ASSERT_EQ(model.joins.size(), 2U);
    ASSERT_EQ(model.joins[0].places, std::pair(0, 1));
    ASSERT_EQ(model.joins[1].places, std::pair(1, 2));
    ASSERT_GT(model.way_m[1], 6.0);

    const Scene osm = world_of(read_osm(test::osm_of(house), "house.osm"));
    ASSERT_EQ(house.rooms[0].name, "Küche");
    const Vec2 corner = test::box_of(*test::room_of(osm, "Küche")).first;
    struct Form {
        const char* name;
        Scene scene;
        bool states = true;  // true: the file states rooms and doors; false: the program finds both, as in a mesh
        Vec3 shift_m{0.0};   // the zero of OpenStreetMap is the middle of the drawing
        double ways_m = kSame_m;
    };
    std::vector<Form> forms;
    forms.push_back({"millimetres", world_of(read_ifc(ifc_text("small_house_millimetres.ifc"), "house.ifc"))});
    forms.push_back({"map", world_of(read_quake_map(test::map_of(ifc), "house.map"))});
    forms.push_back(
        {"OpenStreetMap", osm, true, Vec3(corner - least_corner(house.rooms[0].rings[0]), 0.0), kThinWalls_m});
    forms.push_back({"mesh", world_of(read_gltf(test::glb_of(ifc), "house.glb")), false});
    forms.push_back({"words", test::read_rooms(text_of(house, ifc, WordLanguage::English))});
    forms.push_back({"German words", test::read_rooms(text_of(house, ifc, WordLanguage::German))});
    for (const Form& form : forms) {
        SCOPED_TRACE(form.name);
        const Seen seen = seen_in(form.scene, form.shift_m);
        EXPECT_EQ(seen.in_all, model.in_all);
        if (form.states) {
            EXPECT_EQ(seen.rooms[1], model.rooms[1]);
            EXPECT_EQ(seen.rooms[2], model.rooms[2]);
        }
        EXPECT_EQ(seen.joins.size(), model.joins.size());
        for (std::size_t j = 0; j < std::min(seen.joins.size(), model.joins.size()); ++j) {
            const Join &is = seen.joins[j], &meant = model.joins[j];
            EXPECT_EQ(is.places, meant.places);
            EXPECT_EQ(is.kind, form.states ? PassageKind::Door : PassageKind::Opening);
            // If the file states no door, the program finds the narrow place. That place is in the middle of the
            // doorway's width, but may be in front of the wall by up to the radius of a walker's body.
            const Vec2 off = glm::abs(is.at_m - meant.at_m);
            const double before_wall_m = form.states ? 0.0 : kHalfWall_m + kBodyRadius_m;
            EXPECT_LE(std::min(off.x, off.y), kSame_m) << form.name;
            EXPECT_LE(std::max(off.x, off.y), kSame_m + before_wall_m)
                << is.at_m.x << " " << is.at_m.y << " for " << meant.at_m.x << " " << meant.at_m.y;
            if (form.states) {
                EXPECT_NEAR(is.width_m, meant.width_m, kSame_m);
            }
        }
        ASSERT_EQ(seen.way_m.size(), model.way_m.size());
        for (std::size_t i = 0; i < seen.way_m.size(); ++i) EXPECT_NEAR(seen.way_m[i], model.way_m[i], form.ways_m);
    }
}

}  // namespace words_five_forms_test
}  // namespace handrail
