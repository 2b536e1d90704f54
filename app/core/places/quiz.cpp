#include "app/core/places/quiz.h"

#include <utility>

#include "app/core/dialogue/words.h"
#include "worlds/base/language.h"

namespace handrail::core {

bool Quiz::act(Command command, double now_s) {
    if (command == Command::AskHere) ask_here(now_s);
    else if (command == Command::Quiz) begin(now_s);
    else return false;
    return true;
}

void Quiz::ask_here(double now_s) {
    PlaceQuestion question;
    question.place_m = context_.avatar.feet_m();
    question.heading_rad = context_.avatar.heading_rad;
    TextSpec text;
    text.question = phrase("quiz.which_question");
    text.done = [this, question](const std::string& typed) mutable {
        const auto good = good_name(typed);
        if (!good) return context_.answer(good.error().message, context_.tick_s);
        question.text = *good;
        request_answer(question, context_.tick_s);
    };
    context_.request_text(std::move(text), now_s);
}

void Quiz::request_answer(const PlaceQuestion& question, double now_s) {
    TextSpec text;
    text.question = phrase("quiz.which_answer");
    text.done = [this, question = question](const std::string& typed) mutable {
        const auto good = good_name(typed);
        if (!good) return context_.answer(good.error().message, context_.tick_s);
        question.answer = *good;
        std::vector<Error> faults;
        std::vector<PlaceQuestion> all = read_questions(context_.additions, faults);
        all.push_back(question);
        write_questions(context_.additions, all);
        context_.keep_and_answer(phrase("quiz.set", {{"count", all.size()}, {"key", "quiz"}}), context_.tick_s);
    };
    context_.request_text(std::move(text), now_s);
}

void Quiz::begin(double now_s) {
    std::vector<Error> faults;
    Round round{read_questions(context_.additions, faults), 0, 0, context_.avatar.feet_m(),
                context_.avatar.heading_rad};
    const std::string unreadable = unreadable_words("quiz.unreadable", faults);
    if (round.questions.empty()) return context_.answer(unreadable.empty() ? phrase("quiz.none") : unreadable, now_s);
    pose(std::move(round), unreadable, now_s);
}

// Puts the person at the place of the present question and asks it. `before` is said first.
void Quiz::pose(Round round, const std::string& before, double now_s) {
    const PlaceQuestion& question = round.questions[round.at];
    context_.session_requests.place(question.place_m, question.heading_rad, now_s);
    TextSpec text;
    text.question = beside(
        before, phrase("quiz.question",
                       {{"number", round.at + 1}, {"count", round.questions.size()}, {"question", question.text}}));
    text.left = [this, round] { end(round, {}, context_.tick_s); };
    text.done = [this, round](const std::string& typed) mutable {
        const PlaceQuestion& asked = round.questions[round.at];
        const bool right = is_right(asked, typed);
        if (right) ++round.right;
        ++round.at;
        const std::string judged = phrase("quiz.judged", {{"right", right ? "yes" : "no"}, {"answer", asked.answer}});
        if (round.at < round.questions.size()) pose(round, judged, context_.tick_s);
        else end(round, judged, context_.tick_s);
    };
    context_.request_text(std::move(text), now_s);
}

void Quiz::end(const Round& round, const std::string& before, double now_s) {
    context_.session_requests.place(round.feet_m, round.heading_rad, now_s);
    context_.answer(beside(before, phrase("quiz.done", {{"right", round.right}, {"count", round.at}})), now_s);
}

}  // namespace handrail::core
