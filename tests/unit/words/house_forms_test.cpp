// Tests the bundled house in five forms. Compares which of its rooms, doors and distances each form preserves, to 5 cm.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/unit/words/other_forms.h"
#include "tests/unit/words/words_text.h"
#include "worlds/exports/as_words.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace words_house_forms_test {

constexpr double kSame_m = 0.05 + 1e-9, kHalfWall_m = 0.1;

// Returns the name of a room without its storey. Stairs are one room per storey in some forms, and one room for all
// storeys in others.
std::string without_storey(const std::string& name) { return name.substr(0, name.find(", ")); }

struct Seen {
    std::shared_ptr<Navigation> ways;
    RoomGraph graph;
    Vec3 shift_m{0.0};  // shift of this form relative to the original house

    std::string room_at_m(const Vec3& place) const {
        const std::optional<Vec3> feet = ways->nearest_place(place + shift_m);
        const std::uint32_t room = feet ? room_at(graph, ways->space(), *feet) : kNothing;
        return room == kNothing ? "nowhere" : without_storey(graph.rooms[room].name);
    }
    std::optional<double> way_m(const Vec3& from, const Vec3& to) const {
        const Route route = ways->plan(from + shift_m, to + shift_m, RoutePreference::Shortest);
        if (route.points_m.empty() || glm::length(route.points_m.back() - to - shift_m) > 0.3) return std::nullopt;
        double length = 0.0;
        for (std::size_t p = 1; p < route.points_m.size(); ++p)
            length += glm::length(route.points_m[p] - route.points_m[p - 1]);
        return length;
    }
    std::pair<std::string, std::string> names(const Portal& portal) const {
        return std::minmax(without_storey(graph.rooms[portal.rooms[0]].name),
                           without_storey(graph.rooms[portal.rooms[1]].name));
    }
};

Seen seen_in(const Scene& scene) {
    Seen seen;
    auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    EXPECT_TRUE(ways.has_value()) << ways.error().sentence();
    if (!ways) return seen;
    seen.ways = *ways;
    seen.graph = make_rooms(scene, seen.ways->space());
    return seen;
}

// How much of the house a form preserves, and the largest deviations.
struct Carried {
    int rooms = 0, all_rooms = 0;  // rooms with the same place and name, of all rooms
    int doors = 0, all_doors = 0;  // doors between the same two rooms, of all doors
    // Largest deviations of doors: along their walls, across them, and of the width.
    double along_m = 0.0, across_m = 0.0, width_m = 0.0;
    // Number of route lengths between the middles of rooms on one storey that are the same in both forms, and number of
    // all these routes. The next line has the same numbers for routes between storeys.
    int ways = 0, all_ways = 0;
    int far = 0, all_far = 0;
    double longer_m = 0.0, shorter_m = 0.0;  // largest differences in length of routes on one storey
    double far_shorter_m = 0.0;
};

// Greatest difference of two route lengths that are treated as the same. On one storey, only a shorter route can fail;
// between storeys, a longer route can fail, too.
struct Apart {
    double level_m = kSame_m, far_m = kSame_m;
};

Carried carried(const Seen& house, const Seen& form, const Apart& apart = {}) {
    Carried found;
    std::vector<const Room*> rooms;
    for (const Room& room : house.graph.rooms) {
        if (room.kind == RoomKind::Stairs) continue;
        rooms.push_back(&room);
        ++found.all_rooms;
        found.rooms += form.room_at_m(room.middle_m) == without_storey(room.name) ? 1 : 0;
    }
    for (const Portal& portal : house.graph.portals) {
        if (portal.kind != PassageKind::Door) continue;
        ++found.all_doors;
        const Portal* best = nullptr;
        double least = 0.5;
        for (const Portal& other : form.graph.portals) {
            const double off = glm::length(other.place_m - form.shift_m - portal.place_m);
            if (other.kind == PassageKind::Door && form.names(other) == house.names(portal) && off < least)
                least = off, best = &other;
        }
        if (!best) continue;
        ++found.doors;
        const Vec3 off = glm::abs(best->place_m - form.shift_m - portal.place_m);
        found.along_m = std::max(found.along_m, std::min(off.x, off.y));
        found.across_m = std::max(found.across_m, std::max(off.x, off.y));
        found.width_m = std::max(found.width_m, std::abs(best->width_m - portal.width_m));
    }
    for (std::size_t a = 0; a < rooms.size(); ++a)
        for (std::size_t b = a + 1; b < rooms.size(); ++b) {
            const auto meant = house.way_m(rooms[a]->middle_m, rooms[b]->middle_m);
            if (!meant) continue;
            const auto is = form.way_m(rooms[a]->middle_m, rooms[b]->middle_m);
            const bool level = rooms[a]->level == rooms[b]->level;
            const bool same = is && *is - *meant <= (level ? kSame_m : apart.far_m) &&
                              *meant - *is <= (level ? apart.level_m : apart.far_m);
            ++(level ? found.all_ways : found.all_far);
            (level ? found.ways : found.far) += same ? 1 : 0;
            if (is && !level) found.far_shorter_m = std::max(found.far_shorter_m, *meant - *is);
            if (!is || !level) continue;
            found.longer_m = std::max(found.longer_m, *is - *meant);
            found.shorter_m = std::max(found.shorter_m, *meant - *is);
        }
    return found;
}

// Moves the outlines, which are exact to 5 cm, to the exact middles of walls.
WordsHouse on_the_middles_of_walls(WordsHouse house, const Scene& scene) {
    std::array<std::vector<double>, 2> middles;
    for (const Solid& solid : scene.solids) {
        const Vec3 size = solid.shape.bounds_m.size_m();
        if (solid.role != SolidRole::Solid || solid.feature || size.z < 1.5) continue;
        for (int axis = 0; axis < 2; ++axis)
            if (size[axis] < 0.5)
                middles[static_cast<std::size_t>(axis)].push_back(solid.shape.bounds_m.centre_m()[axis]);
    }
    for (WordsHouse::Room& room : house.rooms)
        for (std::vector<Vec2>& ring : room.rings)
            for (Vec2& p : ring)
                for (int axis = 0; axis < 2; ++axis) {
                    const double before = p[axis];
                    double least = 0.2;
                    for (const double middle : middles[static_cast<std::size_t>(axis)])
                        if (std::abs(middle - before) < least) least = std::abs(middle - before), p[axis] = middle;
                }
    // A door leaf is at one side of its wall, but the other forms know only the middle of the wall.
    for (WordsHouse::Door& door : house.doors) {
        const Vec2 hung = door.at_m;
        double least_m = 0.15;
        for (const std::size_t r : door.rooms)
            for (const std::vector<Vec2>& ring : house.rooms[r].rings)
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Vec2 way = ring[(i + 1) % ring.size()] - ring[i], off = hung - ring[i];
                    const double along = glm::dot(off, way) / glm::dot(way, way);
                    if (!(along > 0.0 && along < 1.0) || glm::length(off - way * along) >= least_m) continue;
                    least_m = glm::length(off - way * along);
                    door.at_m = ring[i] + way * along;
                }
    }
    return house;
}

// Returns the house without furniture. Of its things, only water remains.
std::string bare_house() {
    const std::string text = test::content_of(test::bundled_world("house.map"));
    std::string kept, entity;
    int depth = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string line = text.substr(from, end - from + 1);
        from = end + 1;
        entity += line;
        depth += line[0] == '{' ? 1 : line[0] == '}' ? -1 : 0;
        if (depth > 0) continue;
        const auto has = [&](const char* words) { return entity.find(words) != std::string::npos; };
        if (!has("\"classname\" \"thing\"") || has("\"cs_name\"")) kept += entity;
        entity.clear();
    }
    return kept;
}

TEST(HouseForms, carry_exactly_what_each_format_supports) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const Result<Scene> scene = read_quake_map(bare_house(), "house.map");
    ASSERT_TRUE(scene.has_value());
    const Seen house = seen_in(*scene);
    const WordsHouse drawn =
        on_the_middles_of_walls(found_house(*scene, house.graph, house.ways->space(), WordLanguage::English), *scene);
    const auto describe = [&](const char* name, Result<Scene> read, const Apart& apart = {}) {
        EXPECT_TRUE(read.has_value()) << name << ": " << (read ? "" : read.error().sentence());
        if (!read) return Carried{};
        EXPECT_TRUE(validate(*read).has_value());
        Seen form = seen_in(*read);
        if (std::string_view(name) == "OpenStreetMap") {
            const auto room = test::room_of(*read, drawn.rooms[0].name);
            Vec2 least(1e300);
            for (const Vec2& p : drawn.rooms[0].rings[0]) least = glm::min(least, p);
            form.shift_m = Vec3(test::box_of(*room).first - least, 0.0);
        }
        const Carried c = carried(house, form, apart);
        fmt::print(
            "{}: {} of {} rooms, {} of {} doors, off {:.3f} m along and {:.3f} m through the wall, width {:.3f} m, "
            "{} of {} ways on a storey, {:.3f} m longer and {:.3f} m shorter at most, {} of {} from storey to storey, "
            "{:.3f} m shorter at most\n",
            name, c.rooms, c.all_rooms, c.doors, c.all_doors, c.along_m, c.across_m, c.width_m, c.ways, c.all_ways,
            c.longer_m, c.shorter_m, c.far, c.all_far, c.far_shorter_m);
        // Each door of a form must be at its original place, and no route may be shorter than in the original.
        EXPECT_LE(c.along_m, kSame_m) << name;
        EXPECT_LE(c.width_m, kSame_m) << name;
        EXPECT_LE(c.shorter_m, apart.level_m) << name;
        return c;
    };
    const Carried itself = describe("itself", *scene);
    ASSERT_EQ(itself.all_rooms, 14);
    ASSERT_EQ(itself.all_doors, 11);
    ASSERT_GT(itself.all_ways, 40);
    ASSERT_GT(itself.all_far, 40);
    EXPECT_EQ(itself.rooms + itself.doors + itself.ways + itself.far,
              itself.all_rooms + itself.all_doors + itself.all_ways + itself.all_far);

    // The model states its stairs. A narrow foot is enough to walk on stated stairs, so routes may pass the stairs and
    // lead over them more closely.
    constexpr Apart kByStairs{0.25, 1.1};
    // An architect's model must preserve everything except the pond. The pond is no space with a floor, so it becomes
    // the steps that lead into it.
    for (const bool millimetres : {false, true}) {
        const Carried ifc = describe(millimetres ? "IFC in millimetres" : "IFC",
                                     read_ifc(test::IfcOf(*scene, drawn, millimetres).text(), "house.ifc"), kByStairs);
        EXPECT_GE(ifc.rooms, ifc.all_rooms - 1);
        EXPECT_EQ(ifc.doors, ifc.all_doors);
        EXPECT_LE(ifc.across_m, kSame_m);
        EXPECT_EQ(ifc.ways, ifc.all_ways);
        EXPECT_EQ(ifc.far, ifc.all_far);
    }
    // A mesh must preserve all distances, although it has no names and no doors.
    const Carried mesh = describe("mesh", read_gltf(test::glb_of(*scene), "house.glb"));
    EXPECT_EQ(mesh.rooms, 0);
    EXPECT_EQ(mesh.doors, 0);
    EXPECT_EQ(mesh.ways, mesh.all_ways);
    EXPECT_EQ(mesh.far, mesh.all_far);
    // Plans and room descriptions enclose stairs in a separate room, so routes on the same storey lead around that
    // room. Both forms make new stairs, so no route between storeys keeps its length. In room descriptions, the pond is
    // sunk and becomes the steps into it, as in the model. In a plan, nobody gets into the pond. The doors of both
    // forms are in the middle of walls, while the original leaves are at one side.
    const Carried words = describe("words", read_words(text_of(drawn, *scene, WordLanguage::English), "house.rooms"));
    EXPECT_GE(words.rooms, words.all_rooms - 1);
    EXPECT_EQ(words.doors, words.all_doors);
    EXPECT_LE(words.across_m, kSame_m + kHalfWall_m);
    EXPECT_GE(words.ways, 24);
    const Carried osm = describe("OpenStreetMap", read_osm(test::osm_of(drawn), "house.osm"));
    EXPECT_EQ(osm.rooms, osm.all_rooms);
    EXPECT_EQ(osm.doors, osm.all_doors);
    EXPECT_LE(osm.across_m, kSame_m + kHalfWall_m);
    EXPECT_GE(osm.ways, 24);
}

// The stairs of this house are laid out as room descriptions and plans lay them out, so that each form can preserve the
// whole house.
TEST(HouseForms, of_a_two_storey_house_agree_in_rooms_doors_and_routes_over_the_stairs) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "unit_osm starts the threads that read OpenStreetMap";
    const std::string text =
        "Building: House.\n"
        "Storey: Ground floor.\n"
        "Hall, 6 by 4 metres. Door outside in the south wall.\n"
        "Kitchen, 4 by 4 metres, west of Hall. Door to Hall.\n"
        "Stairwell, 3 by 6.5 metres, east of Hall, flush with its south end, stairs to Upper floor. Door to Hall.\n"
        "Storey: Upper floor.\n"
        "Gallery, 6 by 4 metres, above Hall. Door to Stairwell.\n"
        "Bedroom, 4 by 4 metres, west of Gallery. Door to Gallery.\n";
    const Result<Scene> scene = read_words(text, "house.rooms");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const Seen house = seen_in(*scene);
    const WordsHouse drawn = stated_house(*scene, WordLanguage::English),
                     german = stated_house(*scene, WordLanguage::German);
    std::vector<RoomName> names;
    for (const Room& room : house.graph.rooms)
        if (room.kind != RoomKind::Stairs) names.push_back({room.middle_m, room.name, {}});
    struct Form {
        const char* name;
        Result<Scene> read;
        bool states = true;
    };
    Form forms[] = {
        {"itself", *scene},
        {"words", read_words(text_of(drawn, *scene, WordLanguage::English), "house.rooms")},
        {"German words", read_words(text_of(german, *scene, WordLanguage::German), "house.rooms")},
        {"OpenStreetMap", read_osm(test::osm_of(drawn), "house.osm")},
        {"IFC", read_ifc(test::IfcOf(*scene, drawn, false).text(), "house.ifc")},
        {"IFC in millimetres", read_ifc(test::IfcOf(*scene, drawn, true).text(), "house.ifc")},
        {"map", read_quake_map(test::map_of(*scene, names), "house.map")},
        {"mesh", read_gltf(test::glb_of(*scene), "house.glb"), false},
    };
    for (Form& form : forms) {
        SCOPED_TRACE(form.name);
        ASSERT_TRUE(form.read.has_value()) << form.read.error().sentence();
        Seen seen = std::string_view(form.name) == "itself" ? house : seen_in(*form.read);
        if (std::string_view(form.name) == "OpenStreetMap") {
            Vec2 least(1e300);
            for (const Vec2& p : drawn.rooms[0].rings[0]) least = glm::min(least, p);
            seen.shift_m = Vec3(test::box_of(*test::room_of(*form.read, drawn.rooms[0].name)).first - least, 0.0);
        }
        const Carried c = carried(house, seen);
        fmt::print(
            "{}: {} of {} rooms, {} of {} doors, off {:.3f} and {:.3f} m, width {:.3f} m, {} of {} ways, {} of {} "
            "far\n",
            form.name, c.rooms, c.all_rooms, c.doors, c.all_doors, c.along_m, c.across_m, c.width_m, c.ways, c.all_ways,
            c.far, c.all_far);
        EXPECT_EQ(c.rooms, form.states ? c.all_rooms : 0);
        EXPECT_EQ(c.doors, form.states ? c.all_doors : 0);
        EXPECT_LE(c.along_m, kSame_m);
        EXPECT_LE(c.across_m, kSame_m);
        EXPECT_LE(c.width_m, kSame_m);
        EXPECT_EQ(c.ways, c.all_ways);
        EXPECT_EQ(c.far, c.all_far);
        if (std::string_view(form.name) == "itself") {
            EXPECT_GE(c.all_rooms, 5);
            EXPECT_EQ(c.all_doors, 5);
            EXPECT_GE(c.all_ways, 5);
            EXPECT_GE(c.all_far, 6);
        }
    }
}

}  // namespace words_house_forms_test
}  // namespace handrail
