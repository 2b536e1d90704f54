// Tools to find a thing by ear, each a few lines of state over places and times: the beacon that calls from where the
// thing is, and "warmer", which tells the distance alone. Both are single sounds in a rhythm, so they need no loop and
// stop at once. And the help that grows less over laps. Plain state, no clock, no device; app thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/world/surroundings.h"
#include "audio-cues/plan/cue_planner.h"
#include "worlds/scene/scene.h"

namespace handrail {

// What is sought by a rhythm, and when it sounded last.
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

// One at a time. Its beat is the faster the nearer one is; straight ahead it rings, behind it is dull, and on arriving
// it ends by itself.
class Beacon : public Sought {
public:
    static constexpr double kAhead_rad = 11.25 * kPi / 180.0;   // to either side: half a notch of turning
    static constexpr double kBehind_rad = 112.5 * kPi / 180.0;  // from there on
    static constexpr double kArrived_m = 1.2;        // level, from the body to the thing; two storeys are not one place
    static constexpr double kMostMuffled_db = 12.0;  // it obeys walls and stays audible

    struct Beat {
        std::optional<CueRequest> sound;  // to be played now
        bool arrived = false;             // it has just ended
    };
    // muffled_db: what lies between ears and a place; asked only for a beat. `heard`: false while sounds are stopped.
    // turning_m: it calls from there as long as one has to go there first, and nobody arrives; none: from the thing.
    Beat tick(const Vec3& feet_m, const Listener& listener, const std::function<double(const Vec3&)>& muffled_db,
              bool heard, double now_s, const std::optional<Vec3>& turning_m = {});
    static double interval_s(double distance_m);
};

// A tick in the middle of the head that comes the faster the nearer the hand is: by felt distance, or the body's where
// there is no device. Its pitch tells how directly one came nearer since the tick before, and where one went away from
// it another sound does.
class Warmer : public Sought {
public:
    static constexpr double kFound_hand_m = 0.004;
    static constexpr double kRests_hand_m = 0.0003;  // from one tick to the next: no going

    struct Beat {
        bool sound = false;
        double nearer = 0.0;  // since the tick before, as a part of the way one went: 1 straight to it, -1 straight
                              // away, 0 who rests or goes past
        bool found = false;   // it has just ended
    };
    void set(std::string name, const Aabb& thing_m, FeatureId feature) {
        Sought::set(std::move(name), thing_m, feature);
        before_.reset();
    }
    // felt_m: hand metres from the ball to the thing, along the way where one is known; place_m: where the ball is,
    // hand metres; found: it is reached.
    Beat tick(double felt_m, const Vec3& place_m, bool found, bool heard, double now_s);
    static double interval_s(double felt_m);

private:
    struct Before {
        double felt_m = 0.0;
        Vec3 place_m{0.0};
    };
    std::optional<Before> before_;  // at the last tick
};

// How strongly one is led, lap by lap to the same goal: 100, 60, 30, 0 % as errors fall. It never grows by itself.
class Laps {
public:
    static constexpr double kStrengths[] = {1.0, 0.6, 0.3, 0.0};

    // Another goal begins at full help; the same one goes on where it was.
    void begin(const std::string& goal);
    double strength() const { return kStrengths[step_]; }
    // A lap that came to its end with so many errors. Fewer than in the lap before, or none at all: less help next
    // time.
    void finish(int errors, bool fades);
    // By the person's own wish: 1 more, -1 less.
    void change(int by);

private:
    std::string goal_;
    int step_ = 0;
    std::optional<int> errors_before_;
};

// Everything with a name that one may want to find: objects, doors, landmarks and the like, each with its box. Of
// several with one name each is there.
struct NamedThing {
    std::string name;
    Aabb bounds_m;
    FeatureId feature = kNoFeature;
    FeatureKind kind = FeatureKind::Object;
    bool landmark = false, clue = false;
};
std::vector<NamedThing> named_things(const Scene& scene);

}  // namespace handrail
