#include "app/core/lessons/exercise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "haptic/servo/workspace_map.h"
#include "worlds/base/language.h"

namespace handrail::core {

void Exercise::enter_world() {
    under_way_ = false;
    question_.reset();
    task_.clear();
}

void Exercise::take(const TeacherActed& act, double now_s) {
    using Kind = TeacherActed::Kind;
    switch (act.kind) {
        case Kind::Begin:
            under_way_ = true;
            title_ = act.text;
            break;
        case Kind::Offer:
            offers_ = act.items;
            break;
        case Kind::Task:
            question_.reset();
            task_ = act.text;
            context_.answer(task_, now_s);
            break;
        case Kind::Question:
        case Kind::Order:
            question_ = Question{act.kind, act.text, act.items, {}, {}};
            task_ = act.text;
            repeat_question(now_s);
            break;
        case Kind::Point:
            question_ = Question{act.kind, act.text, {}, {}, {}};
            tick();
            task_ = act.text;
            context_.answer(act.text, now_s);
            break;
        case Kind::End:
            enter_world();
            break;
        case Kind::Learners:
            open_learners(act, now_s);
            break;
        case Kind::Lead:
        case Kind::Leave:
        case Kind::Block:
        case Kind::Open:
        case Kind::Note:
        case Kind::Result:
        case Kind::Summary:
            break;
    }
}

void Exercise::tick() {
    if (question_ && question_->kind == TeacherActed::Kind::Point && !question_->hand_m && context_.hands.known())
        question_->hand_m = context_.hands.tool.hand_m;
}

bool Exercise::act(Command command, double now_s) {
    if (command == Command::Learners) {
        context_.requests.learners = true;
        return true;
    }
    if (command == Command::Task) {
        if (under_way_) open_list(now_s);
        else open_offers(now_s);
        return true;
    }
    if (command != Command::TaskDone) return false;
    if (!under_way_) context_.answer(phrase("exercise.none", {{"key", context_.keys.keys_of(Command::Task)}}), now_s);
    else if (!question_) request(LessonRequest::Done, now_s);
    else if (question_->kind == TeacherActed::Kind::Point) point(now_s);
    else repeat_question(now_s);
    return true;
}

void Exercise::request(LessonRequest request, double now_s) const {
    context_.events.report(LessonRequested{request}, now_s);
}

void Exercise::repeat_question(double now_s) {
    if (question_->kind == TeacherActed::Kind::Order) return open_order(now_s);
    TextSpec text;
    text.question = question_->text;
    // The session reports every answered question as an event, so nothing more is needed here.
    text.done = [this](const std::string&) { question_.reset(); };
    context_.request_text(std::move(text), now_s);
}

// Asks which item comes next. The last item needs no question and is added automatically.
void Exercise::open_order(double now_s) {
    const auto is_chosen = [this](std::size_t i) {
        for (const std::size_t one : question_->chosen)
            if (one == i) return true;
        return false;
    };
    ListSpec list;
    list.title = question_->chosen.empty()
                     ? question_->text
                     : phrase("exercise.and_then", {{"name", question_->items[question_->chosen.back()]}});
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < question_->items.size(); ++i)
        if (!is_chosen(i)) {
            left.push_back(i);
            list.items.push_back({question_->items[i], {}, false});
        }
    list.chosen = [this, left](std::size_t at) {
        const double then_s = context_.tick_s;
        question_->chosen.push_back(left[at]);
        if (left.size() > 2) return open_order(then_s);
        for (const std::size_t last : left)
            if (last != left[at]) question_->chosen.push_back(last);
        std::string text;
        for (const std::size_t one : question_->chosen) text += fmt::format("{}{}", text.empty() ? "" : " ", one + 1);
        const std::string question = question_->text;
        question_.reset();
        context_.events.report(Answered{question, text}, then_s);
    };
    context_.open_list(std::move(list), now_s);
}

// Answers with the direction in which the hand has moved since the question, in degrees clockwise from north. If the
// hand has not moved, the answer is the direction that the person faces.
void Exercise::point(double now_s) {
    double heading_rad = context_.avatar.heading_rad;
    if (question_->hand_m && context_.hands.known()) {
        const Vec3 moved_m = context_.hands.tool.hand_m - *question_->hand_m;
        const Vec3 way = servo::frame_of(Vec3(0.0), workspace_heading_rad(context_)).turn_to_world(moved_m);
        if (std::hypot(way.x, way.y) >= kPointed_m) heading_rad = std::atan2(way.x, way.y);
    }
    const std::string question = question_->text;
    question_.reset();
    context_.events.report(Answered{question, fmt::format("{:.2f}", degrees_from_radians(heading_rad))}, now_s);
}

void Exercise::open_list(double now_s) {
    ListSpec list;
    list.title = title_;
    struct Row {
        const char* name;
        std::function<void(double then_s)> act;
    };
    std::vector<Row> rows{{"exercise.again", [this](double then_s) { context_.answer(task_, then_s); }}};
    if (question_ && question_->kind != TeacherActed::Kind::Point)
        rows.push_back({"exercise.answer", [this](double then_s) {
                            if (question_) repeat_question(then_s);
                        }});
    rows.push_back({question_ ? "exercise.pass" : "exercise.done", [this](double then_s) {
                        question_.reset();
                        request(LessonRequest::Done, then_s);
                    }});
    rows.push_back({"exercise.more_help", [this](double then_s) { request(LessonRequest::MoreHelp, then_s); }});
    rows.push_back({"exercise.less_help", [this](double then_s) { request(LessonRequest::LessHelp, then_s); }});
    rows.push_back({"exercise.leave", [this](double then_s) { request(LessonRequest::Leave, then_s); }});
    for (const Row& row : rows) list.items.push_back({phrase(row.name), {}, false});
    list.chosen = [this, rows](std::size_t at) { rows[at].act(context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

void Exercise::open_learners(const TeacherActed& act, double now_s) {
    ListSpec list;
    list.title = act.text;
    for (std::size_t i = 0; i + 1 < act.items.size(); i += 2)
        list.items.push_back({act.items[i], act.items[i + 1], false});
    list.at = static_cast<std::size_t>(std::clamp(act.number, 0.0, 1e6));
    if (list.at >= list.items.size()) list.at = 0;
    list.chosen = [this](std::size_t at) { context_.requests.learner = at; };
    context_.open_list(std::move(list), now_s);
}

void Exercise::open_offers(double now_s) {
    ListSpec list;
    list.title = phrase("exercise.title");
    for (const std::string& offer : offers_)
        list.items.push_back({phrase("exercise.begin", {{"name", offer}}), {}, false});
    list.items.push_back({phrase("exercise.prepare"), {}, false});
    list.chosen = [this](std::size_t at) {
        if (at < offers_.size()) context_.requests.lesson = at;
        else if (on_prepare) on_prepare(context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
