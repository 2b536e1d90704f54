#include "app/core/lessons/lesson.h"

#include <algorithm>
#include <array>

#include "worlds/base/language.h"

namespace handrail::core {
namespace {

using enum LessonGoal;

constexpr double kMiddle_m = 0.025;  // hand metres; within this distance, the hand is at the middle of its workspace

constexpr std::array kFindWall{
    LessonStep{MeetWall, "lesson.find_wall.hand", "lesson.find_wall.body", "lesson.find_wall.done"}};
constexpr std::array kFollowWall{
    LessonStep{MeetWall, "lesson.follow.hand", "lesson.follow.body", "lesson.good"},
    LessonStep{NextWall, "lesson.follow.on_hand", "lesson.follow.on_body", "lesson.corner"},
};
constexpr std::array kFindDoor{
    LessonStep{Look, "lesson.door.look", "lesson.door.look", "lesson.good"},
    LessonStep{MeetDoor, "lesson.door.hand", "lesson.door.body", "lesson.door.done"},
};
constexpr std::array kWhereAmI{
    LessonStep{WhereAmI, "lesson.where.ask", "lesson.where.ask", "lesson.where.asked"},
    LessonStep{GoHome, "lesson.where.hand", "lesson.where.body", "lesson.where.done"},
};
constexpr std::array kForcesOff{
    LessonStep{ForcesOff, "lesson.forces.off", "", "lesson.forces.is_off"},
    LessonStep{ForcesOn, "lesson.forces.on", "", "lesson.forces.done"},
};
constexpr std::array kBeacon{
    LessonStep{SetBeacon, "lesson.beacon.set", "lesson.beacon.set", "lesson.beacon.calls"},
    LessonStep{ReachBeacon, "lesson.beacon.reach", "lesson.beacon.reach", "lesson.beacon.done"},
};
constexpr std::array kLessons{
    Lesson{"lesson.name.find_wall", kFindWall}, Lesson{"lesson.name.follow", kFollowWall},
    Lesson{"lesson.name.find_door", kFindDoor}, Lesson{"lesson.name.where", kWhereAmI},
    Lesson{"lesson.name.forces", kForcesOff},   Lesson{"lesson.name.beacon", kBeacon},
};

constexpr std::array kFirst{
    LessonStep{Begin, "lesson.first.welcome", "lesson.first.welcome", ""},
    LessonStep{SetUp, "lesson.first.set_up_hand", "lesson.first.set_up_body", ""},
    LessonStep{Middle, "lesson.first.middle", "", ""},
    LessonStep{MeetWall, "lesson.first.wall_hand", "lesson.first.wall_body", "lesson.first.wall"},
    LessonStep{MeetNamed, "lesson.first.radiator_hand", "lesson.first.radiator_body", "lesson.first.found", "Radiator"},
    LessonStep{NextWall, "lesson.first.corner_hand", "lesson.first.corner_body", "lesson.corner"},
    LessonStep{GoHome, "lesson.first.home_hand", "lesson.first.home_body", "lesson.first.home"},
};
constexpr Lesson kFirstMinutes{"lesson.name.first", kFirst};

bool did(const LessonSense& sense, Command command) {
    return std::find(sense.did.begin(), sense.did.end(), command) != sense.did.end();
}

}  // namespace

std::span<const Lesson> lessons() { return kLessons; }
const Lesson& first_minutes() { return kFirstMinutes; }

LessonRun::LessonRun(const Lesson& lesson, bool hand, std::string who_speaks, std::size_t at)
    : lesson_(lesson), hand_(hand), who_speaks_(std::move(who_speaks)), at_(std::min(at, lesson.steps.size() - 1)) {}

bool LessonRun::is_left_out(const LessonStep& step) const { return (hand_ ? step.hand : step.body).empty(); }

std::string LessonRun::instruction() const {
    const LessonStep& step = lesson_.steps[at_];
    return phrase(hand_ ? step.hand : step.body, {{"voice", who_speaks_}});
}

LessonReply LessonRun::enter(std::size_t at, LessonReply reply) {
    while (at < lesson_.steps.size() && is_left_out(lesson_.steps[at])) ++at;
    if (at >= lesson_.steps.size()) {
        reply.finished = true;
        return reply;
    }
    at_ = at;
    reply.instruction = instruction();
    reply.set_up = lesson_.steps[at].goal == LessonGoal::SetUp;
    return reply;
}

LessonReply LessonRun::begin() {
    LessonReply reply = enter(at_, {});
    if (reply.finished) reply.instruction = phrase("lesson.needs_device");
    return reply;
}

LessonReply LessonRun::tick(const LessonSense& sense, const Scene& scene) {
    const LessonStep& step = lesson_.steps[at_];
    FeatureId met = kNoFeature;
    const auto meet = [&](auto wanted) {
        for (const FeatureId id : sense.met)
            if (const Feature* feature = scene.find(id); feature && wanted(id, *feature)) met = id;
        return met != kNoFeature;
    };
    const auto is_wall = [](FeatureId, const Feature& feature) { return feature.kind == FeatureKind::Wall; };
    bool done = false;
    switch (step.goal) {
        case LessonGoal::Begin:
            done = did(sense, Command::Use);
            break;
        case LessonGoal::SetUp:
            done = sense.set_up;
            break;
        case LessonGoal::Middle:
            done = sense.off_middle_m < kMiddle_m;
            break;
        case LessonGoal::MeetWall:
            done = meet(is_wall);
            if (done) last_wall_ = met;
            break;
        case LessonGoal::NextWall:
            done = meet([&](FeatureId id, const Feature& feature) {
                return feature.kind == FeatureKind::Wall && id != last_wall_;
            });
            break;
        case LessonGoal::MeetNamed:
            done = meet([&](FeatureId, const Feature& feature) { return feature.name == step.named; });
            break;
        case LessonGoal::MeetDoor:
            done = meet([](FeatureId, const Feature& feature) { return feature.kind == FeatureKind::Door; });
            break;
        case LessonGoal::WhereAmI:
            done = did(sense, Command::WhereAmI);
            break;
        case LessonGoal::Look:
            done = did(sense, Command::AroundMe);
            break;
        case LessonGoal::GoHome:
            done = did(sense, Command::Home) && sense.at_home;
            break;
        case LessonGoal::ForcesOff:
            done = !sense.forces_on;
            break;
        case LessonGoal::ForcesOn:
            done = sense.forces_on;
            break;
        case LessonGoal::SetBeacon:
            done = sense.beacon;
            break;
        case LessonGoal::ReachBeacon:
            done = sense.at_beacon;
            break;
    }
    if (!done) return {};
    LessonReply reply;
    reply.done = true;
    reply.begin_here = step.goal == LessonGoal::Middle;
    reply.at_once = step.goal == LessonGoal::NextWall;
    if (!step.praise.empty()) reply.praise = phrase(step.praise);
    return enter(at_ + 1, std::move(reply));
}

}  // namespace handrail::core
