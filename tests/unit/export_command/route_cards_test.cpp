// Tests that a route card prints exactly the legs of the route that a session announces to a person at the base.
#include "app/main/route_cards.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "app/core/context/context_words.h"
#include "app/core/session/session.h"
#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/walker.h"
#include "tests/support/every.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "worlds/base/language.h"
#include "worlds/navigation/directions_route.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace route_cards_test {

// Simulates a person at the base who chooses a route in the list of rooms and requests all its legs.
class Walker {
public:
    explicit Walker(const std::shared_ptr<const Scene>& scene) : session_(Settings{}, HandFacts{}) {
        session_.apply(WorldEntered{make_ready(scene)}, now_s_);
        tick(3);
    }
    void stand(const Vec3& feet_m, double heading_rad) {
        session_.apply(Placed{feet_m, heading_rad}, now_s_);
        tick(30);
    }
    std::string reported(const std::string& room) {
        request(Command::Routes);
        // A long list begins with its kinds, and a kind can be called as a room is.
        if (const std::string all = phrase("kinds.everything"); session_.dialogue().has_use_for(all))
            session_.apply(LineTyped{all}, now_s_);
        EXPECT_TRUE(session_.apply(LineTyped{room}, now_s_)) << room;
        tick(3);
        return request(Command::RestOfRoute);
    }

private:
    std::string request(Command command) {
        session_.apply(CommandDown{command}, now_s_);
        session_.apply(CommandUp{command}, now_s_);
        std::string last;
        for (CueRequest& cue : session_.take_cues())
            if (cue.kind == CueRequestKind::Say) last = cue.text;
        return last;
    }
    void tick(int times) {
        for (int i = 0; i < times; ++i) session_.tick(now_s_ += 1.0 / 60.0, ToolState{});
        session_.take_cues();
    }
    Session session_;
    double now_s_ = 0.0;
};

struct OfWorld : testing::TestWithParam<const char*> {};

TEST_P(OfWorld, the_route_cards_have_the_spoken_legs_to_the_rooms) {
    const std::string file = GetParam();
    std::filesystem::path path = test::project_root() / "worlds" / "maps" / file;
    if (!std::filesystem::exists(path)) {
        const auto real = real_world(file);
        if (!real) GTEST_SKIP() << needs_real_world(file);
        path = *real;
    }
    auto read = read_world(path);
    ASSERT_TRUE(read) << read.error().sentence();
    const auto scene = std::make_shared<const Scene>(std::move(*read));
    const WalkerSize size = walker_size(*scene, Settings{}.walk.body_radius_m);
    RoomsOfWorld rooms(scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m), at_once());
    ASSERT_TRUE(rooms.ready() && rooms.found());
    const Start* base = nullptr;
    for (const Start& start : scene->starts)
        if (!base || (start.base && !base->base)) base = &start;
    ASSERT_TRUE(base);
    Walker walker(scene);
    // A route to a room of a large building takes a second. HANDRAIL_ALL_ROUTES=1 compares those to all rooms.
    const std::uint32_t stride = file == "house.map" ? 1 : every(5, 5);
    std::uint32_t rooms_seen = 0;
    int compared = 0, legs = 0;
    for (int number = 1; number <= storey_count(rooms.graph()); ++number) {
        const auto storey = storey_of(*scene, rooms.graph(), rooms.navigation().space(), number);
        if (!storey) continue;
        const auto made = card_routes(scene, rooms.graph(), rooms.navigation(), *storey, {});
        if (!made) continue;
        for (const CardRoute& way : made->ways) {
            std::string name = way[0].substr(std::string("From the base to ").size());
            name = sentence_case(name.substr(0, name.size() - 1));
            const std::uint32_t here = room_at(rooms.graph(), rooms.navigation().space(), base->feet_m);
            if (here != kNothing && sentence_case(rooms.graph().rooms[here].name) == name)
                continue;  // the list has no route to the room where the person is
            if (rooms_seen++ % stride != 0) continue;
            walker.stand(rooms.navigation().nearest_place(base->feet_m).value_or(base->feet_m),
                         notch_heading_rad(nearest_notch(base->heading_rad)));
            EXPECT_EQ(fmt::format("{}", fmt::join(way.begin() + 2, way.end(), " ")), walker.reported(name)) << name;
            ++compared;
            for (const std::string& line : way) legs += line.find("until you meet") != std::string::npos ? 1 : 0;
        }
    }
    EXPECT_GE(compared, 4);
    EXPECT_GE(legs, compared);
}

INSTANTIATE_TEST_SUITE_P(RouteCards, OfWorld,
                         testing::Values("house.map", "school.map", "duplex-apartment.ifc", "institute.ifczip"));

}  // namespace route_cards_test
}  // namespace handrail::test
