// Provides the tools to find a thing by ear, each with a small state. The beacon sounds from the place of the thing,
// and "warmer" conveys only the distance. Both consist of single sounds in a rhythm, so they need no loop and stop at
// once. Laps controls the amount of guidance, which decreases from lap to lap. Plain state without clock or device, for
// the app thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/world/surroundings.h"
#include "audio-cues/plan/cue_planner.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// The thing that the person searches for by a rhythm of sounds, and the time of the last sound.
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

// Sounds from the place of one thing at a time. The beat becomes faster as the person comes nearer. The sound is bright
// straight ahead and dull behind. The beacon ends when the person arrives.
class Beacon : public Sought {
public:
    // largest angle to either side at which a thing is ahead: half a notch of turning
    static constexpr double kAhead_rad = 11.25 * kPi / 180.0;
    static constexpr double kBehind_rad = 112.5 * kPi / 180.0;  // at angles larger than this, a thing is behind
    // The person has arrived at this horizontal distance from the walker to the thing, if both are on the same storey.
    static constexpr double kArrived_m = 1.2;
    static constexpr double kMostMuffled_db = 12.0;  // most muffling by walls, so that the beacon stays audible

    struct Beat {
        std::optional<cues::CueRequest> sound;  // sound to play now, if any
        bool arrived = false;                   // true: the person has arrived, and the beacon has ended
    };
    // `muffled_db` returns the muffling between the ears and a place. It is called only for a beat. `heard` is false
    // while all sounds are stopped. If the person must first go to another place, `turning_m` is that place. The beacon
    // sounds from there, and the person cannot arrive meanwhile. If `turning_m` has no value, the beacon sounds from
    // the thing.
    Beat tick(const Vec3& feet_m, const cues::Listener& listener, const std::function<double(const Vec3&)>& muffled_db,
              bool heard, double now_s, const std::optional<Vec3>& turning_m = {});
    static double interval_s(double distance_m);
};

// A sound in the middle of the head that ticks faster as the hand comes nearer to the thing, at the scale of the hand.
// If there is no device, the distance of the walker is used. The pitch shows how directly the hand has approached since
// the previous tick. Moving away has a different sound.
class Warmer : public Sought {
public:
    static constexpr double kFound_hand_m = 0.004;
    // If the hand moves less than this between two ticks, it is at rest.
    static constexpr double kRests_hand_m = 0.0003;

    struct Beat {
        bool sound = false;
        // Approach since the previous tick, as a share of the distance moved. 1: straight towards the thing; -1:
        // straight away; 0: at rest or sideways.
        double nearer = 0.0;
        bool found = false;  // true: the thing was found, and the sound has ended
    };
    void set(std::string name, const Aabb& thing_m, FeatureId feature) {
        Sought::set(std::move(name), thing_m, feature);
        before_.reset();
    }
    // `felt_m` is the distance from the proxy to the thing in hand metres, along the route if a route is known.
    // `place_m` is the position of the proxy in hand metres. `found` is true if the hand has reached the thing. `heard`
    // is false while all sounds are stopped.
    Beat tick(double felt_m, const Vec3& place_m, bool found, bool heard, double now_s);
    static double interval_s(double felt_m);

private:
    struct Before {
        double felt_m = 0.0;
        Vec3 place_m{0.0};
    };
    std::optional<Before> before_;  // state at the last tick
};

// Controls the amount of guidance in successive laps to the same goal: 100, 60, 30 and 0 %. It decreases when the
// person makes fewer errors, and it never increases automatically.
class Laps {
public:
    static constexpr double kStrengths[] = {1.0, 0.6, 0.3, 0.0};

    // Begins a lap. A different goal starts with full guidance. The same goal continues with its present amount.
    void begin(const std::string& goal);
    double strength() const { return kStrengths[step_]; }
    // Ends a lap with this number of errors. If `fades` is set and there were no errors, or fewer than in the previous
    // lap, the next lap has less guidance.
    void finish(int errors, bool fades);
    // Changes the amount at the person's request: 1 is more, -1 is less.
    void change(int by);

private:
    std::string goal_;
    int step_ = 0;
    std::optional<int> errors_before_;
};

// A thing with a name that a person may want to find, such as an object, a door or a landmark, with its bounding box.
// If several things have the same name, all of them are listed.
struct NamedThing {
    std::string name;
    Aabb bounds_m;
    FeatureId feature = kNoFeature;
    FeatureKind kind = FeatureKind::Object;
    bool landmark = false, clue = false;
};
std::vector<NamedThing> named_things(const Scene& scene);

}  // namespace handrail::core
