#include "app/core/lesson.h"

#include <algorithm>
#include <array>

namespace handrail {
namespace {

using enum LessonGoal;

constexpr double kMiddle_m = 0.025;  // hand metres

constexpr std::array kFindWall{
    LessonStep{MeetWall, "Find a wall. Reach forward slowly until something stops your hand.",
               "Find a wall. Press Up to walk. A soft tone grows as the wall comes near, and a thud tells that you met it.", "That is a wall."},
};
constexpr std::array kFollowWall{
    LessonStep{MeetWall, "Follow a wall to a corner. First reach forward to a wall.", "Follow a wall to a corner. First walk to a wall with Up.", "Good."},
    LessonStep{NextWall, "Now slide along it, always touching it, until another wall stops your hand.",
               "Now turn along it: press Right four times. Then walk on with Up until the next wall.", "Corner."},
};
constexpr std::array kFindDoor{
    LessonStep{Look, "Find a door. Press 2 to hear what is around you.", "Find a door. Press 2 to hear what is around you.", "Good."},
    LessonStep{MeetDoor, "Now reach to the door, or walk to it and touch it.", "Now turn to the door with Left or Right, and walk to it with Up.",
               "That is the door. Enter opens it and shuts it."},
};
constexpr std::array kWhereAmI{
    LessonStep{Ask, "Where am I? Press F2 to hear where you are, which way you face and what is near.",
               "Where am I? Press F2 to hear where you are, which way you face and what is near.", "F2 tells that at any time."},
    LessonStep{GoHome, "Press Home to go back to the base.", "Walk a step with Up. Then press Home to go back to the base.", "You are at the base again."},
};
constexpr std::array kForcesOff{
    LessonStep{ForcesOff, "The key that takes all force away. Press the grave key, left of 1, or F.", "", "All force is off."},
    LessonStep{ForcesOn, "Press it again to feel again. The force comes back slowly.", "", "That key works at any time. F12 stops force and sound at once."},
};
constexpr std::array kLessons{
    Lesson{"Find a wall", kFindWall}, Lesson{"Follow a wall to a corner", kFollowWall},  Lesson{"Find a door", kFindDoor},
    Lesson{"Where am I", kWhereAmI},  Lesson{"Switch the force off and on", kForcesOff},
};

constexpr std::string_view kWelcome = "Welcome. Handrail is speaking with {}. Press Enter to begin, Space to hear again, Escape to leave.";
constexpr std::array kFirst{
    LessonStep{Begin, kWelcome, kWelcome, ""},
    LessonStep{SetUp, "First your headphones, and what your hand holds.", "First your headphones.", ""},
    LessonStep{Middle, "Bring your hand to the middle, in front of you.", "", ""},
    LessonStep{
        MeetWall,
        "You are in a small room, six by four metres, nine by six steps. The door is behind you. You face north. A wall is in front of your hand. Reach "
        "forward "
        "slowly.",
        "You are in a small room, six by four metres, nine by six steps. The door is behind you. You face north. A wall is in front of you. Press Up to walk a "
        "step, until you meet it.",
        "Your first wall."},
    LessonStep{MeetNamed, "Slide left along it, a little lower, to the radiator.",
               "Along the wall to your left is a radiator: press Left four times, then walk with Up.", "Well found.", "Radiator"},
    LessonStep{NextWall, "Slide right along the wall, as far as it goes, to the corner.",
               "Now the other way, to the corner: press Right eight times, then hold Up.", "Corner."},
    LessonStep{GoHome, "Back to the door: press Home. Your hand is not dragged, the world moves under it.", "Back to the door: press Home.",
               "You are at the door again: behind you, handle on your right."},
};
constexpr Lesson kFirstMinutes{"The first minutes", kFirst};

bool did(const LessonSense& sense, Command command) { return std::find(sense.did.begin(), sense.did.end(), command) != sense.did.end(); }

}  // namespace

std::span<const Lesson> lessons() { return kLessons; }
const Lesson& first_minutes() { return kFirstMinutes; }

LessonRun::LessonRun(const Lesson& lesson, bool hand, std::string who_speaks, std::size_t at)
    : lesson_(lesson), hand_(hand), who_speaks_(std::move(who_speaks)), at_(std::min(at, lesson.steps.size() - 1)) {}

bool LessonRun::is_left_out(const LessonStep& step) const { return (hand_ ? step.hand : step.body).empty(); }

std::string LessonRun::instruction() const {
    const LessonStep& step = lesson_.steps[at_];
    std::string text(hand_ ? step.hand : step.body);
    if (const std::size_t at = text.find("{}"); at != std::string::npos) text.replace(at, 2, who_speaks_);
    return text;
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
    if (reply.finished) reply.instruction = "This lesson needs a touch device.";
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
            done = meet([&](FeatureId id, const Feature& feature) { return feature.kind == FeatureKind::Wall && id != last_wall_; });
            break;
        case LessonGoal::MeetNamed:
            done = meet([&](FeatureId, const Feature& feature) { return feature.name == step.named; });
            break;
        case LessonGoal::MeetDoor:
            done = meet([](FeatureId, const Feature& feature) { return feature.kind == FeatureKind::Door; });
            break;
        case LessonGoal::Ask:
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
    }
    if (!done) return {};
    LessonReply reply;
    reply.done = true;
    reply.begin_here = step.goal == LessonGoal::Middle;
    reply.at_once = step.goal == LessonGoal::NextWall;
    reply.praise = step.praise;
    return enter(at_ + 1, std::move(reply));
}

}  // namespace handrail
