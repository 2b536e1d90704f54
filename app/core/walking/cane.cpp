#include "app/core/walking/cane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "audio-cues/plan/cue_planner.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

using settings::CaneTechnique;

constexpr std::array kTechniques{"constant-contact", "two-point", "shoreline"};
constexpr double kSweepRate_rad_per_s = 1.6;  // rate of a sweep by key
constexpr double kWidest_rad = 1.3;           // farthest to the side that the person can point the cane
constexpr double kNotch_rad = 0.26;           // a further tap at the end of the arc goes on by this much
constexpr double kShore_rad = 1.0;            // how far to the side the cane searches for the shoreline
constexpr double kByPerson_s = 1.5;           // the cane sweeps in step again this long after the person's last sweep
constexpr double kHandMoves_rad = 0.005, kHandAway_m = 0.05;
constexpr double kScrape_m = 0.12;  // distance of the tip along the ground between two of its sounds
constexpr double kScrapeLoudness = 0.2, kTapLoudness = 0.5, kObstacleLoudness = 0.7;
constexpr double kTellAgain_s = 20.0, kSameEdge_m = 1.5;
constexpr double kStepFelt_m = 0.08, kOffStairs_m = 0.6;
constexpr double kMostPerTick_m = 0.3;  // a walker that was placed elsewhere has not walked all the way

}  // namespace

void Cane::enter_world() {
    met_ = {};
    shore_ = {};
    announced_.clear();
    goal_rad_.reset();
    held_ = {};
    feet_m_ = avatar_.feet_m();
    since_step_m_ = 1e9;
}

bool Cane::act(Command command, double now_s) {
    const auto technique = [&] {
        return phrase("setting_choice.cane.technique." +
                      std::string(kTechniques.at(static_cast<std::size_t>(context_.settings.cane.technique))));
    };
    switch (command) {
        case Command::Cane:
            avatar_.cane_out = !avatar_.cane_out;
            enter_world();
            bearing_rad_ = 0.0;
            context_.answer(avatar_.cane_out ? phrase("cane.out", {{"technique", technique()}}) : phrase("cane.away"),
                            now_s);
            return true;
        case Command::CaneTechnique: {
            const auto next = (static_cast<std::size_t>(context_.settings.cane.technique) + 1) % kTechniques.size();
            context_.set("cane.technique", kTechniques.at(next), now_s);
            shore_ = {};
            context_.answer(sentence_case(technique()), now_s);
            return true;
        }
        case Command::CaneLeft:
        case Command::CaneRight: {
            if (!avatar_.cane_out) {
                context_.play(cues::SoundKind::Denied, now_s);
                context_.answer(phrase("cane.not_out", {{"key", context_.keys.keys_of(Command::Cane)}}), now_s);
                return true;
            }
            if (context_.hands.tuning.panic) {
                const std::string key = context_.keys.keys_of(Command::ToggleForces);
                context_.answer(phrase("session.stopped_sounds", {{"key", key}}), now_s);
                return true;
            }
            const double side = command == Command::CaneRight ? 1.0 : -1.0;
            const double end_rad = std::max(arc_rad(), side * bearing_rad_ + kNotch_rad);
            goal_rad_ = side * std::min(side * bearing_rad_ < arc_rad() - 0.01 ? arc_rad() : end_rad, kWidest_rad);
            return true;
        }
        default:
            return false;
    }
}

Steering Cane::take(const Steering& steering) {
    held_.stick = held_.swing_rad_per_s = 0.0;
    if (!avatar_.cane_out || !std::isfinite(steering.turn_right)) return steering;
    held_.stick = std::clamp(steering.turn_right, -1.0, 1.0);
    if (std::isfinite(steering.cane_right_rad_per_s)) held_.swing_rad_per_s = steering.cane_right_rad_per_s;
    return {steering.ahead, steering.right, 0.0};
}

// Returns half of the arc that the tip sweeps: as wide as the body and a little more on each side.
double Cane::arc_rad() const {
    const double aside_m = avatar_.walker->size().radius_m + kPastBody_m;
    return std::asin(std::min(1.0, aside_m / cane_reach_m(context_.settings.cane.length_m)));
}

void Cane::tick(double now_s, double dt_s) {
    if (!avatar_.cane_out) return;
    const Vec3 moved = avatar_.feet_m() - std::exchange(feet_m_, avatar_.feet_m());
    const double walked_m = std::min(std::hypot(moved.x, moved.y), kMostPerTick_m);
    since_step_m_ = std::abs(moved.z) >= kStepFelt_m ? 0.0 : since_step_m_ + walked_m;
    if (!avatar_.walker->state().on_ground || context_.hands.tuning.panic) {
        goal_rad_.reset();  // otherwise the terminal waits for the end of the sweep
        return;
    }
    if (const bool swept = goal_rad_.has_value(); sweep_by_person(now_s, dt_s)) {
        put(true, now_s);
        // A sweep that met nothing gets an answer too.
        const std::string& material = context_.world.scene->material(met_.tip.material).name;
        if (swept && !goal_rad_ && met_.tip.meets == CaneMeets::Ground && !material.empty())
            context_.say(sentence_case(spoken_material(material)), cues::SpeechClass::Contact, now_s);
        return;
    }
    if (walked_m > 1e-6) sweep_in_step(walked_m, now_s);
}

// Points the cane as keys, stick or hand request. Returns false if the cane is left to sweep in step.
bool Cane::sweep_by_person(double now_s, double dt_s) {
    const double most = kSweepRate_rad_per_s * dt_s;
    bool moves = false;
    if (const double keys = keys_.sign(Command::CaneRight, Command::CaneLeft); goal_rad_ || keys != 0.0) {
        const double to_rad = goal_rad_.value_or(keys * kWidest_rad);
        const double left_rad = to_rad - bearing_rad_;
        bearing_rad_ += std::clamp(left_rad, -most, most);
        if (std::abs(left_rad) <= most) goal_rad_.reset();
        moves = true;
    } else if (held_.stick != 0.0) {
        bearing_rad_ = held_.stick * kWidest_rad;
        moves = true;
    } else if (held_.swing_rad_per_s != 0.0) {
        bearing_rad_ = std::clamp(bearing_rad_ + held_.swing_rad_per_s * dt_s, -kWidest_rad, kWidest_rad);
        moves = true;
    }
    const Vec3 to_hand = context_.hands.tool.proxy_m - avatar_.feet_m();
    const bool hand = context_.hands.known() && std::hypot(to_hand.x, to_hand.y) > kHandAway_m;
    std::optional<double> hand_rad;
    if (hand) hand_rad = wrap_angle(std::atan2(to_hand.x, to_hand.y) - avatar_.heading_rad);
    const std::optional<double> before_rad = std::exchange(held_.hand_rad, hand_rad);
    if (!moves && hand_rad && before_rad && std::abs(wrap_angle(*hand_rad - *before_rad)) > kHandMoves_rad) {
        bearing_rad_ = std::clamp(*hand_rad, -kWidest_rad, kWidest_rad);
        moves = true;
    }
    if (moves) held_.until_s = now_s + kByPerson_s;
    return now_s < held_.until_s;
}

// Sweeps the cane across in the time of one step, so that the tip clears the place of the next foot.
void Cane::sweep_in_step(double walked_m, double now_s) {
    const CaneTechnique technique = context_.settings.cane.technique;
    const bool shoreline = technique == CaneTechnique::Shoreline;
    // The cane reaches out to the side of the shoreline, and to both sides until there is one.
    const double arc = arc_rad(), right = shoreline && shore_.side >= 0.0 ? kShore_rad : arc,
                 left = shoreline && shore_.side <= 0.0 ? kShore_rad : arc;
    bearing_rad_ += side_ * (left + right) * walked_m / context_.settings.walk.step_length_m;
    const bool at_end = bearing_rad_ >= right || bearing_rad_ <= -left;
    if (at_end) bearing_rad_ = std::clamp(bearing_rad_, -left, right);
    put(technique != CaneTechnique::TwoPoint || at_end, now_s);
    const bool at_shore =
        shoreline && (shore_.side == 0.0 || shore_.side == side_) && met_.known && met_.tip.meets != CaneMeets::Ground;
    if (at_shore || (at_end && shoreline && shore_.side == side_)) turn_at_shore(at_shore, now_s);
    if (at_end || at_shore) side_ = bearing_rad_ >= 0.5 * (right - left) ? -1.0 : 1.0;
}

// Handles the end of a sweep towards the shoreline, which the tip has met or not.
void Cane::turn_at_shore(bool met_shore, double now_s) {
    if (met_shore) shore_.side = side_;
    else if (shore_.met)
        context_.say(phrase("cane.shore_ends", {{"side", side_ < 0.0 ? "left" : "right"}}), cues::SpeechClass::Contact,
                     now_s);
    shore_.met = met_shore;
}

// Finds what the tip meets, and lets the person hear it.
void Cane::put(bool touches, double now_s) {
    const GroundRules rules = ground_rules(*context_.world.scene, avatar_.walker->size());
    const CaneTip tip = put_cane(*context_.world.solids, avatar_.feet_m(), avatar_.heading_rad + bearing_rad_,
                                 context_.settings.cane.length_m, rules, !touches);
    const CaneTip was = std::exchange(met_.tip, tip);
    const bool same = std::exchange(met_.known, true) && was.meets == tip.meets &&
                      (tip.meets != CaneMeets::Obstacle || was.feature == tip.feature);
    if (!same) announce(tip, now_s);
    if (tip.meets == CaneMeets::Drop || (!touches && tip.meets == CaneMeets::Ground)) return;
    const bool taps = tip.meets == CaneMeets::Obstacle || tip.meets == CaneMeets::Higher;
    const bool two_point = context_.settings.cane.technique == CaneTechnique::TwoPoint && touches;
    if ((taps && same) || (!taps && !two_point && glm::length(tip.place_m - met_.scraped_m) < kScrape_m)) return;
    met_.scraped_m = tip.place_m;
    cues::CueRequest sound = sound_at(cues::SoundKind::Contact, tip.place_m, now_s);
    sound.material = context_.world.scene->material(tip.material).sound;
    sound.loudness = taps ? kObstacleLoudness : two_point ? kTapLoudness : kScrapeLoudness;
    context_.cues.cue(std::move(sound));
}

void Cane::announce(const CaneTip& tip, double now_s) {
    // On stairs, every step is higher or lower than the feet, so only drops count.
    const bool on_stairs = since_step_m_ < kOffStairs_m;
    switch (tip.meets) {
        case CaneMeets::Ground:
            return;
        case CaneMeets::Higher:
        case CaneMeets::Lower:
            if (!on_stairs && announce_once(tip.place_m, now_s))
                context_.warn(phrase(tip.meets == CaneMeets::Higher ? "cane.step_up" : "cane.step_down"), now_s);
            return;
        case CaneMeets::Drop:
            context_.play_at(cues::SoundKind::DropNear, tip.place_m, now_s);
            if (announce_once(tip.place_m, now_s))
                context_.warn(tip.depth_m ? phrase("cane.drop", {{"metres", *tip.depth_m}}) : phrase("cane.very_deep"),
                              now_s);
            return;
        case CaneMeets::Obstacle:
            if (const std::string name = cues::describe_feature(*context_.world.scene, tip.feature,
                                                                std::max(1, context_.settings.speech.verbosity));
                !name.empty())
                context_.say(name, cues::SpeechClass::Contact, now_s);
            return;
    }
}

// Returns true and notes the place if nothing was announced near it in the last kTellAgain_s.
bool Cane::announce_once(const Vec3& place_m, double now_s) {
    std::erase_if(announced_, [&](const Announced& one) { return now_s - one.time_s > kTellAgain_s; });
    const bool known = std::any_of(announced_.begin(), announced_.end(), [&](const Announced& one) {
        return glm::length(one.place_m - place_m) < kSameEdge_m;
    });
    if (!known) announced_.push_back({place_m, now_s});
    return !known;
}

}  // namespace handrail::core
