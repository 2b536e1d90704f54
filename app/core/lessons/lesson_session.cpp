#include "app/core/lessons/lesson_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

// Delay of an announcement, so that a name being spoken at the same time can end first.
constexpr double kAfterName_s = 1.5;

}  // namespace

LessonSession::LessonSession(const SessionContext& context, LeaveRequested& leave_requested)
    : SessionPart(context), leave_requested_(leave_requested), who_speaks_(phrase("session.your_voice")) {}

bool LessonSession::hand() const { return context_.hands.right.present && !context_.hands.keys_alone; }

bool LessonSession::in_first_minutes() const { return run_ && &run_->lesson() == &first_minutes(); }

bool LessonSession::greeting_waits() const {
    return in_first_minutes() && (run_->goal() == LessonGoal::Begin || run_->goal() == LessonGoal::SetUp);
}

bool LessonSession::idle() const { return said_later_.empty() && after_ == After::Nothing && (!run_ || did_.empty()); }

void LessonSession::begin_first_minutes(const std::string& who_speaks, bool owner_sets_up, double now_s) {
    owner_sets_up_ = owner_sets_up;
    const auto at = static_cast<std::size_t>(std::max(0, context_.settings.welcome.step));
    who_speaks_ = who_speaks;
    if (at > 0 && at < first_minutes().steps.size()) context_.answer(phrase("lesson.welcome_back"), now_s);
    begin(first_minutes(), at < first_minutes().steps.size() ? at : 0, now_s);
}

void LessonSession::begin(const Lesson& lesson, std::size_t at, double now_s) {
    contract_pre(at < lesson.steps.size() && std::isfinite(now_s));
    said_later_.clear();
    did_.clear();
    bumped_.clear();
    set_up_over_ = !owner_sets_up_;
    run_.emplace(lesson, hand(), who_speaks_, at);
    announce(run_->begin(), now_s);
}

bool LessonSession::act(Command command, double now_s) {
    if (command == Command::Lessons) open_list(now_s);
    else if (command == Command::FirstMinutes) begin(first_minutes(), 0, now_s);
    else return false;
    return true;
}

void LessonSession::announce(const LessonReply& reply, double now_s) {
    if (reply.done && !reply.praise.empty()) context_.play(cues::SoundKind::Arrived, now_s);
    const double later_s = reply.done && !reply.praise.empty() ? now_s + kAfterName_s : now_s;
    if (!reply.praise.empty())
        said_later_.push_back({reply.at_once ? now_s : later_s, reply.praise, cues::SpeechTopic::Praise});
    praise_ = reply.praise;
    const bool nothing_to_set_up = reply.set_up && !owner_sets_up_;
    if (!reply.instruction.empty() && !nothing_to_set_up) said_later_.push_back({later_s, reply.instruction});
    if (in_first_minutes() && reply.done) keep_welcome(static_cast<int>(run_->at()), false);
    if (reply.begin_here) on_begin_here(now_s);
    if (reply.set_up && owner_sets_up_) {
        context_.requests.first_set_up = true;
        context_.requests.set_up = true;
    }
    if (reply.finished) {
        const bool first = in_first_minutes();
        const bool of_tutorial = !first && reply.done;
        run_.reset();
        if (first) after_ = After::Choose;
        else if (of_tutorial) after_ = After::Lessons;
    }
    say_due(now_s);
}

// Says the announcements whose delay has passed. After the end of a lesson, begins what follows the lesson.
void LessonSession::say_due(double now_s) {
    const auto due = std::stable_partition(said_later_.begin(), said_later_.end(),
                                           [&](const SaidLater& later) { return later.due_s <= now_s; });
    for (auto it = said_later_.begin(); it != due; ++it) context_.announce(it->topic, it->text, now_s);
    said_later_.erase(said_later_.begin(), due);
    if (!said_later_.empty()) return;
    const After after = std::exchange(after_, After::Nothing);
    if (after == After::Choose) choose_what_next(now_s);
    if (after == After::Lessons)
        context_.answer(phrase("lesson.over", {{"key", context_.keys.keys_of(Command::Lessons)}}), now_s);
}

void LessonSession::announce_anew(cues::SpeechTopic topic, double now_s) {
    if (topic == cues::SpeechTopic::Praise) {
        if (run_ && !praise_.empty()) context_.announce(topic, praise_, now_s, {.anew = true});
        return;
    }
    if (run_ && said_later_.empty() && !(run_->goal() == LessonGoal::SetUp && !owner_sets_up_))
        context_.announce(cues::SpeechTopic::Lesson, run_->instruction(), now_s, {.anew = true});
}

// Returns what has happened since the last call.
LessonSense LessonSession::sense() {
    const HandsState& hands = context_.hands;
    const Vec3 feet_m = context_.avatar.feet_m();
    LessonSense sense;
    for (const servo::ToolState* tool : {&hands.tool, &hands.left_tool})
        for (int i = 0; tool->workspace_jump == hands.pose.jump && i < tool->contacts.count; ++i)
            sense.met.push_back(tool->contacts.contacts[static_cast<std::size_t>(i)].feature);
    sense.met.insert(sense.met.end(), bumped_.begin(), bumped_.end());
    sense.did = std::exchange(did_, {});
    sense.at_home = glm::length(feet_m - context_.world.home_feet_m) < 0.5 * context_.settings.walk.step_length_m;
    sense.forces_on = hands.tuning.forces_on && !hands.tuning.panic;
    sense.set_up = set_up_over_;
    sense.off_middle_m = glm::length(hands.tool.hand_m);
    sense.beacon = beacon_calls();
    sense.at_beacon = !sense.beacon && at_beacon();
    return sense;
}

void LessonSession::tick(double now_s) {
    if (run_ && context_.world.scene) {
        run_->set_hand(hand());
        const LessonReply reply = run_->tick(sense(), *context_.world.scene);
        if (reply.done || reply.finished) announce(reply, now_s);
    }
    did_.clear();
    bumped_.clear();
    if (!said_later_.empty() || after_ != After::Nothing) say_due(now_s);
}

bool LessonSession::takes(Command command, double now_s) {
    if (!run_) return false;
    if (command == Command::Leave) {
        if (!leave_requested_.lately(now_s) && run_->goal() != LessonGoal::Begin) {
            leave_requested_.at_s = now_s;
            context_.answer(
                phrase("lesson.is", {{"name", phrase(run_->lesson().name)}, {"instruction", run_->instruction()}}),
                now_s);
            return true;
        }
        leave_requested_ = {};
        leave(now_s);
        return true;
    }
    if (run_->goal() != LessonGoal::Begin) return false;
    if (command == Command::Use) {
        note(command);
        return true;
    }
    if (command == Command::Repeat) {
        context_.answer(run_->instruction(), now_s);
        return true;
    }
    // A person who gives another command already knows what to do, so the lesson ends.
    if (command != Command::StopSpeech && command != Command::StopEverything && command != Command::VerbosityCycle)
        leave(now_s);
    return false;
}

bool LessonSession::take_line(std::string_view line, double now_s) {
    if (!run_ || run_->goal() != LessonGoal::Begin) return false;
    for (const auto& [word, command] : {std::pair{"", Command::Use}, std::pair{"enter", Command::Use},
                                        std::pair{"space", Command::Repeat}, std::pair{"escape", Command::Leave}}) {
        if (lower_ascii(line) != word) continue;
        context_.session_requests.perform(command, now_s);
        return true;
    }
    return false;
}

void LessonSession::leave(double now_s) {
    if (!run_) return;
    const bool greet = greeting_waits(), first = in_first_minutes();
    run_.reset();
    said_later_.clear();
    praise_.clear();
    after_ = After::Nothing;
    if (first) keep_welcome(0, true);
    std::string text = phrase(first ? "lesson.introduction_left" : "lesson.left");
    if (greet && context_.world.scene) text += " " + world_greeting();
    context_.answer(text, now_s);
}

void LessonSession::keep_welcome(int step, bool done) {
    context_.set("welcome.step", fmt::format("{}", step), context_.tick_s);
    if (done) context_.set("welcome.done", "true", context_.tick_s);
}

void LessonSession::choose_what_next(double now_s) {
    ListSpec list;
    list.title = phrase("lesson.next.title");
    std::vector<std::function<void()>> acts;
    const auto add = [&](std::string name, std::function<void()> act) {
        list.items.push_back({std::move(name), {}, false});
        acts.push_back(std::move(act));
    };
    const auto run = [this](std::string_view word) {
        return [this, command = find_command(word)->command] {
            context_.session_requests.perform(command, context_.tick_s);
        };
    };
    add(phrase("lesson.next.freely"), [] {});
    add(phrase("lesson.next.walls"), run("learn"));
    add(phrase("lesson.next.clock"), run("hunt"));
    add(phrase("lesson.next.hunt"), [this] { on_hunt(context_.tick_s); });
    add(phrase("lesson.next.lessons"), [this] { open_list(context_.tick_s); });
    add(phrase("lesson.next.buildings"), [this] { on_worlds(context_.tick_s); });
    add(phrase("lesson.next.settings"), [this] { on_settings(context_.tick_s); });
    const auto saved = [this] {
        keep_welcome(0, true);
        context_.answer(phrase("lesson.saved"), context_.tick_s);
    };
    list.chosen = [acts, saved](std::size_t i) {
        saved();
        acts[i]();
    };
    list.left = saved;
    context_.open_list(std::move(list), now_s);
}

void LessonSession::open_list(double now_s) {
    ListSpec list;
    list.title = phrase("lesson.next.lessons");
    for (const Lesson& lesson : lessons()) list.items.push_back({phrase(lesson.name), {}, false});
    list.items.push_back({phrase(first_minutes().name), phrase("lesson.in_first_room"), false});
    list.chosen = [this](std::size_t i) {
        begin(i < lessons().size() ? lessons()[i] : first_minutes(), 0, context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
