// Tests that answers have a limited number of words, in every room of the house and the school. Place and exits come
// first, and more follows only if the person asks again. The tests also check that "ahead" names what the walker would
// bump into.
#include <gmock/gmock.h>

#include <array>
#include <cctype>
#include <set>

#include "app/core/dialogue/brief_words.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/house_and_school.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace brevity_test {

using test::AppSession;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<const char*> kWorlds = test::house_and_school();
constexpr std::array kLanguages{"en", "de"};

// Splits a text into sentences, at full stops that are followed by a blank.
std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> all;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '.' && (i + 1 == text.size() || text[i + 1] == ' ')) {
            all.push_back(text.substr(begin, i + 1 - begin));
            begin = i + 2;
        }
    if (begin < text.size()) all.push_back(text.substr(begin));
    return all;
}

// Places the walker in the middle of each room, facing each of the four directions in turn.
template <class Each>
void in_every_room(const char* world, Each each) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world(world))}, 0.0);
    s.run(0.1);
    s.request(Command::Exits);  // The answer waits until the rooms are known.
    s.run(0.1);
    const auto rooms = s.app.view({}).rooms;
    ASSERT_TRUE(rooms);
    ASSERT_GT(rooms->size(), 5U);
    double heading_rad = 0.0;
    std::size_t number = 0;
    for (const DrawnRoom& room : *rooms) {
        if (!test::tried(number++, 4)) continue;
        s.app.apply(Placed{room.middle_m, heading_rad += 0.5 * kPi}, s.now);
        s.run(0.1);
        each(s, room);
    }
}

TEST(Brevity, where_am_i_takes_at_most_25_words_and_begins_with_the_room_and_the_heading) {
    for (const char* world : kWorlds)
        for (const char* language : kLanguages) {
            const test::InLanguage spoken(language);
            int all = 0, rooms = 0;
            in_every_room(world, [&](AppSession& s, const DrawnRoom&) {
                const std::string brief = s.request(Command::WhereAmI);
                EXPECT_LE(count_words(brief), 25U) << brief;
                EXPECT_EQ(brief.find(phrase("questions.place_facing", {{"place", ""}, {"compass", ""}}).substr(0, 2)),
                          sentences_of(brief).front().find(", "))
                    << brief;
                all += static_cast<int>(count_words(brief));
                ++rooms;
                const std::string more = s.request(Command::WhereAmI);
                EXPECT_NE(more, brief) << "asked again it tells the rest";
                EXPECT_EQ(s.request(Command::WhereAmI), brief) << "and then the same again";
            });
            EXPECT_LE(all, 22 * rooms) << world << " " << language;
        }
}

TEST(Brevity, each_exit_takes_at_most_four_words_beyond_its_name) {
    for (const char* world : kWorlds)
        for (const DirectionChoice directions :
             {DirectionChoice::Sides, DirectionChoice::Clock, DirectionChoice::Compass}) {
            Settings settings;
            settings.speech.directions = directions;
            AppSession s(settings);
            s.app.apply(WorldEntered{make_ready(test::our_world(world))}, 0.0);
            s.run(0.1);
            s.request(Command::Exits);
            for (int turn = 0; turn < test::scaled(16); ++turn) {
                s.tap(Command::TurnRight, 0.3);
                const std::vector<std::string> reported = sentences_of(s.request(Command::Exits));
                ASSERT_GT(reported.size(), 2U);
                for (std::size_t i = 2; i < reported.size(); ++i) {
                    const std::string where = reported[i].substr(reported[i].find(": ") + 1);
                    EXPECT_LE(count_words(where), 4U) << reported[i];
                    EXPECT_NE(reported[i].find(": "), std::string::npos) << reported[i];
                }
            }
        }
}

TEST(Brevity, entering_a_world_takes_at_most_35_words_and_says_what_to_do) {
    for (const char* world : kWorlds)
        for (const char* language : kLanguages)
            for (const ActsBy who : {ActsBy::WindowKeys, ActsBy::Lines}) {
                const test::InLanguage spoken(language);
                speak_to(who);
                AppSession s;
                s.app.apply(WorldEntered{make_ready(test::our_world(world))}, 0.0);
                s.listen();
                ASSERT_FALSE(s.said.empty());
                EXPECT_LE(count_words(s.said.front()), 35U) << s.said.front();
                EXPECT_THAT(s.said.front(), HasSubstr(phrase("session.begin_with_keys")));
                EXPECT_THAT(s.said.front(), HasSubstr(fine_compass_word(s.app.heading_rad())));
                speak_to(ActsBy::WindowKeys);
            }
}

TEST(Brevity, first_start_takes_at_most_40_words_before_the_first_key) {
    for (const char* language : {"en", "de"}) {
        const test::InLanguage spoken(language);
        AppSession s;
        s.app.apply(FirstMinutesBegun{phrase("voice.text_alone"), false}, 0.0);
        s.run(20.0);
        const std::string said = s.news();
        EXPECT_LE(count_words(said), 40U) << said;
        EXPECT_GE(count_words(said), 8U) << said;
    }
}

TEST(Brevity, help_is_a_list_by_topic_with_a_search) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.1);
    EXPECT_LE(count_words(s.request(Command::Help)), 12U);
    ASSERT_TRUE(s.app.dialogue().is_open());
    EXPECT_LE(s.app.dialogue().view().items.size(), 9U);
    EXPECT_THAT(s.line("search"), HasSubstr("Escape cancels"));
    s.line("beacon");
    ASSERT_TRUE(s.app.dialogue().is_open());
    for (const ListItem& item : s.app.dialogue().view().items) {
        const auto command = std::find_if(command_table().begin(), command_table().end(),
                                          [&](const CommandInfo& row) { return row.help().starts_with(item.name); });
        ASSERT_NE(command, command_table().end()) << item.name;
        EXPECT_TRUE(std::string(command->help()).find("eacon") != std::string::npos ||
                    command->word.find("beacon") != std::string::npos)
            << item.name;
    }
}

TEST(Brevity, ahead_names_the_thing_that_the_body_would_bump_into) {
    test::SceneBuilder builder;
    builder.box({-5, -5, -0.2}, {5, 5, 0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    builder.box({-5, 3, 0}, {5, 3.2, 2.6}, "north wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({-0.5, 2.8, 0.1}, {0.5, 3, 0.7}, "radiator", SolidRole::Solid, "metal", FeatureKind::Object);
    builder.box({4, -0.2, 1.5}, {4.2, 0.2, 2.6}, "shelf", SolidRole::Solid, "wood", FeatureKind::Object);
    builder.start({0, 0, 0}, 0.0);
    AppSession s;
    s.app.apply(WorldEntered{make_ready(builder.share())}, 0.0);
    s.run(0.1);
    EXPECT_THAT(s.request(Command::WhereAmI), HasSubstr("Ahead: radiator, 4 steps."));
    EXPECT_TRUE(s.request(Command::AheadOfMe).starts_with("Radiator, ")) << "lower than the eye that looks";
    s.walk(5.0);
    ASSERT_FALSE(s.bumped.empty());
    EXPECT_EQ(s.app.scene()->features[s.bumped.back().value].name, "radiator");
    s.tap(Command::Home, 0.3);
    s.tap(Command::TurnRight, 0.3);
    for (int i = 0; i < 3; ++i) s.tap(Command::TurnRight, 0.3);
    EXPECT_THAT(s.request(Command::WhereAmI), HasSubstr("Ahead: shelf, ")) << "at the height of the head";
}

TEST(Brevity, around_me_names_each_direction_only_once) {
    for (const char* world : kWorlds)
        in_every_room(world, [&](AppSession& s, const DrawnRoom&) {
            for (const std::string& sentence : sentences_of(s.request(Command::AroundMe)))
                for (const char* word : {"ahead", "left", "right", "behind"}) {
                    std::string lower = sentence;
                    std::transform(lower.begin(), lower.end(), lower.begin(),
                                   [](unsigned char c) { return std::tolower(c); });
                    const std::size_t first = lower.find(word);
                    if (first == std::string::npos) continue;
                    EXPECT_EQ(lower.find(word, first + 1), std::string::npos) << sentence;
                }
        });
}

TEST(FindList, lists_each_name_once_and_finds_it_by_any_word) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("school.map"))}, 0.0);
    s.run(0.1);
    s.request(Command::Exits);
    s.request(Command::Find);
    s.line("everything");
    std::set<std::string> names;
    for (const ListItem& item : s.app.dialogue().view().items) EXPECT_TRUE(names.insert(item.name).second) << item.name;
    const std::vector<ListItem> items = s.app.dialogue().view().items;
    const auto tables = std::find_if(items.begin(), items.end(), [](const ListItem& i) { return i.name == "Table"; });
    ASSERT_NE(tables, items.end());
    EXPECT_THAT(tables->value, HasSubstr(" of them, the nearest "));
    EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](const ListItem& item) {
        return item.value.find("Library") != std::string::npos;
    })) << "told with its room";
    EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](const ListItem& item) {
        return item.value.find("one storey above") != std::string::npos;
    })) << "and its storey";
    // Searches for a word that is not the first word of a name. If the word matches a group of things, the session asks
    // which one.
    EXPECT_THAT(s.line("desk"), HasSubstr("desk"));
    while (s.app.dialogue().is_open()) s.app.apply(KeyTapped{"Escape"}, s.now);
    s.listen();
    EXPECT_EQ(s.said.back(), "Closed");
    s.request(Command::Find);
    EXPECT_THAT(s.line("table"), HasSubstr("Table: which one? Table, "));
    s.app.apply(KeyTapped{"Enter"}, s.now);
    ASSERT_TRUE(s.app.guide().goal());
    EXPECT_EQ(s.app.guide().goal()->name, "Table");
}

TEST(FindList, can_be_narrowed_to_one_kind) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, 0.0);
    s.run(0.1);
    s.request(Command::Find);
    const std::size_t all = s.app.dialogue().view().items.size();
    s.line("end");
    EXPECT_EQ(s.line("right"), "doors");
    const std::vector<ListItem> doors = s.app.dialogue().view().items;
    EXPECT_LT(doors.size(), all);
    EXPECT_GE(doors.size(), 2U);
    for (std::size_t i = 0; i + 1 < doors.size(); ++i)
        EXPECT_TRUE(doors[i].name.find("oor") != std::string::npos || doors[i].name.find("ate") != std::string::npos)
            << doors[i].name;
    EXPECT_EQ(doors.back().value, "doors");
    EXPECT_EQ(s.line("left"), "everything");
    EXPECT_EQ(s.app.dialogue().view().items.size(), all);
}

TEST(Lists, answer_questions_but_otherwise_accept_only_their_items) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.1);
    s.request(Command::Marks);
    ASSERT_TRUE(s.app.dialogue().is_open());
    EXPECT_THAT(s.line("where"), HasSubstr("acing north"));
    EXPECT_TRUE(s.app.dialogue().is_open());
    EXPECT_THAT(s.line("forward"), HasSubstr("\"forward\" is not in this list."));
    EXPECT_TRUE(s.app.dialogue().is_open());
}

TEST(Lists, are_left_together_with_the_program_by_a_confirmed_quit) {
    for (const char* word : {"quit", "leave"}) {
        SCOPED_TRACE(word);
        AppSession s;
        s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
        s.run(0.1);
        s.request(Command::Marks);
        EXPECT_EQ(s.line(word), "Press Escape again to leave.");
        EXPECT_TRUE(s.app.dialogue().is_open());
        EXPECT_FALSE(s.app.requests().leave);
        EXPECT_EQ(s.line(word), "Goodbye.");
        EXPECT_TRUE(s.app.requests().leave);
    }
}

}  // namespace brevity_test
}  // namespace handrail
