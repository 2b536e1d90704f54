// Tests the commands for a person who is lost, and for a person who wants to know a place before going there.
#include <gmock/gmock.h>

#include <cmath>

#include "app/core/dialogue/brief_words.h"
#include "app/core/whereabouts/room_words.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace far_places_test {

using test::AppSession;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kLanguages[] = {"en", "de"};

struct Visitor : AppSession {
    explicit Visitor(const char* world) {
        app.apply(WorldEntered{make_ready(test::our_world(world))}, 0.0);
        run(0.1);
        request(Command::Exits);
        run(0.1);
    }
    // Returns the description of the room that `room` chooses in the list.
    std::string describe(const std::string& room) {
        request(Command::Describe);
        EXPECT_TRUE(app.dialogue().is_open());
        return line(room);
    }
};

TEST(IAmLost, turns_to_the_nearest_wall_and_names_the_room_the_wall_and_the_way_back) {
    for (const char* language : kLanguages) {
        const test::InLanguage spoken(language);
        Visitor s("house.map");
        const Vec3 requested_m = s.app.feet_m();
        s.request(Command::WhereAmI);
        s.walk(3.0);
        s.tap(Command::FreeLeft, 0.3);
        ASSERT_GT(glm::length(s.app.feet_m() - requested_m), 2.0);
        const Vec3 stood_m = s.app.feet_m();
        const std::string said = s.request(Command::Lost);
        s.run(2.0);
        EXPECT_EQ(s.app.feet_m(), stood_m) << "nobody is moved";
        const double quarter = s.app.heading_rad() / (0.5 * kPi);
        EXPECT_NEAR(quarter, std::round(quarter), 1e-6) << "walls of the house stand square";
        EXPECT_THAT(said, HasSubstr(fine_compass_word(s.app.heading_rad()))) << said;
        EXPECT_LE(count_words(said), 35U) << said;
        const std::string turned = phrase("lost.turned", {{"wall", "|"}, {"distance", "|"}});
        EXPECT_THAT(said, HasSubstr(turned.substr(0, turned.find('|')))) << said;
        const std::string back =
            phrase("lost.last_known", {{"place", "|"}, {"distance", ""}, {"direction", ""}, {"key", ""}});
        EXPECT_THAT(said, HasSubstr(back.substr(0, back.find('|')))) << said;
        // The key that the announcement names also leads to the last known place.
        EXPECT_THAT(said, HasSubstr(s.app.keys().keys_of(Command::Retrace))) << said;
        s.hold(Command::Retrace, 6.0);
        EXPECT_LT(glm::length(s.app.feet_m() - requested_m), 0.5);
    }
}

TEST(IAmLost, names_the_last_known_place_or_else_the_base) {
    Visitor s("house.map");
    EXPECT_THAT(s.request(Command::Lost), HasSubstr(phrase("lost.at_base")));
    Visitor far("house.map");
    far.app.apply(Placed{far.app.feet_m() + Vec3(0.0, 3.0, 0.0), 0.0}, far.now);
    far.run(0.2);
    EXPECT_THAT(far.request(Command::Lost),
                HasSubstr("Last known place: where you last heard your position, in Hall. On foot "))
        << "the exits were asked for there";
}

TEST(DescribeRoom, gives_size_exits_by_wall_and_furniture_clockwise_from_a_distance) {
    for (const char* language : kLanguages) {
        const test::InLanguage spoken(language);
        Visitor s("house.map");
        s.request(Command::Describe);
        const std::vector<ListItem> rooms = s.app.dialogue().view().items;
        ASSERT_GT(rooms.size(), 8U);
        EXPECT_EQ(rooms.front().value, phrase("describe.here")) << "the room one is in comes first";
        s.app.apply(KeyTapped{"Escape"}, s.now);
        int furnished = 0;
        for (std::size_t i = 0; i < rooms.size(); ++i) {
            const Vec3 stood_m = s.app.feet_m();
            const std::string said = s.describe(std::to_string(i + 1));
            EXPECT_EQ(s.app.feet_m(), stood_m);
            EXPECT_EQ(said.rfind(rooms[i].name, 0), 0U) << said;
            EXPECT_LE(count_words(said), 120U) << said;
            // The walls are listed clockwise.
            std::size_t at = 0;
            for (const char* wall : {"north wall", "east wall", "south wall", "west wall"}) {
                const std::string label = sentence_case(spoken_kind(wall)) + ": ";
                const std::size_t found = said.find(label);
                if (found == std::string::npos) continue;
                EXPECT_GT(found, at) << said;
                at = found;
                ++furnished;
            }
        }
        EXPECT_GT(furnished, 10) << language;
    }
}

TEST(DescribeRoom, names_each_thing_and_its_place) {
    Visitor s("house.map");
    const std::string kitchen = s.describe("kitchen");
    EXPECT_THAT(kitchen, HasSubstr("Kitchen: "));
    EXPECT_THAT(kitchen, HasSubstr(" metres, "));
    EXPECT_THAT(kitchen, HasSubstr("exit"));
    EXPECT_THAT(kitchen, HasSubstr("It is on storey 1"));
}

TEST(Overview, gives_storeys_shape_and_neighbours_in_three_sentences) {
    for (const char* world : {"house.map", "school.map"}) {
        Visitor s(world);
        for (const char* language : kLanguages) {
            const test::InLanguage spoken(language);
            s.run(0.1);  // In this tick, the rooms get their names again.
            const std::string said = s.request(Command::Overview);
            std::size_t stops = 0;
            for (std::size_t i = 0; i < said.size(); ++i)
                stops += said[i] == '.' && (i + 1 == said.size() || said[i + 1] == ' ') ? 1 : 0;
            EXPECT_EQ(stops, 3U) << said;
            EXPECT_LE(count_words(said), 110U) << said;
            EXPECT_EQ(said.rfind(sentence_case(spoken_name(*s.app.scene())), 0), 0U) << said;
        }
    }
    Visitor s("house.map");
    const std::string said = s.request(Command::Overview);
    EXPECT_THAT(said, HasSubstr(" adjoins "));
    EXPECT_THAT(said, HasSubstr("2 storeys"));
}

Aabb box(double x0, double y0, double x1, double y1) { return {{x0, y0, 0.0}, {x1, y1, 3.0}}; }

TEST(OutlineOf, distinguishes_a_rectangle_an_l_and_a_courtyard) {
    EXPECT_EQ(outline_of({box(0, 0, 5, 8), box(5, 0, 10, 8)}).shape, OutlineShape::Rectangle);
    // The room has the shape of a square without one quarter. Each quarter in turn is missing.
    const Aabb quarters[] = {box(5, 5, 10, 10), box(5, 0, 10, 5), box(0, 0, 5, 5), box(0, 5, 5, 10)};
    for (int missing = 0; missing < 4; ++missing) {
        std::vector<Aabb> boxes;
        for (int i = 0; i < 4; ++i)
            if (i != missing) boxes.push_back(quarters[i]);
        const Outline outline = outline_of(boxes);
        EXPECT_EQ(outline.shape, OutlineShape::CornerMissing) << missing;
        EXPECT_EQ(outline.corner, missing);
    }
    EXPECT_EQ(outline_of({box(0, 0, 12, 3), box(0, 9, 12, 12), box(0, 3, 3, 9), box(9, 3, 12, 9)}).shape,
              OutlineShape::Court);
    EXPECT_EQ(outline_of({box(0, 0, 12, 2), box(5, 2, 7, 12)}).shape, OutlineShape::Irregular) << "a T";
}

}  // namespace far_places_test
}  // namespace handrail
