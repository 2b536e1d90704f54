#include "app/core/kept/questions.h"

#include <algorithm>

#include "app/core/dialogue/typed_sentences.h"
#include "app/core/dialogue/typed_words.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr const char* kQuestionList = "question";

Result<PlaceQuestion> question_from(const SideEntry& entry) {
    const auto text = good_name(text_of(entry, "name"));
    const auto answer = good_name(text_of(entry, "answer"));
    const auto place = place_of(entry);
    if (!text || !answer) return fail(phrase("quiz.no_text"));
    if (!place) return fail(phrase("quiz.no_place", {{"question", *text}}));
    return PlaceQuestion{*text, *answer, *place, radians_from_degrees(number_of(entry, "heading_deg", 0.0)),
                         without(entry, {"name", "answer", "place_m", "heading_deg"})};
}

SideEntry question_entry(const PlaceQuestion& question) {
    SideEntry entry = question.kept;
    entry["name"] = question.text;
    entry["answer"] = question.answer;
    put_place(entry, question.place_m);
    entry["heading_deg"] = degrees_from_radians(question.heading_rad);
    return entry;
}

}  // namespace

std::vector<PlaceQuestion> read_questions(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kQuestionList, question_from, faults);
}

void write_questions(SideFile& file, const std::vector<PlaceQuestion>& questions) {
    write_list(file, kQuestionList, questions, question_entry, question_from);
}

bool is_right(const PlaceQuestion& question, std::string_view typed) {
    const std::vector<TypedWord> said = typed_words(typed), right = typed_words(without_fillers(question.answer));
    return !right.empty() && std::all_of(right.begin(), right.end(), [&](const TypedWord& word) {
        return std::any_of(said.begin(), said.end(), [&](const TypedWord& one) { return one.plain == word.plain; });
    });
}

}  // namespace handrail::core
