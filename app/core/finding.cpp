#include "app/core/finding.h"

#include <algorithm>
#include <cmath>

#include "app/core/marks.h"
#include "app/core/words.h"

namespace handrail {

Vec3 nearest_place(const Aabb& box, const Vec3& to_m) { return glm::clamp(to_m, box.min_m, box.max_m); }

void Sought::set(std::string name, const Aabb& thing_m) {
    on_ = true;
    name_ = std::move(name);
    thing_m_ = thing_m;
    last_s_ = -1e9;
}

double Beacon::interval_s(double distance_m) { return std::clamp(0.15 + 0.06 * distance_m, 0.2, 1.2); }

Beacon::Beat Beacon::tick(const Vec3& feet_m, const Listener& listener, const std::function<double(const Vec3&)>& muffled_db, bool heard, double now_s) {
    Beat beat;
    if (!on_) return beat;
    const Vec3 feet_place = nearest_place(thing_m_, feet_m);
    const Vec3 way = feet_place - feet_m;
    if (std::hypot(way.x, way.y) <= kArrived_m && std::abs(way.z) <= kStorey_m) {
        beat.arrived = true;
        on_ = false;
        return beat;
    }
    const Vec3 place = nearest_place(thing_m_, listener.ears_m);
    const Vec3 to = thing_m_.centre_m() - listener.ears_m;
    const double distance_m = glm::length(place - listener.ears_m);
    if (!heard || now_s - last_s_ < interval_s(distance_m)) return beat;
    last_s_ = now_s;
    const double off_rad = std::abs(wrap_angle(std::atan2(to.x, to.y) - listener.heading_rad));
    CueRequest sound;
    sound.kind = CueRequestKind::Play;
    sound.sound = off_rad <= kAhead_rad ? SoundKind::BeaconAhead : off_rad >= kBehind_rad ? SoundKind::BeaconBehind : SoundKind::Beacon;
    sound.time_s = now_s;
    sound.position_m = thing_m_.centre_m();
    sound.muffled_db = std::min(muffled_db(sound.position_m), kMostMuffled_db);
    beat.sound = std::move(sound);
    return beat;
}

// 80 ms at the thing, and 11 ms more for each millimetre of the hand.
double Warmer::interval_s(double felt_m) { return std::clamp(0.08 + 11.0 * felt_m, 0.08, 1.6); }

Warmer::Beat Warmer::tick(double felt_m, double found_m, bool heard, double now_s) {
    Beat beat;
    if (!on_) return beat;
    if (felt_m <= found_m) {
        on_ = false;
        beat.found = true;
        return beat;
    }
    if (!heard || now_s - last_s_ < interval_s(felt_m)) return beat;
    last_s_ = now_s;
    beat.sound = true;
    return beat;
}

void Laps::begin(const std::string& goal) {
    if (goal == goal_) return;
    goal_ = goal;
    step_ = 0;
    errors_before_.reset();
}

void Laps::finish(int errors, bool fades) {
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
        things.push_back({spoken_name(feature), feature.bounds_m, FeatureId{static_cast<std::uint32_t>(i)}, feature.kind, feature.landmark, feature.clue});
    }
    return things;
}

}  // namespace handrail
