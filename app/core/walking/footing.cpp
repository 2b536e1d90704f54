#include "app/core/walking/footing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostAnnounced = 16;
constexpr double kLookEvery_s = 0.25, kLookEvery_m = 0.15, kLookEvery_rad = 0.1;
constexpr double kEdgeConfirm_s = 2.0;
constexpr double kAnnounceAgain_s = 30.0, kSamePlace_m = 1.5;
constexpr double kDoorNear_m = 3.0;
constexpr double kStill_s = 1.5;  // the beat before an edge stops this long after the last movement
constexpr double kRiser_m = 0.08;
constexpr double kLanding_m = 0.6;  // a landing begins after this distance on level ground behind the last riser
constexpr double kRamp = 0.03, kRampSure_m = 0.4;

}  // namespace

void Footing::enter_world() {
    announced_.clear();
    set_down();
}

void Footing::set_down() {
    looked_ = {};
    edge_ = {};
    underfoot_ = {};
}

void Footing::notice(Command command, double now_s) {
    switch (command) {
        case Command::Forward:
        case Command::Back:
        case Command::SideLeft:
        case Command::SideRight:
        case Command::TrailLeft:
        case Command::TrailRight:
        case Command::TrailOn:
        case Command::TrailBack:
        case Command::Retrace:
            if (edge_.held && now_s - edge_.at_s <= kEdgeConfirm_s) edge_.confirmed = true;
            edge_.held = false;
            break;
        default:
            break;
    }
}

bool Footing::held_at_edge(const WalkerMotion& before, Paces& paces, double now_s) {
    if (!context_.settings.walk.stop_at_drops || !before.on_ground) return false;
    const Vec3 moved = avatar_.feet_m() - before.feet_m;
    if (moved.x * moved.x + moved.y * moved.y < 1e-12) return false;
    const GroundRules rules = ground_rules(*context_.world.scene, avatar_.walker->size());
    const auto drop = over_drop(*context_.world.solids, avatar_.feet_m(), std::atan2(moved.x, moved.y), rules);
    if (!drop) {
        if (edge_.confirmed && now_s - edge_.at_s > kEdgeConfirm_s + 1.0) edge_.confirmed = false;
        return false;
    }
    // If an edge has no depth, there is no floor below it, so nobody goes over it.
    if (edge_.confirmed && drop->depth_m) return false;
    avatar_.walker->resume(before);
    if (std::exchange(edge_.held, true)) return true;
    edge_.at_s = now_s;
    context_.play(cues::SoundKind::Denied, now_s);
    std::string steps = paces.take(context_);
    steps = steps.empty() || !announces_steps(context_) ? std::string() : steps + ". ";
    context_.warn(steps + (drop->depth_m ? phrase("walking.edge", {{"metres", *drop->depth_m}})
                                         : phrase("walking.edge_very_deep")),
                  now_s);
    return true;
}

// Returns true and notes the place if nothing was announced there in the last kAnnounceAgain_s.
bool Footing::announce_place_once(const Vec3& place_m, bool drop, double now_s) {
    std::erase_if(announced_, [&](const Announced& announced) { return now_s - announced.time_s > kAnnounceAgain_s; });
    for (Announced& announced : announced_)
        if (announced.drop == drop && glm::length(announced.place_m - place_m) < kSamePlace_m) {
            // The time starts again, so that the announcement is not repeated while the person stays at this place.
            announced.time_s = now_s;
            return false;
        }
    if (announced_.size() == kMostAnnounced) announced_.erase(announced_.begin());
    announced_.push_back({place_m, now_s, drop});
    return true;
}

void Footing::tick(const Vec3& before_m, const WalkResult& walked, double now_s) {
    const Vec3 feet = avatar_.feet_m();
    if (walked.walked_m > 1e-6 || avatar_.heading_rad != looked_.heading_rad) looked_.moved_s = now_s;
    if (walked.landed) edge_.confirmed = false;
    announce_underfoot(feet - before_m, walked, now_s);
    const bool turned = std::abs(wrap_angle(avatar_.heading_rad - looked_.heading_rad)) > kLookEvery_rad;
    const bool went = glm::length(feet - looked_.from_m) > kLookEvery_m;
    // During a turn, the walker faces some ground only for a moment. That ground is not announced as ahead.
    const bool turning = avatar_.heading_rad != avatar_.heading_goal_rad;
    if (!turning && (turned || went) && now_s - looked_.at_s >= (turned ? 0.1 : kLookEvery_s * 0.5)) {
        looked_.ahead =
            ground_ahead(*context_.world.solids, feet, avatar_.heading_rad,
                         ground_rules(*context_.world.scene, avatar_.walker->size()), kStairsCallout_m + 0.3);
        looked_.from_m = feet;
        looked_.heading_rad = avatar_.heading_rad;
        looked_.at_s = now_s;
        if (!avatar_.cane_out) announce_ahead(now_s);
    }
    beat_ahead(now_s);
}

// Announces risers, landings and ramps under the walker.
void Footing::announce_underfoot(const Vec3& moved_m, const WalkResult& walked, double now_s) {
    if (std::abs(moved_m.z) >= kRiser_m && !walked.landed) {
        const int sign = moved_m.z > 0.0 ? 1 : -1;
        underfoot_.risers = underfoot_.risers * sign >= 0 ? underfoot_.risers + sign : sign;
        underfoot_.since_riser_m = 0.0;
    } else {
        underfoot_.since_riser_m += walked.walked_m;
    }
    if (underfoot_.risers != 0 && underfoot_.since_riser_m > kLanding_m) {
        const int risers = std::exchange(underfoot_.risers, 0);
        if (std::abs(risers) >= 3 && context_.settings.walk.callouts)
            context_.warn(
                phrase(risers > 0 ? "walking.landing" : "walking.foot_of_stairs", {{"steps", std::abs(risers)}}),
                now_s);
    }
    if (walked.walked_m > 1e-6 && underfoot_.risers == 0) {
        const double slope = ground_slope(*context_.world.solids, avatar_.feet_m(), std::atan2(moved_m.x, moved_m.y));
        underfoot_.step_pitch = std::exp2(2.0 * std::clamp(slope, -0.5, 0.5));
        const int sign = slope > kRamp ? 1 : slope < -kRamp ? -1 : 0;
        underfoot_.ramp_m =
            sign == 0 || underfoot_.ramp_m * sign < 0.0 ? 0.0 : underfoot_.ramp_m + sign * walked.walked_m;
        if (std::abs(underfoot_.ramp_m) >= kRampSure_m && underfoot_.announced_ramp != sign) {
            underfoot_.announced_ramp = sign;
            if (context_.settings.walk.callouts)
                context_.say(phrase(sign > 0 ? "walking.ramp_up" : "walking.ramp_down"), cues::SpeechClass::Contact,
                             now_s);
        }
        if (sign == 0) underfoot_.announced_ramp = 0;
    }
}

void Footing::announce_ahead(double now_s) {
    const GroundAhead& ahead = looked_.ahead;
    if (ahead.stairs && ahead.stairs->distance_m <= kStairsCallout_m && underfoot_.risers == 0 &&
        announce_place_once(ahead.stairs->place_m, false, now_s)) {
        const bool up = ahead.stairs->up;
        context_.cues.cue(
            sound_at(up ? cues::SoundKind::StairsUp : cues::SoundKind::StairsDown, ahead.stairs->place_m, now_s));
        if (context_.settings.walk.callouts) {
            const std::string distance = distance_words(ahead.stairs->distance_m, distances(context_));
            context_.warn(ahead.stairs->whole ? phrase(up ? "walking.stairs_up" : "walking.stairs_down",
                                                       {{"steps", ahead.stairs->risers}, {"distance", distance}})
                                              : phrase(up ? "walking.stairs_up_on" : "walking.stairs_down_on",
                                                       {{"distance", distance}}),
                          now_s);
        }
    }
    if (ahead.drop && ahead.drop->distance_m <= kDropWarning_m && context_.settings.walk.callouts &&
        announce_place_once(ahead.drop->place_m, true, now_s))
        context_.warn(
            phrase("walking.drop", {{"distance", distance_words(ahead.drop->distance_m, distances(context_))}}), now_s);
}

// Plays a beat before an edge, and a knock from a door that the walker faces. With the cane out, the beat is left out,
// because the cane finds the edge. Nothing plays while the person stands still.
void Footing::beat_ahead(double now_s) {
    if (now_s - looked_.moved_s > kStill_s) return;
    if (looked_.ahead.drop && !avatar_.cane_out) {
        const Vec3 place = looked_.ahead.drop->place_m;
        const double distance = glm::dot(place - avatar_.feet_m(), forward_of_heading(avatar_.heading_rad));
        if (distance > -0.3 && distance <= kDropWarning_m && now_s - looked_.beat_s >= drop_beat_s(distance)) {
            looked_.beat_s = now_s;
            context_.cues.cue(sound_at(cues::SoundKind::DropNear, place, now_s));
        }
    }
    if (now_s - looked_.door_s < 0.25) return;
    const auto seen = look(*context_.world.solids, avatar_.feet_m(), kWaist_m, avatar_.heading_rad, kDoorNear_m);
    if (!seen || !seen->feature || context_.world.scene->features[seen->feature.value].kind != FeatureKind::Door)
        return;
    if (now_s - looked_.door_s < 0.3 + 0.4 * seen->distance_m) return;
    looked_.door_s = now_s;
    context_.cues.cue(sound_at(cues::SoundKind::DoorNear, seen->point_m, now_s));
}

}  // namespace handrail::core
