// AppCore's part on lessons and the first minutes: what they are told, when they speak, where they lead. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr double kAfterName_s = 1.5;  // a name that is being said is heard first
constexpr double kLeaveWindow_s = 5.0;

}  // namespace

bool AppCore::in_first_minutes() const { return lesson_ && &lesson_->lesson() == &first_minutes(); }

bool AppCore::greeting_waits() const { return in_first_minutes() && (lesson_->goal() == LessonGoal::Begin || lesson_->goal() == LessonGoal::SetUp); }

void AppCore::begin_first_minutes(const std::string& who_speaks, bool owner_sets_up, double now_s) {
    owner_sets_up_ = owner_sets_up;
    const auto at = static_cast<std::size_t>(std::max(0, settings_.welcome.step));
    who_speaks_ = who_speaks;
    if (at > 0 && at < first_minutes().steps.size()) answer(phrase("lesson.welcome_back"), now_s);
    begin_lesson(first_minutes(), at < first_minutes().steps.size() ? at : 0, now_s);
}

void AppCore::begin_lesson(const Lesson& lesson, std::size_t at, double now_s) {
    said_later_.clear();
    did_.clear();
    bumped_.clear();
    set_up_over_ = !owner_sets_up_;
    lesson_.emplace(lesson, hand_.present && !keys_alone_, who_speaks_, at);
    tell_lesson(lesson_->begin(), now_s);
}

void AppCore::tell_lesson(const LessonReply& reply, double now_s) {
    if (reply.done && !reply.praise.empty()) play(SoundKind::Arrived, now_s);
    const double later_s = reply.done && !reply.praise.empty() ? now_s + kAfterName_s : now_s;
    if (!reply.praise.empty()) said_later_.push_back({reply.at_once ? now_s : later_s, reply.praise});
    if (!reply.instruction.empty()) said_later_.push_back({later_s, reply.instruction});
    if (in_first_minutes() && reply.done) keep_welcome(static_cast<int>(lesson_->at()), false);
    if (reply.begin_here) publish_pose(now_s, PoseChange::Placed);
    if (reply.set_up && owner_sets_up_) first_set_up_ = calibration_asked_ = true;
    if (reply.finished) {
        const bool first = in_first_minutes();
        const bool of_tutorial = !first && reply.done;
        lesson_.reset();
        if (first) after_lesson_ = AfterLesson::Choose;
        else if (of_tutorial) after_lesson_ = AfterLesson::Lessons;
    }
    say_lesson(now_s);
}

// What waited for a name to be said; then, where a lesson is over, what comes after it.
void AppCore::say_lesson(double now_s) {
    const auto due = std::stable_partition(said_later_.begin(), said_later_.end(), [&](const SaidLater& later) { return later.due_s <= now_s; });
    for (auto it = said_later_.begin(); it != due; ++it) answer(it->text, now_s);
    said_later_.erase(said_later_.begin(), due);
    if (!said_later_.empty()) return;
    const AfterLesson after = std::exchange(after_lesson_, AfterLesson::Nothing);
    if (after == AfterLesson::Choose) choose_what_next(now_s);
    if (after == AfterLesson::Lessons) answer(phrase("lesson.over", {{"key", keys_.keys_of(Command::Lessons)}}), now_s);
}

void AppCore::run_lesson(double now_s) {
    if (lesson_ && scene_) {
        LessonSense sense;
        for (const ToolState* tool : {&tool_, &left_tool_})
            for (int i = 0; tool->workspace_jump == pose_.jump && i < tool->contacts.count; ++i)
                sense.met.push_back(tool->contacts.contacts[static_cast<std::size_t>(i)].feature);
        sense.met.insert(sense.met.end(), bumped_.begin(), bumped_.end());
        sense.did = std::exchange(did_, {});
        sense.at_home = glm::length(feet_m() - home_feet_m_) < 0.5 * settings_.walk.step_length_m;
        sense.forces_on = tuning_.forces_on && !tuning_.panic;
        sense.set_up = set_up_over_;
        sense.off_middle_m = glm::length(tool_.hand_m);
        sense.beacon = guiding_.beacon.on();
        const Vec3 way = nearest_place(guiding_.beacon.thing_m(), feet_m()) - feet_m();
        sense.at_beacon = !sense.beacon && std::hypot(way.x, way.y) <= Beacon::kArrived_m;
        lesson_->set_hand(hand_.present && !keys_alone_);
        const LessonReply reply = lesson_->tick(sense, *scene_);
        if (reply.done || reply.finished) tell_lesson(reply, now_s);
    }
    did_.clear();
    bumped_.clear();
    if (!said_later_.empty() || after_lesson_ != AfterLesson::Nothing) say_lesson(now_s);
}

// True: the command was the lesson's, or is not to be done.
bool AppCore::lesson_takes(Command command, double now_s) {
    if (!lesson_) return false;
    if (command == Command::Leave) {
        if (now_s - leave_asked_s_ > kLeaveWindow_s && lesson_->goal() != LessonGoal::Begin) {
            leave_asked_s_ = now_s;
            answer(phrase("lesson.is", {{"name", phrase(lesson_->lesson().name)}, {"instruction", lesson_->instruction()}}), now_s);
            return true;
        }
        leave_asked_s_ = -1e9;
        leave_lesson(now_s);
        return true;
    }
    if (lesson_->goal() != LessonGoal::Begin) return false;
    if (command == Command::Use) {
        did_.push_back(command);
        return true;
    }
    if (command == Command::Repeat) {
        answer(lesson_->instruction(), now_s);
        return true;
    }
    // Who does something else knows the way about already.
    if (command != Command::StopSpeech && command != Command::StopEverything && command != Command::VerbosityCycle) leave_lesson(now_s);
    return false;
}

void AppCore::leave_lesson(double now_s) {
    if (!lesson_) return;
    const bool greet = greeting_waits(), first = in_first_minutes();
    lesson_.reset();
    said_later_.clear();
    after_lesson_ = AfterLesson::Nothing;
    if (first) keep_welcome(0, true);
    std::string text = phrase(first ? "lesson.introduction_left" : "lesson.left");
    if (greet && scene_) text += " " + entering_text();
    answer(text, now_s);
}

void AppCore::keep_welcome(int step, bool done) {
    settings_.welcome.step = step;
    settings_.welcome.done = settings_.welcome.done || done;
    setting_changes_.emplace_back("welcome.step", fmt::format("{}", step));
    if (done) setting_changes_.emplace_back("welcome.done", "true");
}

void AppCore::choose_what_next(double now_s) {
    ListSpec list;
    list.title = phrase("lesson.next.title");
    std::vector<std::function<void()>> acts;
    const auto add = [&](std::string name, std::function<void()> act) {
        list.items.push_back({std::move(name), {}, false});
        acts.push_back(std::move(act));
    };
    const auto run = [this](std::string_view word) {
        return [this, command = find_command(word)->command] {
            press(command, last_tick_s_);
            release(command);
        };
    };
    add(phrase("lesson.next.freely"), [] {});
    add(phrase("lesson.next.walls"), run("learn"));
    add(phrase("lesson.next.clock"), run("hunt"));
    add(phrase("lesson.next.hunt"), [this] { hunt_in_the_house(); });
    add(phrase("lesson.next.lessons"), [this] { open_lessons(last_tick_s_); });
    add(phrase("lesson.next.buildings"), [this] { open_worlds(last_tick_s_); });
    add(phrase("lesson.next.settings"), [this] { open_setting_topics(last_tick_s_); });
    const auto saved = [this] {
        keep_welcome(0, true);
        answer(phrase("lesson.saved"), last_tick_s_);
    };
    list.chosen = [acts, saved](std::size_t i) {
        saved();
        acts[i]();
    };
    list.left = saved;
    open_list(std::move(list), now_s);
}

// The same hunt, through rooms; where no house comes with the program, here.
void AppCore::hunt_in_the_house() {
    for (const ShelvedWorld& world : worlds_in(shelf_.bundled))
        if (world.file.stem() == "house") {
            hunt_awaits_ = true;
            return want_world(world.file);
        }
    hunt_key(last_tick_s_);
}

void AppCore::open_lessons(double now_s) {
    ListSpec list;
    list.title = phrase("lesson.next.lessons");
    for (const Lesson& lesson : lessons()) list.items.push_back({phrase(lesson.name), {}, false});
    list.items.push_back({phrase(first_minutes().name), phrase("lesson.in_first_room"), false});
    list.chosen = [this](std::size_t i) {
        if (i < lessons().size()) return begin_lesson(lessons()[i], 0, last_tick_s_);
        settings_.welcome.step = 0;
        begin_lesson(first_minutes(), 0, last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

}  // namespace handrail
