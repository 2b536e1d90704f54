// Tests whole sentences, as people type them if they do not know the words of commands.
#include "app/core/dialogue/typed_sentences.h"

#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/dialogue.h"
#include "app/core/dialogue/terminal_line.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace typed_sentences_test {

using testing::HasSubstr;

// Returns the pattern as a person might type it, with a count and a name filled in.
std::string said(std::string pattern) {
    for (const auto& [slot, with] : {std::pair<std::string, std::string>{"<count>", "3"}, {"<name>", "Blue Room"}})
        if (const std::size_t at = pattern.find(slot); at != std::string::npos) pattern.replace(at, slot.size(), with);
    return pattern;
}

TEST(TypedSentences, of_every_command_are_understood_as_that_command_in_every_language) {
    for (const LanguageName& language : bundled_languages()) {
        const test::InLanguage spoken(language.code);
        std::size_t sentences = 0;
        for (const auto& [key, text] : bundled_texts(language.code)) {
            if (!key.starts_with("typed_sentence.")) continue;
            const CommandInfo* row = find_command(key.substr(std::string_view("typed_sentence.").size()));
            ASSERT_TRUE(row) << key;
            std::istringstream patterns(text);
            for (std::string pattern; std::getline(patterns, pattern, '|');) {
                ++sentences;
                const auto line = parse_terminal_line(said(pattern));
                ASSERT_TRUE(line) << pattern << ": " << line.error().message;
                EXPECT_EQ(line->command, row->command) << language.code << ": " << pattern;
                EXPECT_EQ(line->times, pattern.find("<count>") == std::string::npos ? 1 : 3) << pattern;
                EXPECT_EQ(line->choice, pattern.find("<name>") == std::string::npos ? "" : "Blue Room") << pattern;
                EXPECT_EQ(pattern.find("<name>") == std::string::npos || takes_choice(row->command), true) << pattern;
            }
        }
        EXPECT_GT(sentences, 250U) << language.code;
    }
}

struct Typed {
    const char* typed;
    Command command;
    int times = 1;
    const char* choice = "";
};

void expect_understood(std::initializer_list<Typed> all) {
    for (const Typed& line_typed : all) {
        const auto line = parse_terminal_line(line_typed.typed);
        ASSERT_TRUE(line) << line_typed.typed << ": " << line.error().message;
        ASSERT_TRUE(line->command) << line_typed.typed;
        EXPECT_EQ(*line->command, line_typed.command) << line_typed.typed << " is " << info(*line->command).word;
        EXPECT_EQ(line->times, line_typed.times) << line_typed.typed;
        EXPECT_EQ(line->choice, line_typed.choice) << line_typed.typed;
    }
}

TEST(TypedSentences, of_a_newcomer_are_understood_in_english) {
    expect_understood({{"where am i", Command::WhereAmI},
                       {"Where am I?", Command::WhereAmI},
                       {"  where  am I now ?", Command::WhereAmI},
                       {"Please tell me where I am.", Command::WhereAmI},
                       {"what is here", Command::WhereAmI},
                       {"What's here?", Command::WhereAmI},
                       {"what\u2019s ahead", Command::AheadOfMe},
                       {"what is ahead", Command::AheadOfMe},
                       {"what is in front of me?", Command::AheadOfMe},
                       {"what is around me", Command::AroundMe},
                       {"look around", Command::AroundMe},
                       {"which way am I facing", Command::Heading},
                       {"I'm lost", Command::Lost},
                       {"how do I get out of here?", Command::Exits},
                       {"go to the kitchen", Command::Routes, 1, "kitchen"},
                       {"Take me to the Blue Room, please", Command::Routes, 1, "Blue Room"},
                       {"find my way to the library", Command::Routes, 1, "library"},
                       {"where is the piano", Command::Find, 1, "piano"},
                       {"tell me about the library", Command::Describe, 1, "library"},
                       {"describe the building", Command::Overview},
                       {"turn left", Command::TurnLeft},
                       {"turn right three times", Command::TurnRight, 3},
                       {"walk 5 steps", Command::Forward, 5},
                       {"two steps back", Command::Back, 2},
                       {"1 step", Command::Forward},
                       {"open the door", Command::Use},
                       {"say that again", Command::Repeat},
                       {"what can I do?", Command::Help},
                       {"help me", Command::Help},
                       {"be quiet", Command::StopSpeech},
                       {"stop everything", Command::StopEverything},
                       {"go home", Command::Home},
                       {"take me", Command::TakeMe},
                       {"rest of way", Command::RestOfRoute},
                       {"the rest of the way, please", Command::RestOfRoute},
                       {"rest of the route", Command::RestOfRoute},
                       {"what comes after that?", Command::NextLeg},
                       {"turn me to the route", Command::FaceRoute},
                       {"set a mark", Command::DropMark},
                       {"goodbye", Command::Leave}});
}

TEST(TypedSentences, of_a_newcomer_are_understood_in_german) {
    const test::InLanguage german("de");
    expect_understood({{"wo bin ich", Command::WhereAmI},
                       {"Wo bin ich jetzt?", Command::WhereAmI},
                       {"Welcher Raum ist das?", Command::WhereAmI},
                       {"was ist hier", Command::WhereAmI},
                       {"was ist vor mir", Command::AheadOfMe},
                       {"Was ist um mich herum?", Command::AroundMe},
                       {"sieh dich um", Command::AroundMe},
                       {"wohin schaue ich", Command::Heading},
                       {"ich habe mich verlaufen", Command::Lost},
                       {"wie komme ich hier raus", Command::Exits},
                       {"Bring mich bitte zur Küche", Command::Routes, 1, "Küche"},
                       {"bring mich zur kueche", Command::Routes, 1, "kueche"},
                       {"wie komme ich in die Bibliothek?", Command::Routes, 1, "Bibliothek"},
                       {"wo ist das Klavier", Command::Find, 1, "Klavier"},
                       {"was ist in der Küche", Command::Describe, 1, "Küche"},
                       {"beschreibe das Gebäude", Command::Overview},
                       {"beschreibe das gebaeude", Command::Overview},
                       {"dreh dich nach links", Command::TurnLeft},
                       {"zwei mal nach rechts", Command::TurnRight, 2},
                       {"geh 5 Schritte", Command::Forward, 5},
                       {"drei Schritte zurück", Command::Back, 3},
                       {"öffne die Tür", Command::Use},
                       {"Wie bitte?", Command::Repeat},
                       {"was kann ich tun", Command::Help},
                       {"sei still", Command::StopSpeech},
                       {"alles anhalten", Command::StopEverything},
                       {"nach Hause", Command::Home},
                       {"bring mich hin", Command::TakeMe},
                       {"Rest des Wegs", Command::RestOfRoute},
                       {"der Rest der Route bitte", Command::RestOfRoute},
                       {"und danach?", Command::NextLeg},
                       {"zum Weg drehen", Command::FaceRoute},
                       {"Auf Wiedersehen!", Command::Leave}});
}

TEST(TypedSentences, leave_command_words_and_their_choices_unchanged) {
    expect_understood({{"forward 3", Command::Forward, 3},
                       {"describe the attic", Command::Describe, 1, "the attic"},
                       {"routes to the library", Command::Routes, 1, "to the library"},
                       {"what", Command::WhatIsThis},
                       {"up 2", Command::Forward, 2}});
    EXPECT_TRUE(parse_terminal_line("quit")->leave);
}

TEST(TypedSentences, without_a_meaning_are_reported_as_unknown_rather_than_as_lacking_a_count) {
    const auto known_word = parse_terminal_line("where did the cat go");
    ASSERT_FALSE(known_word);
    EXPECT_THAT(known_word.error().message, HasSubstr("\"where did the cat go\" was not understood. Type only where"));
    const auto unknown = parse_terminal_line("bananas are yellow");
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().message, HasSubstr("Type help for a list of what you can type."));
    EXPECT_THAT(parse_terminal_line("wheer 3").error().message, HasSubstr("Did you mean \"where\"?"));
    EXPECT_THAT(parse_terminal_line("where 0").error().message, HasSubstr("only by a number from 1 to 1000"));
    EXPECT_FALSE(typed_sentence("go 0 steps"));
    EXPECT_FALSE(typed_sentence("go 1001 steps"));
    EXPECT_FALSE(typed_sentence(std::string(100'000, 'a') + " b"));
    EXPECT_FALSE(typed_sentence("take me to"));
    EXPECT_FALSE(typed_sentence("?!"));
}

TEST(TypedSentences, choose_from_a_list_by_names_without_articles_or_with_umlauts_written_out) {
    const test::InLanguage german("de");
    Dialogue dialogue;
    std::vector<std::size_t> chosen;
    ListSpec list;
    list.title = "Räume";
    list.items = {{"Große Küche", {}, false}, {"Zur alten Post", {}, false}, {"Flur", {}, false}};
    list.chosen = [&](std::size_t i) { chosen.push_back(i); };
    list.stays_open = true;
    dialogue.open(list);
    EXPECT_TRUE(dialogue.has_use_for("in die Küche"));
    EXPECT_FALSE(dialogue.has_use_for("in den Keller"));
    dialogue.line("kueche", 0.0);
    dialogue.line("zum Flur", 0.0);
    dialogue.line("zur alten post", 0.0);
    dialogue.line("zu der Küche", 0.0);
    EXPECT_THAT(chosen, testing::ElementsAre(0U, 2U, 1U, 0U)) << "a name that begins so comes first";
    EXPECT_TRUE(dialogue.line("zum Keller", 0.0).denied);
}

}  // namespace typed_sentences_test
}  // namespace handrail
