#include "app/core/labyrinth/labyrinth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "app/core/bodies/body_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/learning/time_words.h"
#include "worlds/base/language.h"
#include "worlds/scene/building_bounds.h"

namespace handrail::core {
namespace {

constexpr double kFollowed_m = 0.001;  // the camera follows a ball that has moved this far in a tick
constexpr double kMoved_m = 0.01;      // the clock starts once the ball has moved this far
constexpr double kBack_s = 1.0;        // time from the fall of the ball until it is put back
constexpr double kNearer_m = 0.05, kStuck_s = 60.0;
constexpr double kLookDown_m = 0.3;  // height above a hole from which the code looks down for a cover
constexpr double kFarWall_m = 20.0;
constexpr double kThudAgain_s = 0.5;
constexpr double kLoudness = 0.6;
// Largest distances at which the person hears a hole and the goal, in diameters of the ball.
constexpr double kHoleHeard = 10.0, kGoalHeard = 20.0;
constexpr double kSlowestBeat_hz = 2.0, kFastestBeat_hz = 10.0;
constexpr double kSlowestBell_hz = 0.5, kFastestBell_hz = 6.0;

// Returns beats per second that are faster the nearer the ball is. The rate is rounded to quarters of a beat, so that
// the sound changes only if the difference is audible.
double beats_hz(double slowest_hz, double fastest_hz, double share_of_range) {
    return std::round(4.0 * (fastest_hz - (fastest_hz - slowest_hz) * share_of_range)) / 4.0;
}

bool holds(const Aabb& box_m, const Vec3& at_m) {
    return at_m.x >= box_m.min_m.x && at_m.x <= box_m.max_m.x && at_m.y >= box_m.min_m.y && at_m.y <= box_m.max_m.y &&
           at_m.z >= box_m.min_m.z && at_m.z <= box_m.max_m.z;
}

double halves(double rolls) { return std::round(2.0 * rolls) / 2.0; }

}  // namespace

Labyrinth::Labyrinth(const SessionContext& context, Bodies& bodies, Soundscape& soundscape)
    : SessionPart(context), bodies_(bodies), soundscape_(soundscape) {
    bodies_.on_hit = [this](FeatureId thing, FeatureId met, double now_s) { meet_border(thing, met, now_s); };
}

// Plays a single sound for a border, even if the ball bounces there several times.
void Labyrinth::meet_border(FeatureId thing, FeatureId met, double now_s) {
    if (!there() || thing != plan().ball || std::count(plan().borders.begin(), plan().borders.end(), met) == 0) return;
    if (now_s - std::exchange(thud_s_, now_s) > kThudAgain_s)
        context_.play_at(cues::SoundKind::Border, ball_m(), now_s);
}

void Labyrinth::enter_world(double now_s) {
    covered_.clear();
    sounds_.clear();
    soundscape_.add({});
    ball_ = plan().there() ? thing_of(plan().ball) : context_.world.scene->placed.size();
    if (!there()) return;
    start_m_ = ball_m();
    const Aabb& box = context_.world.scene->placed[ball_].model->bounds_m;
    radius_m_ = 0.5 * std::min({box.size_m().x, box.size_m().y, box.size_m().z});
    covered_.assign(plan().holes.size(), false);
    table_m_ = labyrinth_table_m(*context_.world.scene);
    begin(now_s);
    look_at_holes(now_s, false);
    sound();
}

std::string Labyrinth::opening_words() const {
    if (!there()) return {};
    return phrase("labyrinth.begin", {{"level", plan().level},
                                      {"state", state_words()},
                                      {"key", context_.keys.keys_of(Command::Use)},
                                      {"ask", context_.keys.keys_of(Command::Labyrinth)},
                                      {"again", context_.keys.keys_of(Command::PutBack)}});
}

// Returns the index of the feature among the placed things of the world, or the number of placed things if it is not
// among them.
std::size_t Labyrinth::thing_of(FeatureId feature) const {
    const std::vector<PlacedModel>& placed = context_.world.scene->placed;
    return static_cast<std::size_t>(
        std::find_if(placed.begin(), placed.end(), [&](const PlacedModel& one) { return one.feature == feature; }) -
        placed.begin());
}

Vec3 Labyrinth::at(FeatureId feature) const {
    const std::size_t thing = thing_of(feature);
    return thing < context_.world.scene->placed.size() ? context_.world.things.at(thing).position_m : Vec3(0.0);
}

Vec3 Labyrinth::ball_m() const { return context_.world.things.at(ball_).position_m; }

double Labyrinth::to_goal_m() const {
    double least_m = 1e9;
    for (const LabyrinthPlan::Place& goal : plan().goals)
        least_m = std::min(least_m, glm::length(ball_m() - goal.box_m.centre_m()));
    return least_m;
}

// Describes the offset of a place from the ball in rolls: "2 rolls north, 1.5 rolls east".
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

// Describes how far the ball can roll in each of the four directions.
std::string Labyrinth::free_words() const {
    constexpr std::array kWays{Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0), Vec3(-1.0, 0.0, 0.0)};
    constexpr std::array kSides{"labyrinth.north", "labyrinth.east", "labyrinth.south", "labyrinth.west"};
    std::string text;
    for (std::size_t i = 0; i < kWays.size(); ++i) {
        // The ray starts inside the ball, so it does not hit the ball itself.
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

// Lists what is in the corridor and where other corridors branch off, in order from the corridor's beginning, with
// distances in rolls of the ball.
std::string Labyrinth::corridor_words(const Corridor& corridor) const {
    std::vector<std::pair<double, std::string>> said;
    const double near_m = 0.5 * corridor.across_m + 2.0 * radius_m_;
    const Vec3 middle = corridor.box_m.centre_m();
    const auto lies = [&](std::string what, const Vec3& at_m) {
        const double along_m = corridor.along_m(at_m), beside_m = corridor.east ? at_m.y - middle.y : at_m.x - middle.x;
        if (along_m < -2.0 * radius_m_ || along_m > corridor.length_m + 2.0 * radius_m_ || std::abs(beside_m) > near_m)
            return;
        said.emplace_back(std::clamp(along_m, 0.0, corridor.length_m), std::move(what));
    };
    lies(body_name(context_, plan().ball), ball_m());
    for (std::size_t i = 0; i < plan().holes.size(); ++i)
        lies(phrase(covered_[i] ? "labyrinth.a_covered_hole" : "labyrinth.a_hole"), plan().holes[i].box_m.centre_m());
    for (const LabyrinthPlan::Place& goal : plan().goals) lies(phrase("labyrinth.the_goal"), goal.box_m.centre_m());
    for (const FreeBody& body : context_.world.scene->bodies)
        if (body.feature != plan().ball) lies(body_name(context_, body.feature), at(body.feature));
    constexpr std::array kTowards{"labyrinth.corridor_east", "labyrinth.corridor_north", "labyrinth.corridor_west",
                                  "labyrinth.corridor_south"};  // in the order of CorridorSide
    for (const Corridor::Branch& branch : corridor.branches)
        said.emplace_back(branch.at_m,
                          phrase(kTowards.at(static_cast<std::size_t>(branch.towards)), {{"number", branch.to + 1}}));
    std::stable_sort(said.begin(), said.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (const auto& [along_m, what] : said) {
        const double rolls = halves(along_m / roll_m());
        const char* where = rolls == 0.0                                    ? "labyrinth.at_beginning"
                            : rolls >= halves(corridor.length_m / roll_m()) ? "labyrinth.at_end"
                                                                            : "labyrinth.after";
        text += (text.empty() ? "" : ", ") + phrase(where, {{"what", what}, {"rolls", rolls}});
    }
    return text;
}

void Labyrinth::list_corridors(double now_s) {
    auto corridors = corridors_of(*context_.world.scene, ball_m(), radius_m_);
    // A ball that hits a wall may end up slightly above the floor. In that case, the search starts from the place where
    // the game began.
    if (corridors && corridors->empty()) corridors = corridors_of(*context_.world.scene, start_m_, radius_m_);
    if (!corridors) return context_.answer(corridors.error().sentence(), now_s);
    if (corridors->empty()) return context_.answer(phrase("labyrinth.no_corridors"), now_s);
    ListSpec list;
    list.title = phrase("labyrinth.corridors", {{"count", corridors->size()}});
    for (std::size_t i = 0; i < corridors->size(); ++i) {
        const Corridor& corridor = (*corridors)[i];
        list.items.push_back({phrase(corridor.east ? "labyrinth.from_west" : "labyrinth.from_south",
                                     {{"number", i + 1}, {"rolls", halves(corridor.length_m / roll_m())}}),
                              corridor_words(corridor)});
    }
    list.stays_open = true;  // The list stays open on Enter, because the person can only read it.
    list.chosen = [](std::size_t) {};
    context_.open_list(std::move(list), now_s);
}

bool Labyrinth::keeps(Command command) const {
    return there() && (command == Command::Forward || command == Command::Back || command == Command::TurnLeft ||
                       command == Command::TurnRight);
}

std::optional<Vec3> Labyrinth::camera_m() const {
    if (!there()) return std::nullopt;
    return panned_m_ ? panned_m_ : ball_m();
}

// Names what is under the camera, within half a roll of its middle.
std::string Labyrinth::under_camera_words() const {
    const Vec3 at_m = camera_m().value_or(Vec3(0.0));
    const auto near = [&](const Aabb& box) {
        const Vec3 place = glm::clamp(at_m, box.min_m, box.max_m);
        return std::hypot(place.x - at_m.x, place.y - at_m.y) < 0.25 * roll_m();
    };
    std::string text;
    const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
    for (std::size_t i = 0; i < plan().holes.size(); ++i)
        if (near(plan().holes[i].box_m)) add(phrase(covered_[i] ? "labyrinth.a_covered_hole" : "labyrinth.a_hole"));
    for (const LabyrinthPlan::Place& goal : plan().goals)
        if (near(goal.box_m)) add(phrase("labyrinth.the_goal"));
    for (const FreeBody& body : context_.world.scene->bodies)
        if (near(context_.world.solids->box_of_placed(thing_of(body.feature)))) add(body_name(context_, body.feature));
    return text;
}

// Moves the camera. It stops at the edge of the table.
void Labyrinth::pan(const Vec3& by_m, const char* edge, double now_s) {
    const Vec3 to_m = *camera_m() + by_m, there_m = glm::clamp(to_m, table_m_.min_m, table_m_.max_m);
    panned_m_ = Vec3(there_m.x, there_m.y, to_m.z);
    std::string text = phrase("labyrinth.camera", {{"off", off_words(*panned_m_)}});
    if (const std::string under = under_camera_words(); !under.empty()) text += " " + sentence_case(under) + ".";
    if (glm::length(*panned_m_ - to_m) > 1e-9) {
        context_.play_at(cues::SoundKind::Border, *panned_m_, now_s);
        text = phrase("labyrinth.edge", {{"side", edge}}) + " " + text;
    }
    context_.answer(std::move(text), now_s);
}

bool Labyrinth::act(Command command, double now_s, int times) {
    if (command != Command::Labyrinth && !there()) return false;
    switch (command) {
        case Command::Forward:
            pan(Vec3(0.0, times * roll_m(), 0.0), "north", now_s);
            return true;
        case Command::Back:
            pan(Vec3(0.0, -times * roll_m(), 0.0), "south", now_s);
            return true;
        case Command::TurnRight:
            pan(Vec3(times * roll_m(), 0.0, 0.0), "east", now_s);
            return true;
        case Command::TurnLeft:
            pan(Vec3(-times * roll_m(), 0.0, 0.0), "west", now_s);
            return true;
        case Command::Labyrinth:
            context_.answer(there() ? state_words() : phrase("labyrinth.none"), now_s);
            return true;
        case Command::Overview:
            list_corridors(now_s);
            return true;
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
    panned_m_.reset();
    over_ = hint_announced_ = false;
    nearest_m_ = to_goal_m();
    nearer_s_ = now_s;
}

// Returns true if anything except the ball covers the middle of the hole. While the ball itself is over the hole, the
// previous answer stays.
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

void Labyrinth::look_at_holes(double now_s, bool announces) {
    for (std::size_t i = 0; i < plan().holes.size(); ++i) {
        const bool is = covered(i);
        if (is == covered_[i]) continue;
        covered_[i] = is;
        if (!announces) continue;
        if (is) context_.play_at(cues::SoundKind::Knock, plan().holes[i].box_m.centre_m(), now_s);
        context_.say(phrase(is ? "labyrinth.covered" : "labyrinth.open"), cues::SpeechClass::Answer, now_s);
    }
}

// Makes open holes near the ball hum, with beats that become faster as the ball comes nearer to the edge of the hole.
// Makes goals near the ball ring, also faster the nearer the ball is.
void Labyrinth::sound() {
    std::vector<AddedSound> sounds;
    const Vec3 ball = ball_m();
    const double hums_m = kHoleHeard * 2.0 * radius_m_, rings_m = kGoalHeard * 2.0 * radius_m_;
    for (std::size_t i = 0; i < plan().holes.size(); ++i) {
        const Aabb& box = plan().holes[i].box_m;
        const Vec3 nearest = glm::clamp(ball, box.min_m, box.max_m);
        const double edge_m = std::hypot(nearest.x - ball.x, nearest.y - ball.y);
        if (covered_[i] || edge_m > hums_m) continue;
        sounds.push_back({cues::SoundKind::Hum, box.centre_m(), kLoudness,
                          beats_hz(kSlowestBeat_hz, kFastestBeat_hz, edge_m / hums_m)});
    }
    for (const LabyrinthPlan::Place& goal : plan().goals)
        if (const double away_m = glm::length(goal.box_m.centre_m() - ball); away_m <= rings_m)
            sounds.push_back({cues::SoundKind::Tolling, goal.box_m.centre_m(), kLoudness,
                              beats_hz(kSlowestBell_hz, kFastestBell_hz, away_m / rings_m)});
    if (sounds == sounds_) return;
    sounds_ = std::move(sounds);
    soundscape_.add(sounds_);
}

void Labyrinth::tick(double now_s) {
    if (!there()) return;
    if (fallen_s_ >= 0.0) {
        if (now_s - fallen_s_ < kBack_s) return;
        fallen_s_ = -1.0;
        bodies_.restart();
        nearest_m_ = 1e9;
        sound();
        return context_.answer(phrase("labyrinth.back"), now_s);
    }
    if (!bodies_.any_moving()) {
        // The hint is only for a person who has begun to roll the ball and gets no nearer to the goal.
        if (began_s_ >= 0.0 && !over_ && !hint_announced_ && now_s - nearer_s_ > kStuck_s) {
            hint_announced_ = true;
            context_.answer(
                phrase("labyrinth.stuck", {{"free", free_words()}, {"again", context_.keys.keys_of(Command::PutBack)}}),
                now_s);
        }
        return;
    }
    const Vec3 ball = ball_m();
    if (glm::length(ball - std::exchange(last_m_, ball)) > kFollowed_m) panned_m_.reset();
    if (began_s_ < 0.0 && glm::length(ball - start_m_) > kMoved_m) began_s_ = nearer_s_ = now_s;
    look_at_holes(now_s, true);
    sound();
    if (over_) return;
    for (const LabyrinthPlan::Place& hole : plan().holes)
        if (holds(hole.box_m, ball)) {
            fallen_s_ = now_s;
            bodies_.step_is_announced();
            context_.play_at(cues::SoundKind::Falls, ball, now_s);
            return context_.answer(phrase("labyrinth.fell"), now_s);
        }
    if (const double far_m = to_goal_m(); far_m < nearest_m_ - kNearer_m) {
        nearest_m_ = far_m;
        nearer_s_ = now_s;
    }
    for (const LabyrinthPlan::Place& goal : plan().goals)
        if (holds(goal.box_m, ball) && began_s_ >= 0.0) {
            over_ = true;
            bodies_.step_is_announced();
            const double took_s = now_s - began_s_;
            context_.play(cues::SoundKind::Arrived, now_s);
            return context_.answer(phrase("labyrinth.finished", {{"time", time_words(took_s)}}) + " " +
                                       best_.finish(context_.world.scene->name, took_s),
                                   now_s);
        }
}

}  // namespace handrail::core
