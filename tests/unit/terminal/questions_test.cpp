// Tests that questions are understood as people phrase them. For each language, two readers who did not know the words
// in settings/languages wrote 300 phrasings, each with its meaning (phrasings/). The words were chosen with the first
// 200 in view. The other 100 were read only once, when the words were finished; then 94 English and 93 German ones were
// understood.
#include "app/core/dialogue/question.h"

#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "worlds/base/files.h"

namespace handrail {
namespace questions_test {

using ::testing::IsEmpty;

constexpr std::size_t kRead = 200;  // number of phrasings that were read while the words were chosen
constexpr std::size_t kRest = 100;
constexpr std::size_t kLeastOfRest = 85;  // how many of the rest must be understood

struct Phrasing {
    std::string meaning;  // "far Kitchen", "count doors"
    std::string typed;
};

// The names of the building for which the phrasings were written. Names that stand for a room and a thing are in both.
std::vector<NameInWorld> names(std::string_view language) {
    const std::map<NamedKind, std::string> english{
        {NamedKind::Room,
         "Hall|Study|Living room|Bathroom|Kitchen|Garden|Utility room|Child's room|Music room|Upper bathroom|Landing|"
         "Guest room|Bedroom|Pond|Stairs"},
        {NamedKind::Door,
         "Front door|Study door|Living room door|Bedroom door|Guest room door|Bathroom door|Upper bathroom door|"
         "Utility room door|Music room door|Child's room door|Garden door|Garden gate"},
        {NamedKind::Thing,
         "Coat stand|Stairs|Grandfather clock|Fireplace|Window|Desk|Globe|Low table|Double bed|Guest bed|Sofa|"
         "Wardrobe|Toilet|Bath tub|Bookcase|Wash basin|Filing cabinet|Toy chest|Letter box|Dining table|Shower|"
         "Music stand|Refrigerator|Kitchen counter|Piano|Washing machine|Sand pit|Bench|Apple tree|Pond"}};
    const std::map<NamedKind, std::string> german{
        {NamedKind::Room,
         "Diele|Arbeitszimmer|Wohnzimmer|Bad|Küche|Garten|Hauswirtschaftsraum|Kinderzimmer|Musikzimmer|oberes Bad|"
         "Galerie|Gästezimmer|Schlafzimmer|Teich|Treppe"},
        {NamedKind::Door,
         "Haustür|Arbeitszimmertür|Wohnzimmertür|Schlafzimmertür|Badtür|Gartentür|Gartentor|Kinderzimmertür"},
        {NamedKind::Thing,
         "Garderobenständer|Treppe|Standuhr|Kamin|Fenster|Schreibtisch|Globus|Doppelbett|Sofa|Kleiderschrank|Toilette|"
         "Badewanne|Bücherregal|Waschbecken|Aktenschrank|Spielzeugtruhe|Briefkasten|Esstisch|Dusche|Kühlschrank|"
         "Klavier|Waschmaschine|Sandkasten|Bank|Apfelbaum|Teich"}};
    std::vector<NameInWorld> all;
    for (const auto& [kind, text] : language == "de" ? german : english) {
        std::istringstream list(text);
        for (std::string name; std::getline(list, name, '|');) all.push_back({name, kind});
    }
    return all;
}

// Returns the meaning of a question as the phrasings state it.
std::string meaning(const Question& question, const std::vector<NameInWorld>& names) {
    const std::string name = question.name ? names[*question.name].name : std::string();
    const std::string noun(noun_key(question.noun));
    switch (question.kind) {
        case QuestionKind::WhereIs:
            return "where " + name;
        case QuestionKind::HowFar:
            return "far " + name;
        case QuestionKind::WayTo:
            return "route " + name;
        case QuestionKind::WhatIsIn:
            return "in " + name;
        case QuestionKind::RoomOf:
            return "room-of " + name;
        case QuestionKind::SizeOf:
            return "size " + (question.name ? name : "here");
        case QuestionKind::IsOpen:
            return "open " + (question.name ? name : "door");
        case QuestionKind::WhichDoor:
            return "which-door";
        case QuestionKind::Nearest:
            return "nearest " + noun;
        case QuestionKind::HowMany:
            return "count " + noun + (noun == "stairs" ? "" : "s");
        case QuestionKind::Rooms:
            return "rooms";
        case QuestionKind::StoreyAbove:
            return "upstairs";
        case QuestionKind::StoreyBelow:
            return "downstairs";
        case QuestionKind::Above:
            return "above";
        case QuestionKind::Below:
            return "below";
        case QuestionKind::GoUp:
            return "go-up";
        case QuestionKind::GoDown:
            return "go-down";
        case QuestionKind::OwnStorey:
            return "my-storey";
        case QuestionKind::OwnPart:
            return "my-part";
        case QuestionKind::Behind:
            return "behind";
        case QuestionKind::Left:
            return "left";
        case QuestionKind::Right:
            return "right";
        case QuestionKind::Home:
            return "home";
        case QuestionKind::Here:
            return "here";
        case QuestionKind::EndRoute:
            return "end-route";
        case QuestionKind::EndBeacon:
            return "end-beacon";
        case QuestionKind::EndWarmer:
            return "end-warmer";
        case QuestionKind::EndLines:
            return "end-lines";
        case QuestionKind::EndLearning:
            return "end-learning";
        case QuestionKind::OwnRoute:
            return "own-route";
        case QuestionKind::OwnBeacon:
            return "own-beacon";
    }
    return {};
}

std::vector<Phrasing> phrasings(std::string_view language) {
    const auto file = test::project_root() / "tests/unit/terminal/phrasings" / (std::string(language) + ".tsv");
    std::istringstream lines(read_whole_file(file).value());
    std::vector<Phrasing> all;
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t tab = line.find('\t'); tab != std::string::npos)
            all.push_back({line.substr(0, tab), line.substr(tab + 1)});
    return all;
}

// Returns those of the phrasings that are not understood as they are meant.
std::vector<std::string> wrong(const std::vector<Phrasing>& phrasings, std::string_view language) {
    const std::vector<NameInWorld> all = names(language);
    std::vector<std::string> wrong;
    for (const Phrasing& each : phrasings) {
        const auto question = question_in(each.typed, all);
        const std::string got = question ? meaning(*question, all) : "nothing";
        if (got != each.meaning) wrong.push_back(each.meaning + ", not " + got + ": " + each.typed);
    }
    return wrong;
}

TEST(Questions, are_understood_as_people_phrase_them) {
    for (const std::string language : {"en", "de"}) {
        const test::InLanguage spoken(language);
        const std::vector<Phrasing> all = phrasings(language);
        ASSERT_EQ(all.size(), kRead + kRest) << language;
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(kRead);
        EXPECT_THAT(wrong({all.begin(), middle}, language), IsEmpty()) << language;
        const std::vector<std::string> rest = wrong({middle, all.end()}, language);
        EXPECT_LE(rest.size(), kRest - kLeastOfRest) << language << ": " << ::testing::PrintToString(rest);
    }
}

TEST(Questions, about_what_guides_the_person_end_it_or_state_it) {
    const std::map<std::string, std::vector<Phrasing>> of_language{
        {"en",
         {{"end-route", "stop following"},
          {"end-route", "Stop the route, please."},
          {"end-route", "end the route to the kitchen"},
          {"end-route", "I don't want to follow it any more"},
          {"end-route", "cancel the guidance"},
          {"end-route", "stop guiding me"},
          {"end-beacon", "stop the beacon"},
          {"end-beacon", "turn the beacon off"},
          {"end-beacon", "switch off the beacon on the piano"},
          {"end-warmer", "stop warmer and colder"},
          {"end-warmer", "stop the ticking"},
          {"end-lines", "turn the lines off"},
          {"end-learning", "stop learning"},
          {"own-route", "how far is it still"},
          {"own-route", "how much further"},
          {"own-route", "which route am I following"},
          {"own-route", "am I following a route"},
          {"own-beacon", "what is the beacon on"},
          {"own-beacon", "where is the beacon"},
          {"route Kitchen", "which is the route to the kitchen"},
          {"home", "what is the way back to the start"}}},
        {"de",
         {{"end-route", "folgen beenden"},
          {"end-route", "Hör auf zu folgen"},
          {"end-route", "den Weg zur Küche beenden"},
          {"end-route", "ich will dem Weg nicht mehr folgen"},
          {"end-route", "Führung abbrechen"},
          {"end-route", "stopp die Route"},
          {"end-beacon", "Signal ausschalten"},
          {"end-beacon", "mach das Signal aus"},
          {"end-warmer", "wärmer und kälter beenden"},
          {"end-warmer", "das Ticken aus"},
          {"end-lines", "Linien aus"},
          {"end-learning", "Lernen beenden"},
          {"own-route", "wie weit ist es noch"},
          {"own-route", "welchem Weg folge ich"},
          {"own-route", "folge ich einem Weg"},
          {"own-beacon", "wo ist das Signal"},
          {"own-beacon", "worauf ist das Signal"},
          {"far Küche", "wie weit ist es noch bis zur Küche"},
          {"route Küche", "der Weg zur Küche"}}}};
    for (const auto& [language, each] : of_language) {
        const test::InLanguage spoken(language);
        EXPECT_THAT(wrong(each, language), IsEmpty()) << language;
    }
}

TEST(Questions, survive_a_typing_mistake_and_umlauts_written_out) {
    const std::vector<NameInWorld> english = names("en");
    EXPECT_EQ(meaning(question_in("where is teh kitchne", english).value(), english), "where Kitchen");
    EXPECT_EQ(meaning(question_in("how far is the GUEST ROOM?", english).value(), english), "far Guest room");
    const test::InLanguage spoken("de");
    const std::vector<NameInWorld> german = names("de");
    EXPECT_EQ(meaning(question_in("wie weit ist die kueche", german).value(), german), "far Küche");
    EXPECT_EQ(meaning(question_in("ist die haustuer offen", german).value(), german), "open Haustür");
}

TEST(Questions, are_not_found_in_commands_or_in_lines_about_something_else) {
    const std::vector<NameInWorld> all = names("en");
    for (const char* line : {"", " ", "?", "forward", "the moon is made of cheese", "please sing a song for my aunt",
                             "why do kitchens smell of onions in summer", "set a reminder for nine"})
        EXPECT_FALSE(question_in(line, all)) << line;
    EXPECT_FALSE(question_in(std::string(100000, 'x'), all));
}

TEST(Questions, find_a_name_by_one_of_its_words_and_by_another_word_for_the_thing) {
    const std::vector<NameInWorld> all{{"Girls' toilet", NamedKind::Room}, {"Refrigerator", NamedKind::Thing}};
    EXPECT_EQ(question_in("where is the toilet", all), (Question{QuestionKind::WhereIs, 0, {}}));
    EXPECT_EQ(question_in("where is the loo", all), (Question{QuestionKind::WhereIs, 0, {}}));
    EXPECT_EQ(question_in("how far is the fridge", all), (Question{QuestionKind::HowFar, 1, {}}));
    EXPECT_EQ(name_in("the fridge is cold", all), 1U);
    EXPECT_FALSE(name_in("nothing of that kind", all));
}

TEST(Questions, mean_no_certain_room_or_door_by_a_name_that_is_only_its_kind) {
    const std::vector<NameInWorld> all{
        {"Door", NamedKind::Door}, {"Room", NamedKind::Room}, {"Bathroom 1", NamedKind::Room}};
    EXPECT_EQ(question_in("which door", all), (Question{QuestionKind::WhichDoor, {}, CommonNoun::Door}));
    EXPECT_EQ(question_in("is the door open", all), (Question{QuestionKind::IsOpen, {}, CommonNoun::Door}));
    EXPECT_EQ(question_in("how big is this room", all), (Question{QuestionKind::SizeOf, {}, CommonNoun::Room}));
    EXPECT_EQ(question_in("how far is the door", all), (Question{QuestionKind::HowFar, {}, CommonNoun::Door}));
    EXPECT_EQ(question_in("where is the door", all), (Question{QuestionKind::Nearest, {}, CommonNoun::Door}));
    EXPECT_EQ(question_in("where is the toilet", all), (Question{QuestionKind::WhereIs, 2, {}}));
}

TEST(Questions, can_contain_any_bytes) {
    const std::vector<NameInWorld> all = names("en");
    std::string line = "where is the kitchen";
    for (std::size_t at = 0; at < line.size(); ++at)
        for (const char byte : {'\0', '\x80', '\xff', '\'', ' ', '\n'}) {
            std::string other = line;
            other[at] = byte;
            (void)question_in(other, all);
        }
}

}  // namespace questions_test
}  // namespace handrail
