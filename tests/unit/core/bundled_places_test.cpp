// Tests that the house and the school can be learnt: every door leads from one room to another, every room has a
// landmark, and the walker cannot leave the grounds.
#include <algorithm>
#include <map>
#include <set>

#include "app/core/learning/hunt.h"
#include "app/core/learning/learning.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/house_and_school.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"

#include <gtest/gtest.h>

namespace handrail {
namespace bundled_places_test {

class BundledPlaces : public testing::TestWithParam<const char*> {};

TEST_P(BundledPlaces, every_door_leads_on_and_every_room_has_a_landmark) {
    auto read = read_world(test::project_root() / "worlds" / "maps" / GetParam());
    ASSERT_TRUE(read);
    const auto shut = std::make_shared<const Scene>(*read);
    Scene without = *read;
    std::erase_if(without.solids, [&](const Solid& solid) {
        const Feature* feature = read->find(solid.feature);
        return solid.role == SolidRole::Mover && feature && feature->kind == FeatureKind::Door;
    });
    const auto open = std::make_shared<const Scene>(std::move(without));
    const WalkerWorld open_world(open), shut_world(shut);
    const WalkerSize body = walker_size(*shut, 0.25);
    const auto base = std::find_if(shut->starts.begin(), shut->starts.end(), [](const Start& s) { return s.base; });
    ASSERT_NE(base, shut->starts.end());
    const HuntGround ground(open_world, base->feet_m, body);

    auto space = make_walk_space(*shut, walker_measures(*shut, body.radius_m, body.height_m, body.step_up_m));
    ASSERT_TRUE(space);
    const RoomGraph graph = make_rooms(*shut, *space);

    int doors = 0;
    std::set<std::uint32_t> beside;  // the rooms on either side of a door
    for (const Feature& door : shut->features) {
        if (door.kind != FeatureKind::Door) continue;
        ++doors;
        const Vec3 middle = door.bounds_m.centre_m(), size = door.bounds_m.size_m();
        const Vec3 across = size.x > size.y ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
        for (const double side : {-0.6, 0.6}) {
            const Vec3 feet = Vec3(middle.x, middle.y, door.bounds_m.min_m.z) + across * side;
            EXPECT_TRUE(ground.way_m(feet)) << door.name << " on side " << side << " cannot be walked to";
            beside.insert(room_at(graph, *space, feet));
        }
    }
    EXPECT_FALSE(beside.contains(kNothing));
    std::vector<Place> rooms;
    for (const std::uint32_t room : beside) rooms.push_back(place_of_room(shut_world, *space, graph, room));
    std::cout << GetParam() << ": " << doors << " doors, " << rooms.size() << " rooms, " << ground.size()
              << " places to stand\n";
    EXPECT_GE(doors, 11);
    EXPECT_GE(rooms.size(), 10U);
    for (const Place& room : rooms) {
        const auto stands_in = [&](const Feature& feature) {
            if (!feature.landmark || feature.kind == FeatureKind::Door || feature.bounds_m.empty()) return false;
            if (feature.bounds_m.min_m.z > room.origin_m.z + 2.5 || feature.bounds_m.max_m.z < room.origin_m.z - 0.3)
                return false;  // Skip a landmark on another storey. Stairs may end a riser below the floor.
            for (int y = 0; y < room.deep; ++y)
                for (int x = 0; x < room.wide; ++x) {
                    if (!room.is_free(x, y)) continue;
                    const Vec3 cell = room.middle_m(x, y);
                    const double dx =
                        std::max({feature.bounds_m.min_m.x - cell.x, 0.0, cell.x - feature.bounds_m.max_m.x});
                    const double dy =
                        std::max({feature.bounds_m.min_m.y - cell.y, 0.0, cell.y - feature.bounds_m.max_m.y});
                    if (dx + dy < 0.16) return true;
                }
            return false;
        };
        EXPECT_TRUE(std::any_of(shut->features.begin(), shut->features.end(), stands_in))
            << "no landmark in the room of " << room.area_m2() << " m2 from " << room.origin_m.x << ", "
            << room.origin_m.y << ", " << room.origin_m.z;
    }
    // The walker cannot leave the grounds.
    const Aabb all = shut->bounds_m;
    for (double s = 0.0; s <= 1.0; s += 0.05) {
        const Vec3 along = all.min_m + all.size_m() * s;
        for (const Vec3& outside : {Vec3(along.x, all.min_m.y - 0.9, 0.0), Vec3(along.x, all.max_m.y + 0.9, 0.0),
                                    Vec3(all.min_m.x - 0.9, along.y, 0.0), Vec3(all.max_m.x + 0.9, along.y, 0.0)})
            EXPECT_FALSE(ground.way_m(outside));
    }
}

// Every text of the map exists in every bundled language. If two things have different names in English, they also have
// different names in those languages.
TEST_P(BundledPlaces, names_exist_in_every_bundled_language) {
    const auto read = read_world(test::project_root() / "worlds" / "maps" / GetParam());
    ASSERT_TRUE(read);
    const auto has_all = [](const std::string& text, const OtherLanguages& others) {
        for (const LanguageName& language : bundled_languages())
            EXPECT_TRUE(
                language.code == "en" ||
                std::any_of(others.begin(), others.end(), [&](const TextIn& o) { return o.language == language.code; }))
                << text << " lacks " << language.code;
    };
    has_all(read->name, read->name_in);
    int named = 0;
    for (const Feature& feature : read->features) {
        if (!feature.made_name) has_all(feature.name, feature.name_in), ++named;
        if (!feature.message.empty() && !feature.made_message) has_all(feature.message, feature.message_in);
    }
    EXPECT_GE(named, 40);
    EXPECT_GE(read->room_names.size(), 8U);
    for (const RoomName& room : read->room_names) has_all(room.name, room.name_in);
    for (const SoundSource& sound : read->sounds)
        if (!sound.made_name) has_all(sound.name, sound.name_in);
    for (const LanguageName& language : bundled_languages()) {
        const test::InLanguage spoken(language.code);
        std::map<std::string, std::string> of_doors;
        for (const Feature& feature : read->features) {
            if (feature.kind != FeatureKind::Door) continue;
            EXPECT_EQ(of_doors.try_emplace(spoken_name(feature), feature.name).first->second, feature.name)
                << spoken_name(feature) << " names two doors";
        }
    }
}

// From every place that can be reached from the base, on foot, by stairs or over an edge, there is a route back to the
// base. So no pond or pit is a trap.
TEST_P(BundledPlaces, the_base_can_be_walked_to_again_from_every_reachable_place) {
    const auto read = read_world(test::project_root() / "worlds" / "maps" / GetParam());
    ASSERT_TRUE(read);
    const WalkerSize body = walker_size(*read, 0.25);
    const auto space = make_walk_space(*read, walker_measures(*read, body.radius_m, body.height_m, body.step_up_m));
    ASSERT_TRUE(space);
    const auto base = std::find_if(read->starts.begin(), read->starts.end(), [](const Start& s) { return s.base; });
    ASSERT_NE(base, read->starts.end());
    const std::uint32_t start = space->at(base->feet_m);
    ASSERT_NE(start, kNothing);
    std::vector<std::vector<std::uint32_t>> leads(space->spans.size()), comes(space->spans.size());
    const auto join = [&](std::uint32_t from, std::uint32_t to) {
        leads[from].push_back(to);
        comes[to].push_back(from);
    };
    for (std::uint32_t s = 0; s < space->spans.size(); ++s)
        for (const std::uint32_t next : space->spans[s].next)
            if (next != kNothing) join(s, next);
    for (const WalkLink& link : space->links) {
        join(link.from, link.to);
        if (link.both_ways) join(link.to, link.from);
    }
    const auto flood = [&](const std::vector<std::vector<std::uint32_t>>& onward) {
        std::vector<bool> reached(onward.size(), false);
        std::vector<std::uint32_t> open{start};
        reached[start] = true;
        while (!open.empty()) {
            const std::uint32_t here = open.back();
            open.pop_back();
            for (const std::uint32_t next : onward[here])
                if (!reached[next]) {
                    reached[next] = true;
                    open.push_back(next);
                }
        }
        return reached;
    };
    const std::vector<bool> there = flood(leads), back = flood(comes);
    std::size_t places = 0, lost = 0;
    for (std::uint32_t s = 0; s < space->spans.size(); ++s) {
        places += there[s];
        if (!there[s] || back[s] || ++lost > 5) continue;
        const Vec3 at = space->place_m(s);
        ADD_FAILURE() << "no way back from " << at.x << ", " << at.y << ", " << at.z;
    }
    EXPECT_EQ(lost, 0U);
    EXPECT_GT(places, 10000U);
    std::cout << GetParam() << ": " << places << " places, from each of which the base can be walked to\n";
}

INSTANTIATE_TEST_SUITE_P(Maps, BundledPlaces, testing::ValuesIn(test::house_and_school()), [](const auto& test) {
    return std::string(test.param).substr(0, std::string(test.param).find('.'));
});

}  // namespace bundled_places_test
}  // namespace handrail
