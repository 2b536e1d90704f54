#include "app/core/labyrinth/labyrinth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/bodies/body_words.h"
#include "app/core/learning/time_words.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr double kMoved_m = 0.01;  // the clock runs from then on
constexpr double kBack_s = 1.0;    // so long after it fell the ball is back
constexpr double kNearer_m = 0.05, kStuck_s = 60.0;
constexpr double kLookDown_m = 0.3;  // over a hole, for what lies on it
constexpr double kFarWall_m = 20.0;
constexpr double kLoudness = 0.6;

bool holds(const Aabb& box_m, const Vec3& at_m) {
    return at_m.x >= box_m.min_m.x && at_m.x <= box_m.max_m.x && at_m.y >= box_m.min_m.y && at_m.y <= box_m.max_m.y &&
           at_m.z >= box_m.min_m.z && at_m.z <= box_m.max_m.z;
}

double halves(double rolls) { return std::round(2.0 * rolls) / 2.0; }

}  // namespace

void Labyrinth::enter_world(double now_s) {
    covered_.clear();
    soundscape_.add({});
    ball_ = context_.world.scene->placed.size();
    for (std::size_t i = 0; plan().there() && i < context_.world.scene->placed.size(); ++i)
        if (context_.world.scene->placed[i].feature == plan().ball) ball_ = i;
    if (!there()) return;
    start_m_ = ball_m();
    const Aabb& box = context_.world.scene->placed[ball_].model->bounds_m;
    radius_m_ = 0.5 * std::min({box.size_m().x, box.size_m().y, box.size_m().z});
    covered_.assign(plan().holes.size(), false);
    begin(now_s);
    look_at_holes(now_s, false);
    sound();
}

std::string Labyrinth::opening_words() const {
    if (!there()) return {};
    return phrase("labyrinth.begin", {{"level", plan().level},
                                      {"state", state_words()},
                                      {"key", context_.keys.keys_of(Command::Use)},
                                      {"again", context_.keys.keys_of(Command::PutBack)}});
}

Vec3 Labyrinth::at(FeatureId feature) const {
    for (std::size_t i = 0; i < context_.world.scene->placed.size(); ++i)
        if (context_.world.scene->placed[i].feature == feature) return context_.world.things.at(i).position_m;
    return Vec3(0.0);
}

Vec3 Labyrinth::ball_m() const { return context_.world.things.at(ball_).position_m; }

double Labyrinth::to_goal_m() const {
    double least_m = 1e9;
    for (const LabyrinthPlan::Place& goal : plan().goals)
        least_m = std::min(least_m, glm::length(ball_m() - goal.box_m.centre_m()));
    return least_m;
}

// From the ball, in rolls of it: "2 rolls north, 1.5 rolls east".
std::string Labyrinth::off_words(const Vec3& to_m) const {
    const Vec3 off = to_m - ball_m();
    std::string text;
    const auto add = [&](double rolls, const char* plus, const char* minus) {
        if (halves(rolls) == 0.0) return;
        text += (text.empty() ? "" : ", ") + phrase(rolls > 0.0 ? plus : minus, {{"rolls", halves(std::abs(rolls))}});
    };
    add(off.y / roll_m(), "labyrinth.north", "labyrinth.south");
    add(off.x / roll_m(), "labyrinth.east", "labyrinth.west");
    return text.empty() ? phrase("labyrinth.here") : text;
}

// How far the ball can roll to the four sides.
std::string Labyrinth::free_words() const {
    constexpr std::array kWays{Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0), Vec3(-1.0, 0.0, 0.0)};
    constexpr std::array kSides{"labyrinth.north", "labyrinth.east", "labyrinth.south", "labyrinth.west"};
    std::string text;
    for (std::size_t i = 0; i < kWays.size(); ++i) {
        // From inside the ball, which is then not met itself.
        const TraceHit hit = context_.world.solids->trace(ball_m(), ball_m() + kWays[i] * kFarWall_m, {}, true);
        const double free_m = (hit.hit ? hit.fraction * kFarWall_m : kFarWall_m) - radius_m_;
        const double rolls = std::floor(2.0 * free_m / roll_m()) / 2.0;
        if (rolls > 0.0) text += (text.empty() ? "" : ", ") + phrase(kSides[i], {{"rolls", rolls}});
    }
    return text.empty() ? phrase("labyrinth.nowhere") : text;
}

std::string Labyrinth::state_words() const {
    const auto nearest = std::min_element(plan().goals.begin(), plan().goals.end(), [&](const auto& a, const auto& b) {
        return glm::length(a.box_m.centre_m() - ball_m()) < glm::length(b.box_m.centre_m() - ball_m());
    });
    std::string text = phrase("labyrinth.goal", {{"off", off_words(nearest->box_m.centre_m())}});
    text += " " + phrase("labyrinth.free", {{"sides", free_words()}});
    for (std::size_t i = 0; i < plan().holes.size(); ++i)
        text += " " + phrase(covered_[i] ? "labyrinth.hole_covered" : "labyrinth.hole",
                             {{"off", off_words(plan().holes[i].box_m.centre_m())}});
    for (const std::vector<FeatureId>* things : {&plan().planks, &plan().blocks})
        for (const FeatureId thing : *things)
            text +=
                " " + phrase("labyrinth.thing", {{"name", body_name(context_, thing)}, {"off", off_words(at(thing))}});
    return text;
}

bool Labyrinth::act(Command command, double now_s) {
    if (command != Command::Labyrinth && !there()) return false;
    switch (command) {
        case Command::Labyrinth:
            context_.answer(there() ? state_words() : phrase("labyrinth.none"), now_s);
            return true;
        case Command::RepeatLeg:  // nobody is led here, and R is the key of the game
        case Command::PutBack:
            bodies_.restart();
            begin(now_s);
            context_.answer(phrase("labyrinth.anew"), now_s);
            return true;
        default:
            return false;
    }
}

void Labyrinth::begin(double now_s) {
    began_s_ = fallen_s_ = -1.0;
    over_ = hint_told_ = false;
    nearest_m_ = to_goal_m();
    nearer_s_ = now_s;
}

// Something else than the ball lies over its middle; while the ball is there, as it was.
bool Labyrinth::covered(std::size_t which) const {
    const LabyrinthPlan::Place& hole = plan().holes[which];
    Vec3 from = hole.box_m.centre_m();
    from.z = hole.box_m.max_m.z + kLookDown_m;
    Vec3 to = from;
    to.z = hole.box_m.max_m.z;
    const TraceHit hit = context_.world.solids->trace(from, to, {}, true);
    if (hit.hit && hit.feature == plan().ball) return covered_[which];
    return hit.hit && std::any_of(context_.world.scene->bodies.begin(), context_.world.scene->bodies.end(),
                                  [&](const FreeBody& body) { return body.feature == hit.feature; });
}

void Labyrinth::look_at_holes(double now_s, bool tell) {
    bool changed = false;
    for (std::size_t i = 0; i < plan().holes.size(); ++i) {
        const bool is = covered(i);
        if (is == covered_[i]) continue;
        covered_[i] = is;
        changed = true;
        if (!tell) continue;
        if (is) context_.play_at(SoundKind::Arrived, plan().holes[i].box_m.centre_m(), now_s);
        context_.say(phrase(is ? "labyrinth.covered" : "labyrinth.open"), SpeechClass::Answer, now_s);
    }
    if (changed) sound();
}

// Open holes hum, and goals ring.
void Labyrinth::sound() {
    std::vector<SoundSource> sounds;
    for (std::size_t i = 0; i < plan().holes.size(); ++i)
        if (!covered_[i]) sounds.push_back({plan().holes[i].box_m.centre_m(), {}, "hum", kLoudness});
    for (const LabyrinthPlan::Place& goal : plan().goals)
        sounds.push_back({goal.box_m.centre_m(), {}, "tolling", kLoudness});
    soundscape_.add(sounds);
}

void Labyrinth::tick(double now_s) {
    if (!there()) return;
    if (fallen_s_ >= 0.0) {
        if (now_s - fallen_s_ < kBack_s) return;
        fallen_s_ = -1.0;
        bodies_.restart();
        nearest_m_ = 1e9;
        return context_.answer(phrase("labyrinth.back"), now_s);
    }
    if (!bodies_.any_moving()) {
        // Only who has begun and holds on to nothing new is stuck.
        if (began_s_ >= 0.0 && !over_ && !hint_told_ && now_s - nearer_s_ > kStuck_s) {
            hint_told_ = true;
            context_.answer(
                phrase("labyrinth.stuck", {{"free", free_words()}, {"again", context_.keys.keys_of(Command::PutBack)}}),
                now_s);
        }
        return;
    }
    const Vec3 ball = ball_m();
    if (began_s_ < 0.0 && glm::length(ball - start_m_) > kMoved_m) began_s_ = nearer_s_ = now_s;
    look_at_holes(now_s, true);
    if (over_) return;
    for (const LabyrinthPlan::Place& hole : plan().holes)
        if (holds(hole.box_m, ball)) {
            fallen_s_ = now_s;
            context_.play_at(SoundKind::DropNear, ball, now_s);
            return context_.answer(phrase("labyrinth.fell"), now_s);
        }
    if (const double far_m = to_goal_m(); far_m < nearest_m_ - kNearer_m) {
        nearest_m_ = far_m;
        nearer_s_ = now_s;
    }
    for (const LabyrinthPlan::Place& goal : plan().goals)
        if (holds(goal.box_m, ball) && began_s_ >= 0.0) {
            over_ = true;
            const double took_s = now_s - began_s_;
            context_.play(SoundKind::Arrived, now_s);
            return context_.answer(phrase("labyrinth.finished", {{"time", time_words(took_s)}}) + " " +
                                       best_.finish(context_.world.scene->name, took_s),
                                   now_s);
        }
}

}  // namespace handrail
