// Tests the quiz: a person sets questions at places, and is asked them there.
#include <gmock/gmock.h>

#include "app/core/dialogue/terminal_line.h"
#include "app/core/kept/questions.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/in_the_house.h"

namespace handrail {
namespace quiz_test {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Quiz, asks_at_each_place_what_was_set_there_and_brings_the_person_back) {
    test::InTheHouse p;
    const Vec3 base_m = p.app.feet_m();
    EXPECT_EQ(parse_terminal_line("ask here")->command, Command::AskHere);
    EXPECT_EQ(p.request(Command::AskHere), "What shall be asked here? Type the question. Escape cancels.");
    EXPECT_EQ(p.line("Which way is north?"), "What is the right answer? Escape cancels.");
    EXPECT_THAT(p.line("the stairs"), StartsWith("The question is set. This world has one question."));
    p.app.apply(Placed{base_m + Vec3(1.0, 0.0, 0.0), 1.0}, p.now);
    p.run(0.1);
    const Vec3 other_m = p.app.feet_m();
    p.request(Command::AskHere);
    p.line("Which room is behind you?");
    EXPECT_THAT(p.line("Kitchen"), HasSubstr("This world has 2 questions."));

    EXPECT_EQ(p.request(Command::Quiz), "Question 1 of 2: Which way is north? Escape cancels.");
    EXPECT_LT(glm::length(p.app.feet_m() - base_m), 0.01);
    EXPECT_EQ(p.line("Along the Stairs!"),
              "Right: the stairs. Question 2 of 2: Which room is behind you? Escape cancels.");
    EXPECT_LT(glm::length(p.app.feet_m() - other_m), 0.01);
    EXPECT_EQ(p.line("the bathroom"), "The answer is: Kitchen. 1 of 2 answers is right. You are back where you were.");
    EXPECT_LT(glm::length(p.app.feet_m() - other_m), 0.01);
    EXPECT_FALSE(p.app.dialogue().is_open());
}

TEST(Quiz, can_be_left_and_says_how_to_set_a_question) {
    test::InTheHouse p;
    EXPECT_THAT(p.request(Command::Quiz), StartsWith("No question has been set in this world."));
    const test::InLanguage german("de");
    EXPECT_EQ(parse_terminal_line("frage hier")->command, Command::AskHere);
    p.request(Command::AskHere);
    p.line("Was ist hier?");
    p.line("Flur");
    const Vec3 base_m = p.app.feet_m();
    p.app.apply(Placed{base_m + Vec3(1.0, 0.0, 0.0), 1.0}, p.now);
    p.run(0.1);
    const Vec3 other_m = p.app.feet_m();
    EXPECT_EQ(parse_terminal_line("frag mich ab")->command, Command::Quiz);
    EXPECT_EQ(p.request(Command::Quiz), "Frage 1 von 1: Was ist hier? Escape bricht ab.");
    p.app.apply(KeyTapped{"Escape"}, p.now);
    p.listen();
    EXPECT_LT(glm::length(p.app.feet_m() - other_m), 0.01);
}

TEST(Quiz, keeps_questions_that_it_cannot_read_and_reports_them) {
    SideFile file;
    file.set_entries("question", {SideEntry{{"name", std::string("Where?")}}});
    std::vector<Error> faults;
    EXPECT_TRUE(read_questions(file, faults).empty());
    EXPECT_EQ(faults.size(), 1U);
    write_questions(file, {{"What?", "This", {1, 2, 3}, 0.5, {}}});
    EXPECT_EQ(file.entries("question").size(), 2U);
    const std::vector<PlaceQuestion> read = read_questions(file, faults);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_NEAR(read[0].heading_rad, 0.5, 1e-9);
    EXPECT_FALSE(is_right(read[0], "that"));
}

}  // namespace quiz_test
}  // namespace handrail
