#include "app/teaching/teaching_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/teaching/run_words.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail::teaching {
namespace {

constexpr double kSample_s = 0.1, kArrived_m = 1.5, kNotReachedHigh_m = 1.0;
constexpr double kAtDoor_m = 1.5, kLeftDoor_m = 2.0;
constexpr std::size_t kMostSamples = 36000;  // number of samples in one hour
constexpr double kWallTouched_s = 0.5;

// Returns the horizontal distance of a place from a route, if both are on the same storey.
double off_way_m(const std::vector<Vec3>& way, const Vec3& at) {
    double best = 1e9;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Vec3 along = way[i] - way[i - 1];
        const double length2 = glm::dot(along, along);
        const double part = length2 > 0.0 ? std::clamp(glm::dot(at - way[i - 1], along) / length2, 0.0, 1.0) : 0.0;
        const Vec3 off = at - (way[i - 1] + along * part);
        best = std::min(best, std::abs(off.z) > 2.0 ? 1e9 : std::hypot(off.x, off.y));
    }
    return best;
}

int times_off(const std::vector<Vec3>& way, const std::vector<results::WalkedPoint>& walk, double off_m) {
    int times = 0;
    bool off = false;
    for (const results::WalkedPoint& point : walk) {
        const double now_m = off_way_m(way, point.place_m);
        if (!off && now_m > off_m) ++times, off = true;
        else if (off && now_m < 0.5 * off_m) off = false;
    }
    return times;
}

}  // namespace

LearnerName learner_named(const std::string& name) {
    if (name.empty()) return {};
    std::uint64_t hash = 14695981039346656037U;  // the hash FNV-1a
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return {name, hash};
}

core::TeacherActed result_act(const TaskResult& result) {
    core::TeacherActed act{core::TeacherActed::Kind::Result, result.name, {}, {}, static_cast<double>(result.step)};
    act.items.push_back(kStepWords.at(static_cast<std::size_t>(result.kind)));
    act.items.push_back(fmt::format("{}", result.lap));
    for (const auto& [key, value] : result.measures) act.items.push_back(fmt::format("{}={}", key, value));
    return act;
}

TeachingRun::TeachingRun(std::shared_ptr<TaughtWorld> world, Start start)
    : world_(std::move(world)), start_(std::move(start)) {
    order_ = step_order(session(), start_.session, start_.learner.number);
}

void TeachingRun::act(core::TeacherActed::Kind kind, std::string text, double number) {
    acts_.emplace_back(core::TeacherActed{kind, std::move(text), {}, {}, number});
}

void TeachingRun::task(std::string text) {
    question_.task = std::move(text);
    act(core::TeacherActed::Kind::Task, question_.task);
}

void TeachingRun::place(const TaughtPlace& at, std::optional<double> heading_rad) {
    acts_.emplace_back(core::Placed{at.stand_m, heading_rad.value_or(view_.heading_rad)});
    view_.feet_m = at.stand_m;
    if (heading_rad) view_.heading_rad = *heading_rad;
    task_.leap = true;
}

void TeachingRun::keep(TaskResult result) {
    result.ended_s = now_s_;
    acts_.emplace_back(result_act(result));
    results_.push_back(std::move(result));
}

void TeachingRun::see(const core::SessionEvent& event) {
    now_s_ = std::max(now_s_, event.time_s);
    std::visit(Overloaded{
                   [&](const core::Touched& e) {
                       const Feature* feature = world_->scene()->find(e.feature);
                       if (!feature) return;
                       task_.touches.push_back({event.time_s, e.feature.value});
                       whole_.touches.push_back({event.time_s, e.feature.value});
                       if (feature->kind == FeatureKind::Wall) whole_.wall_touched_s = event.time_s;
                   },
                   [&](const core::ThingVisited& e) { whole_.visited = static_cast<int>(e.feature.value); },
                   [&](const core::HelpRequested&) {
                       ++task_.help;
                       whole_.helped_s = event.time_s;
                   },
                   [&](const core::Leading& e) {
                       if (led_since_s_) task_.led_s += event.time_s - std::max(*led_since_s_, task_.begun_s);
                       led_since_s_ = e.on ? std::optional(event.time_s) : std::nullopt;
                   },
                   [&](const core::Arrived& e) {
                       if (e.goal == led_to_) end_teachers_lead();
                   },
                   [&](const core::ListShown& e) {
                       if (!e.open) end_busy(list_since_s_);
                       else if (!list_since_s_) list_since_s_ = event.time_s;
                   },
                   [&](const core::DoorUsed& e) {
                       const bool blocked =
                           std::find(laps_.blocked.begin(), laps_.blocked.end(), e.feature) != laps_.blocked.end();
                       if (blocked && !laps_.met_s) laps_.met_s = laps_.left_s = event.time_s;
                   },
                   [&](const core::Answered& e) {
                       if (!question_.text.empty() && e.question == question_.text) answered(e.text);
                   },
                   [&](const core::LessonRequested& e) {
                       if (!begun_ || over_) return;
                       switch (e.request) {
                           case core::LessonRequest::Done:
                               next(event.time_s);
                               break;
                           case core::LessonRequest::MoreHelp:
                               ++task_.help;
                               whole_.helped_s = event.time_s;
                               change_help(1);
                               break;
                           case core::LessonRequest::LessHelp:
                               change_help(-1);
                               break;
                           case core::LessonRequest::Leave:
                               end(event.time_s);
                               break;
                       }
                   },
                   [](const auto&) {},
               },
               event.what);
}

void TeachingRun::end_busy(std::optional<double>& since_s) {
    if (since_s) task_.busy.push_back({*since_s, now_s_});
    since_s.reset();
}

void TeachingRun::follow_walk() {
    if (now_s_ - sampled_s_ < kSample_s - 1e-6) return;
    sampled_s_ = now_s_;
    task_.walk.push_back({now_s_, view_.feet_m, std::exchange(task_.leap, false)});
    if (whole_.samples.size() < kMostSamples)
        whole_.samples.push_back({.t_s = now_s_,
                                  .place_m = view_.feet_m,
                                  .wall_m = view_.wall_m,
                                  .wall_touched = view_.trails || now_s_ - whole_.wall_touched_s <= kWallTouched_s,
                                  .thing = std::exchange(whole_.visited, -1)});
}

// Updates what the learner knows about the room to learn. When the learner leaves the room, the last values remain.
void TeachingRun::follow_room() {
    if (step().kind != StepKind::Learn || lower_ascii(view_.room) != lower_ascii(step().room)) return;
    if (view_.perimeter_m > 0.0) task_.walls_percent = 100.0 * view_.walls_share;
    if (view_.exits > 0) task_.exits_percent = 100.0 * view_.exits_found / view_.exits;
}

void TeachingRun::tick(double now_s, const core::LessonView& view, bool speaking) {
    now_s_ = now_s;
    // The view is current, but the event of a leap arrives a frame later. So derive the leap from the view, or a walker
    // who was moved would seem to have walked there.
    if (view.times_put != view_.times_put) task_.leap = true;
    view_ = view;
    if (!speaking) end_busy(speaks_since_s_);
    else if (!speaks_since_s_) speaks_since_s_ = now_s;
    if (over_ || !view.rooms_known) return;
    if (!begun_) {
        begun_ = true;
        summed_s_ = now_s;
        const LessonFile& lesson = world_->lesson();
        act(core::TeacherActed::Kind::Begin, lesson.title.spoken());
        std::string first =
            phrase("teaching.session",
                   {{"lesson", lesson.title.spoken()}, {"name", session().name}, {"count", session().steps.size()}});
        if (session().minutes > 0) first = one_after(first, phrase("teaching.minutes", {{"count", session().minutes}}));
        acts_.emplace_back(core::Announcement{one_after(first, world_->news()), cues::SpeechClass::Answer});
        begin_step();
        return;
    }
    follow_walk();
    follow_room();
    if (now_s - summed_s_ >= kSummary_s) {
        summed_s_ = now_s;
        act(core::TeacherActed::Kind::Summary, summary());
    }
    const TaughtStep& now = step();
    if (now.kind == StepKind::Learn && (now.walls_percent > 0 || now.exits > 0) &&
        lower_ascii(view.room) == lower_ascii(now.room) && (now.walls_percent <= 0 || view.perimeter_m > 0.0) &&
        100.0 * view.walls_share >= now.walls_percent && view.exits_found >= now.exits)
        return void(next(now_s));
    if (now.kind != StepKind::Go) return;
    for (const FeatureId door : laps_.blocked) {
        const Aabb& box = world_->scene()->features[door.value].bounds_m;
        const Vec3 nearest = glm::clamp(view.feet_m, box.min_m, box.max_m);
        if (std::abs(nearest.z - view.feet_m.z) > kNotReachedHigh_m) continue;
        const double away_m = std::hypot(nearest.x - view.feet_m.x, nearest.y - view.feet_m.y);
        if (!laps_.met_s && away_m < kAtDoor_m) laps_.met_s = laps_.left_s = now_s;
        if (laps_.met_s && away_m < kLeftDoor_m) laps_.left_s = now_s;
    }
    if (!laps_.stops.empty() && near_place(view.feet_m, laps_.stops.back().stand_m, kArrived_m)) end_lap(true);
}

void TeachingRun::begin_step() {
    end_teachers_lead();
    question_.text.clear();
    question_.at = 0;
    question_.errors_rad.clear();
    question_.judged.clear();
    task_ = {};
    task_.begun_s = now_s_;
    const TaughtStep& now = step();
    const std::string say = now.say.spoken();
    switch (now.kind) {
        case StepKind::Learn: {
            const TaughtPlace& room = *world_->place(now.room);
            if (lower_ascii(view_.room) != lower_ascii(now.room)) place(room, std::nullopt);
            return task(one_after(say, phrase("teaching.learn", {{"room", room.name}, {"key", start_.done_key}})));
        }
        case StepKind::Free:
            return task(one_after(say, phrase("teaching.free", {{"key", start_.done_key}})));
        case StepKind::Go:
            return begin_go();
        case StepKind::Point:
        case StepKind::Distance:
        case StepKind::Order:
        case StepKind::Question:
            return pose_question();
    }
}

void TeachingRun::begin_go() {
    laps_ = {};
    const TaughtStep& now = step();
    laps_.stops = world_->stops_of(*world_->lesson().route(now.route));
    laps_.blocked = shut_;
    for (const std::string& name : now.block)
        if (const auto door = world_->door(name)) {
            std::erase(laps_.blocked, *door);
            laps_.blocked.push_back(*door);
            act(core::TeacherActed::Kind::Block, name, static_cast<double>(door->value));
        }
    begin_lap();
}

// Returns the help in this lap as a fraction. It depends on the level that the learner has reached.
double TeachingRun::level() const {
    const std::vector<int>& help = step().help_percent;
    const bool last = laps_.lap + 1 == static_cast<int>(help.size());
    return 0.01 * (last && laps_.level >= help.size() ? help.back() : help[std::min(laps_.level, help.size() - 1)]);
}

void TeachingRun::begin_lap() {
    const TaughtStep& now = step();
    const int laps = static_cast<int>(now.help_percent.size());
    if (laps_.lap + 1 == laps) laps_.level = now.help_percent.size() - 1;  // the last lap has no help
    laps_.met_s = laps_.left_s = std::nullopt;
    task_ = {};
    task_.begun_s = now_s_;
    place(world_->base(), world_->base_heading_rad());
    plan_lap();
    std::string words = laps_.lap == 0 ? now.say.spoken() : std::string();
    if (laps > 1) words = one_after(words, phrase("teaching.lap", {{"lap", laps_.lap + 1}, {"count", laps}}));
    words = one_after(words, phrase("teaching.go", {{"name", laps_.stops.back().name}}));
    const int percent = static_cast<int>(std::lround(100.0 * level()));
    task(one_after(words, phrase("teaching.help_is", {{"percent", percent}})));
    lead();
}

// Returns the stops to which the lap leads. If doors are blocked, the learner may be unable to reach a stop behind
// them, so the lap then leads only to the last stop.
std::vector<TaughtPlace> TeachingRun::led_stops() const {
    return laps_.blocked.empty() ? laps_.stops : std::vector{laps_.stops.back()};
}

void TeachingRun::plan_lap() { laps_.shortest = world_->way(world_->base().stand_m, led_stops(), laps_.blocked); }

void TeachingRun::lead() {
    core::TeacherActed lead{core::TeacherActed::Kind::Lead, {}, {}, {}, level()};
    for (const TaughtPlace& stop : led_stops()) {
        lead.items.push_back(stop.name);
        lead.places_m.push_back(stop.stand_m);
    }
    if (lead.number <= 0.0) act(core::TeacherActed::Kind::Leave);
    else acts_.emplace_back(std::move(lead));
}

TaskResult TeachingRun::measured(std::string name) const {
    TaskResult result{step().kind, order_[at_], laps_.lap, std::move(name), {}, 0.0};
    if (step().kind != StepKind::Go) result.lap = 0;
    result.measures["time"] = now_s_ - task_.begun_s;
    std::vector<results::Span> busy = task_.busy;
    for (const std::optional<double>& since_s : {list_since_s_, speaks_since_s_})
        if (since_s) busy.push_back({*since_s, now_s_});
    const results::Hesitations pauses = results::hesitations(task_.walk, busy);
    result.measures["pauses"] = pauses.count;
    result.measures["pause_time"] = pauses.sum_s;
    result.measures["contacts_hand"] = results::contact_episodes(task_.touches);
    result.measures["help_asked"] = task_.help;
    result.measures["led_time"] = task_.led_s + (led_since_s_ ? now_s_ - std::max(*led_since_s_, task_.begun_s) : 0.0);
    return result;
}

void TeachingRun::end_lap(bool reached) {
    TaskResult result = measured(laps_.stops.back().name);
    result.measures["reached"] = reached ? 1.0 : 0.0;
    // At the start of the lap, the walker was moved to the base, and the recorded walk begins there. So compare the
    // whole walk with the route.
    int errors = times_off(laps_.shortest.points_m, task_.walk, step().off_route_m);
    if (reached) {
        // Measure the shortest route to where the walker arrived, which is a little before the stop itself.
        std::vector<TaughtPlace> stops = led_stops();
        stops.back().stand_m = view_.feet_m;
        const navigation::Route shortest = world_->way(world_->base().stand_m, stops, laps_.blocked);
        if (const auto ratio = results::path_ratio(results::walked_length_m(task_.walk),
                                                   results::level_length_m(shortest.points_m), shortest.reaches))
            result.measures["path_ratio"] = *ratio;
    }
    const results::TurnsMet turns = results::turns_met(laps_.shortest.points_m, task_.walk);
    result.measures["turns_missed"] = turns.missed;
    result.measures["turns_early"] = turns.early;
    errors += turns.missed;
    if (!laps_.blocked.empty()) {
        result.measures["detour"] = reached ? 1.0 : 0.0;
        if (reached && laps_.met_s) result.measures["detour_time"] = *laps_.left_s - *laps_.met_s;
    }
    keep(std::move(result));
    act(core::TeacherActed::Kind::Leave);
    acts_.emplace_back(core::Announcement{
        phrase(reached ? "teaching.reached" : "teaching.left_way", {{"name", laps_.stops.back().name}}),
        cues::SpeechClass::Answer});
    if (!laps_.errors_before || errors <= *laps_.errors_before)
        laps_.level = std::min(laps_.level + 1, step().help_percent.size() - 1);
    laps_.errors_before = errors;
    if (++laps_.lap < static_cast<int>(step().help_percent.size())) return begin_lap();
    for (const FeatureId door : laps_.blocked)
        if (std::find(shut_.begin(), shut_.end(), door) == shut_.end())
            act(core::TeacherActed::Kind::Open, spoken_name(world_->scene()->features[door.value]),
                static_cast<double>(door.value));
    laps_ = {};
    end_step();
}

void TeachingRun::end_step() {
    if (++at_ < order_.size()) return begin_step();
    at_ = order_.size() - 1;
    finish(true);
}

void TeachingRun::finish(bool all) {
    if (over_) return;
    over_ = true;
    finished_ = all;
    act(core::TeacherActed::Kind::Summary, summary());
    act(core::TeacherActed::Kind::End);
    const std::size_t next = start_.session + 1;
    std::string words = phrase(all ? "teaching.over" : "teaching.left", {{"name", session().name}});
    if (all && next < world_->lesson().sessions.size())
        words = one_after(words, phrase("teaching.next_session", {{"name", world_->lesson().sessions[next].name}}));
    acts_.emplace_back(core::Announcement{words, cues::SpeechClass::Answer});
}

std::string TeachingRun::next(double now_s) {
    now_s_ = now_s;
    if (!begun_) return phrase("desk_order.not_begun");
    if (over_) return phrase("desk_order.ended");
    question_.text.clear();
    end_task();
    if (over_) return phrase("desk_order.ended");
    return phrase("desk_order.now", {{"task", question_.text.empty() ? question_.task : question_.text}});
}

void TeachingRun::end_task() {
    const TaughtStep& now = step();
    if (now.kind == StepKind::Go) return end_lap(false);
    if (now.kind == StepKind::Learn || now.kind == StepKind::Free) {
        TaskResult result = measured(now.room);
        if (now.kind == StepKind::Learn) {
            if (task_.walls_percent) result.measures["walls_percent"] = *task_.walls_percent;
            if (task_.exits_percent) result.measures["exits_percent"] = *task_.exits_percent;
        }
        keep(std::move(result));
    }
    end_step();
}

std::string TeachingRun::repeat() {
    if (!begun_) return phrase("desk_order.not_begun");
    if (over_) return phrase("desk_order.ended");
    acts_.emplace_back(
        core::Announcement{question_.text.empty() ? question_.task : question_.text, cues::SpeechClass::Answer});
    return phrase("desk_order.told_again");
}

std::string TeachingRun::change_help(int by) {
    if (!begun_ || over_ || step().kind != StepKind::Go) return phrase("desk_order.no_help_here");
    const std::size_t last = step().help_percent.size() - 1;
    if (by > 0 && laps_.level > 0) --laps_.level;
    else if (by < 0 && laps_.level < last) ++laps_.level;
    std::string words = phrase("teaching.help_is", {{"percent", static_cast<int>(std::lround(100.0 * level()))}});
    acts_.emplace_back(core::Announcement{words, cues::SpeechClass::Answer});
    lead();
    return words;
}

std::string TeachingRun::lead_to(const std::string& name) {
    const TaughtPlace* to = world_->place(name);
    if (!to) return phrase("teaching.no_name", {{"name", name}, {"nearest", world_->nearest(name)}});
    if (!begun_) return phrase("desk_order.not_begun");
    if (over_) return phrase("desk_order.ended");
    const StepKind kind = step().kind;
    if (kind == StepKind::Point || kind == StepKind::Distance || kind == StepKind::Order)
        return phrase("desk_order.would_answer");
    acts_.emplace_back(core::TeacherActed{core::TeacherActed::Kind::Lead, {}, {to->name}, {to->stand_m}, 1.0});
    led_to_ = to->name;
    return phrase("desk_order.leads", {{"name", to->name}});
}

std::string TeachingRun::leave_lead() {
    if (led_to_.empty()) return phrase("desk_order.leads_nowhere");
    end_teachers_lead();
    if (begun_ && !over_ && step().kind == StepKind::Go) lead();
    return phrase("desk_order.leads_no_more");
}

void TeachingRun::end_teachers_lead() {
    if (!std::exchange(led_to_, {}).empty()) act(core::TeacherActed::Kind::Leave);
}

std::string TeachingRun::block(const std::string& name, bool blocked) {
    const auto door = world_->door(name);
    if (!door) return phrase("teaching.no_door", {{"name", name}, {"nearest", world_->nearest_door(name)}});
    const bool on_way = begun_ && !over_ && !laps_.stops.empty();
    std::vector<FeatureId> doors = laps_.blocked;
    std::erase(doors, *door);
    if (blocked) doors.push_back(*door);
    if (blocked && on_way && !world_->way(view_.feet_m, {laps_.stops.back()}, doors).reaches)
        return phrase("teaching.no_way_round", {{"name", laps_.stops.back().name}});
    std::erase(shut_, *door);
    if (blocked) shut_.push_back(*door);
    act(blocked ? core::TeacherActed::Kind::Block : core::TeacherActed::Kind::Open, name,
        static_cast<double>(door->value));
    std::string happened = phrase(blocked ? "desk_order.blocked" : "desk_order.opened", {{"door", name}});
    if (!on_way) return happened;
    laps_.blocked = std::move(doors);
    plan_lap();
    lead();
    return happened;
}

void TeachingRun::note(const std::string& text) { act(core::TeacherActed::Kind::Note, one_line(text)); }

std::string TeachingRun::end(double now_s) {
    now_s_ = now_s;
    if (begun_ && !over_) finish(false);
    return phrase(begun_ ? "desk_order.ended" : "desk_order.not_begun");
}

}  // namespace handrail::teaching
