#include "app/core/wayfinding/finding.h"

#include <algorithm>
#include <cmath>

#include "app/core/dialogue/words.h"
#include "app/core/kept/marks.h"
#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"

namespace handrail::core {

void Sought::set(std::string name, const Aabb& thing_m, FeatureId feature) {
    contract_pre(!thing_m.empty());
    on_ = true;
    name_ = std::move(name);
    thing_m_ = thing_m;
    feature_ = feature;
    last_s_ = -1e9;
}

double Beacon::interval_s(double distance_m) { return std::clamp(0.15 + 0.06 * distance_m, 0.2, 1.2); }

Beacon::Beat Beacon::tick(const Vec3& feet_m, const cues::Listener& listener,
                          const std::function<double(const Vec3&)>& muffled_db, bool heard, double now_s,
                          const std::optional<Vec3>& turning_m) {
    Beat beat;
    if (!on_) return beat;
    const Vec3 feet_place = nearest_place(thing_m_, feet_m);
    const Vec3 way = feet_place - feet_m;
    if (!turning_m && std::hypot(way.x, way.y) <= kArrived_m && std::abs(way.z) <= kAboveOrBelow_m) {
        beat.arrived = true;
        on_ = false;
        return beat;
    }
    const Vec3 place = turning_m ? *turning_m : nearest_place(thing_m_, listener.ears_m);
    const Vec3 from = turning_m ? *turning_m : thing_m_.centre_m();
    const Vec3 to = from - listener.ears_m;
    const double distance_m = glm::length(place - listener.ears_m);
    if (!heard || now_s - last_s_ < interval_s(distance_m)) return beat;
    last_s_ = now_s;
    const double off_rad = std::abs(wrap_angle(std::atan2(to.x, to.y) - listener.heading_rad));
    cues::CueRequest sound;
    sound.kind = cues::CueRequestKind::Play;
    sound.sound = off_rad <= kAhead_rad    ? cues::SoundKind::BeaconAhead
                  : off_rad >= kBehind_rad ? cues::SoundKind::BeaconBehind
                                           : cues::SoundKind::Beacon;
    sound.time_s = now_s;
    sound.position_m = from;
    sound.muffled_db = std::min(muffled_db(sound.position_m), kMostMuffled_db);
    beat.sound = std::move(sound);
    return beat;
}

// The interval is 60 ms at the thing. If the hand is more than 5 mm away, each doubling of the distance adds 18 ms.
// That is at least a ninth of the interval, so the difference is audible. The rhythm is fast, because each tick also
// conveys the direction.
double Warmer::interval_s(double felt_m) {
    return std::clamp(0.06 + 0.018 * std::log2(1.0 + felt_m / 0.005), 0.06, 0.5);
}

Warmer::Beat Warmer::tick(double felt_m, const Vec3& place_m, bool found, bool heard, double now_s) {
    Beat beat;
    if (!on_) return beat;
    if (found) {
        on_ = false;
        beat.found = true;
        return beat;
    }
    const double interval = interval_s(felt_m);
    if (!heard || now_s - last_s_ < interval) return beat;
    // The next interval begins when this beat was due, so that the rhythm stays even if the session ticks irregularly.
    last_s_ = now_s - last_s_ < 2.0 * interval ? last_s_ + interval : now_s;
    beat.sound = true;
    if (const double went_m = before_ ? glm::length(place_m - before_->place_m) : 0.0; went_m > kRests_hand_m)
        beat.nearer = std::clamp((before_->felt_m - felt_m) / went_m, -1.0, 1.0);
    before_ = Before{felt_m, place_m};
    return beat;
}

void Laps::begin(const std::string& goal) {
    if (goal == goal_) return;
    goal_ = goal;
    step_ = 0;
    errors_before_.reset();
}

void Laps::finish(int errors, bool fades) {
    contract_pre(errors >= 0);
    const bool better = errors == 0 || (errors_before_ && errors < *errors_before_);
    errors_before_ = errors;
    if (fades && better) change(-1);
}

void Laps::change(int by) { step_ = std::clamp(step_ - by, 0, 3); }

std::vector<NamedThing> named_things(const Scene& scene) {
    std::vector<NamedThing> things;
    for (std::size_t i = 0; i < scene.features.size(); ++i) {
        const Feature& feature = scene.features[i];
        if (feature.name.empty() || feature.bounds_m.empty()) continue;
        if (!is_thing(feature)) continue;
        things.push_back({spoken_name(feature), feature.bounds_m, FeatureId{static_cast<std::uint32_t>(i)},
                          feature.kind, feature.landmark, feature.clue});
    }
    return things;
}

}  // namespace handrail::core
