// Tools to find a thing by ear, each with a small state. The beacon calls from the place of the thing; "warmer" conveys
// only the distance. Both are single sounds in a rhythm, so they need no loop and stop at once. Also the guidance that
// decreases over laps. Plain state, no clock, no device; app thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/world/surroundings.h"
#include "audio-cues/plan/cue_planner.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// The thing that is searched for with a rhythm of sounds, and when it last sounded.
class Sought {
public:
    void set(std::string name, const Aabb& thing_m, FeatureId feature);
    void clear() { on_ = false; }
    bool on() const { return on_; }
    const std::string& name() const { return name_; }
    const Aabb& thing_m() const { return thing_m_; }
    FeatureId feature() const { return feature_; }

protected:
    bool on_ = false;
    std::string name_;
    Aabb thing_m_;
    FeatureId feature_ = kNoFeature;
    double last_s_ = -1e9;
};

// Only one at a time. The beat is faster the nearer the thing is. The sound rings straight ahead and is dull behind. On
// arrival the beacon ends automatically.
class Beacon : public Sought {
public:
    static constexpr double kAhead_rad = 11.25 * kPi / 180.0;   // to either side: half a notch of turning
    static constexpr double kBehind_rad = 112.5 * kPi / 180.0;  // larger angles count as behind
    static constexpr double kArrived_m = 1.2;        // level, from the walker to the thing, on the same storey
    static constexpr double kMostMuffled_db = 12.0;  // walls muffle it, but it stays audible

    struct Beat {
        std::optional<cues::CueRequest> sound;  // to be played now
        bool arrived = false;                   // it has just ended
    };
    // muffled_db: muffling between the ears and a place; called only for a beat. `heard`: false while sounds are
    // stopped. turning_m: it calls from there as long as the person must go there first, and nobody arrives; no value:
    // it calls from the thing.
    Beat tick(const Vec3& feet_m, const cues::Listener& listener, const std::function<double(const Vec3&)>& muffled_db,
              bool heard, double now_s, const std::optional<Vec3>& turning_m = {});
    static double interval_s(double distance_m);
};

// A tick in the middle of the head, faster the nearer the hand is at its scale, or the walker if there is no device.
// Its pitch shows how directly the hand has approached since the previous tick; moving away has a different sound.
class Warmer : public Sought {
public:
    static constexpr double kFound_hand_m = 0.004;
    static constexpr double kRests_hand_m = 0.0003;  // from one tick to the next; less counts as rest

    struct Beat {
        bool sound = false;
        // Approach since the previous tick, as a share of the distance moved: 1 straight to it, -1 straight away, 0 at
        // rest or sideways.
        double nearer = 0.0;
        bool found = false;  // it has just ended
    };
    void set(std::string name, const Aabb& thing_m, FeatureId feature) {
        Sought::set(std::move(name), thing_m, feature);
        before_.reset();
    }
    // felt_m: hand metres from the proxy to the thing, along the route if one is known. place_m: place of the proxy,
    // hand metres. found: it is reached.
    Beat tick(double felt_m, const Vec3& place_m, bool found, bool heard, double now_s);
    static double interval_s(double felt_m);

private:
    struct Before {
        double felt_m = 0.0;
        Vec3 place_m{0.0};
    };
    std::optional<Before> before_;  // at the last tick
};

// Strength of guidance, lap by lap to the same goal: 100, 60, 30, 0 % as errors decrease. It never increases
// automatically.
class Laps {
public:
    static constexpr double kStrengths[] = {1.0, 0.6, 0.3, 0.0};

    // Another goal begins with full guidance; the same one continues at its present strength.
    void begin(const std::string& goal);
    double strength() const { return kStrengths[step_]; }
    // A lap ended with this many errors. If there were none, or fewer than in the previous lap, there is less guidance
    // next time.
    void finish(int errors, bool fades);
    // The person changes it: 1 more, -1 less.
    void change(int by);

private:
    std::string goal_;
    int step_ = 0;
    std::optional<int> errors_before_;
};

// Everything with a name that a person may want to find, such as objects, doors and landmarks, each with its box.
// Things with the same name are all listed.
struct NamedThing {
    std::string name;
    Aabb bounds_m;
    FeatureId feature = kNoFeature;
    FeatureKind kind = FeatureKind::Object;
    bool landmark = false, clue = false;
};
std::vector<NamedThing> named_things(const Scene& scene);

}  // namespace handrail::core
