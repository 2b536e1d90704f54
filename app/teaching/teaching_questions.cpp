// Asks the questions of a lesson and evaluates the answers. See teaching_run.h.
#include <algorithm>
#include <cmath>

#include "app/teaching/run_words.h"
#include "app/teaching/teaching_run.h"
#include "worlds/base/text.h"

namespace handrail::teaching {
namespace {

constexpr double kAway_m = 1.0;  // a learner who is farther than this from the place of a question is moved there

// Returns true if an answer passes. The tolerance is half a hundredth of a degree, because answers are rounded to
// hundredths.
bool passes(double error_rad, double pass_deg) { return std::abs(degrees_from_radians(error_rad)) <= pass_deg + 0.005; }

}  // namespace

void TeachingRun::pose_question() {
    const TaughtStep& now = step();
    const std::string say = question_.at == 0 ? now.say.spoken() : std::string();
    if (now.kind == StepKind::Question) {
        question_.text =
            now.scale
                ? one_after(say, phrase("teaching.scale_is", {{"least", (*now.scale)[0]}, {"most", (*now.scale)[1]}}))
                : say;
        return act(core::TeacherActed::Kind::Question, question_.text);
    }
    if (now.kind == StepKind::Order) {
        // Show the items in a shuffled order that is never the right one.
        question_.shown.clear();
        TaughtSession drawn;
        drawn.shuffle = true;
        drawn.steps.resize(now.to.size());
        question_.shown = step_order(drawn, order_[at_], start_.learner.number);
        if (std::is_sorted(question_.shown.begin(), question_.shown.end()))
            std::rotate(question_.shown.begin(), question_.shown.begin() + 1, question_.shown.end());
        question_.text = one_after(say, phrase("teaching.order_of", {{"count", now.to.size()}}));
        core::TeacherActed order{core::TeacherActed::Kind::Order, question_.text, {}, {}, 0.0};
        for (const std::size_t i : question_.shown) order.items.push_back(world_->place(now.to[i])->name);
        acts_.emplace_back(std::move(order));
        return;
    }
    const TaughtPlace &from = *world_->place(now.from), &to = *world_->place(now.to[question_.at]);
    const bool moved = !near_place(view_.feet_m, from.stand_m, kAway_m);
    if (moved) place(from, &from == &world_->base() ? std::optional(world_->base_heading_rad()) : std::nullopt);
    const std::string stand =
        moved || question_.at == 0 ? phrase("teaching.you_are_at", {{"name", from.name}}) : std::string();
    if (now.kind == StepKind::Point) {
        question_.text =
            one_after(one_after(say, stand), phrase("teaching.point", {{"name", to.name}, {"key", start_.done_key}}));
        return act(core::TeacherActed::Kind::Point, question_.text);
    }
    question_.text =
        one_after(one_after(say, stand),
                  phrase(now.along_way ? "teaching.how_far_along" : "teaching.how_far", {{"name", to.name}}));
    act(core::TeacherActed::Kind::Question, question_.text);
}

// Reads a number from answers such as "12", "12 steps" or "8.5 m".
bool TeachingRun::take_number(const std::string& text, double& number) const {
    std::string word = lower_ascii(one_line(text));
    std::replace(word.begin(), word.end(), ',', '.');
    const std::size_t end = std::min(word.find_first_not_of("-0123456789."), word.size());
    if (!parse_finite(word.substr(0, end), number)) return false;
    while (!word.empty() && end < word.size() && word[end] == ' ') word.erase(end, 1);
    const std::string unit = word.substr(end);
    if (step().kind == StepKind::Question) return unit.empty();
    if (!(number > 0.0)) return false;
    if (!unit.starts_with("m")) number *= start_.step_length_m;
    return true;
}

void TeachingRun::answered(const std::string& text) {
    const TaughtStep& now = step();
    const auto again = [&](const char* why) {
        acts_.emplace_back(core::Announcement{phrase(why), cues::SpeechClass::Answer});
        act(core::TeacherActed::Kind::Question, question_.text);
    };
    double number = 0.0;
    if (now.kind == StepKind::Question) {
        TaskResult result = measured(now.say.spoken());
        if (now.scale) {
            if (!take_number(text, number) || number != std::floor(number) || number < (*now.scale)[0] ||
                number > (*now.scale)[1])
                return again("teaching.not_on_scale");
            result.measures["answer"] = number;
        } else result.name += " " + one_line(text);
        question_.text.clear();
        keep(std::move(result));
        return end_step();
    }
    if (now.kind == StepKind::Order) {
        std::vector<std::size_t> put;
        std::size_t from = 0;
        while (from < text.size()) {
            const std::size_t blank = std::min(text.find(' ', from), text.size());
            double one = 0.0;
            if (!parse_finite(text.substr(from, blank - from), one) || one < 1.0 ||
                one > static_cast<double>(question_.shown.size()))
                return;
            put.push_back(question_.shown[static_cast<std::size_t>(one) - 1]);
            from = blank + 1;
        }
        question_.text.clear();
        TaskResult result = measured({});
        if (const auto tau = results::order_tau(put)) result.measures["order_kept"] = *tau;
        keep(std::move(result));
        acts_.emplace_back(core::Announcement{phrase("teaching.thanks"), cues::SpeechClass::Answer});
        return end_step();
    }
    const TaughtPlace &from = *world_->place(now.from), &to = *world_->place(now.to[question_.at]);
    std::string words;
    if (now.kind == StepKind::Point) {
        if (!parse_finite(text, number)) return;
        const Vec3 way = to.middle_m - view_.feet_m;
        const double error = results::pointing_error_rad(radians_from_degrees(number), std::atan2(way.x, way.y));
        question_.errors_rad.push_back(error);
        const int degrees = static_cast<int>(std::lround(std::abs(degrees_from_radians(error))));
        words = phrase(degrees < 5   ? "teaching.pointed_well"
                       : error > 0.0 ? "teaching.pointed_right"
                                     : "teaching.pointed_left",
                       {{"degrees", degrees}});
        const bool passed = now.pass_deg && passes(error, *now.pass_deg);
        // Do not announce that the answer passes if its error is less than 5 degrees, because the learner then knows
        // it.
        if (now.pass_deg && !(passed && degrees < 5))
            words = one_after(words, phrase(passed ? "teaching.point_passes" : "teaching.point_passes_not",
                                            {{"degrees", *now.pass_deg}}));
    } else {
        if (!take_number(text, number)) return again("teaching.not_a_distance");
        const Vec3 way = to.middle_m - from.stand_m;
        const double true_m = now.along_way ? world_->way(from.stand_m, {to}).length_m : std::hypot(way.x, way.y);
        question_.judged.push_back({number, true_m});
        words = phrase("teaching.distance_is",
                       {{"metres", true_m}, {"steps", static_cast<int>(std::lround(true_m / start_.step_length_m))}});
    }
    question_.text.clear();
    acts_.emplace_back(core::Announcement{words, cues::SpeechClass::Answer});
    if (++question_.at < now.to.size()) return pose_question();
    TaskResult result = measured(now.kind == StepKind::Point ? std::string() : to.name);
    if (const auto off = results::pointing(question_.errors_rad)) {
        result.measures["pointing_off"] = degrees_from_radians(off->absolute_rad);
        if (off->biased) result.measures["pointing_side"] = degrees_from_radians(off->signed_rad);
        if (now.pass_deg) {
            const auto passed = std::count_if(question_.errors_rad.begin(), question_.errors_rad.end(),
                                              [&](double error) { return passes(error, *now.pass_deg); });
            result.measures["pointing_passed"] =
                100.0 * static_cast<double>(passed) / static_cast<double>(question_.errors_rad.size());
        }
    }
    if (const auto ratio = results::distance_ratio(question_.judged)) result.measures["distance_judged"] = *ratio;
    keep(std::move(result));
    end_step();
}

}  // namespace handrail::teaching
