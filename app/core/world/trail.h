// Trailing: going along a wall with one side to it, round its corners and past its openings, as people do with the back
// of a hand. Plain state and one tick that says which way to go; whoever moves the body obeys and tells what happened.
// App thread; world metres.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail {

enum class TrailSide : std::uint8_t { Left, Right };

struct TrailEvent {
    enum class Kind : std::uint8_t {
        Meets,    // another thing lies at the side now, or ahead
        Corner,   // another wall than the last, in another direction
        Opening,  // the wall is interrupted and goes on behind
        Ends,     // the wall is lost
    } kind = Kind::Meets;
    FeatureId feature = kNoFeature;  // Meets, Corner: what lies at the side now. Opening: what lies in it, if anything
    Vec3 place_m{0.0};
    double width_m = 0.0;  // of an opening
};

// Where the body shall go now.
struct TrailWay {
    Vec3 wish_m_per_s{0.0};
    double heading_rad = 0.0;  // to face; wait for it where it is far off
};

class Trail {
public:
    // Looks for a wall: at that side within arm's reach, else the nearest one within 4 m. False: there is none.
    bool start(const BodyWorld& world, const Vec3& feet_m, double heading_rad, const BodySize& body, TrailSide side);
    bool active() const { return active_; }
    void stop() { active_ = false; }
    TrailSide side() const { return side_; }
    // The same wall the other way, with the other side to it.
    void turn_round();
    // Called while the body stands and shall go on. `facing_rad`: where it faces by now. Events are added.
    TrailWay tick(const BodyWorld& world, const Vec3& feet_m, double facing_rad, const BodySize& body,
                  double speed_m_per_s, double dt_s, std::vector<TrailEvent>& events);
    // What the side goes along now, for tests and for what is learnt: level, out of the wall.
    const Vec3& wall_normal() const { return normal_; }
    bool touching() const { return touching_; }  // the side is at the wall
    FeatureId feature() const { return feature_; }
    // Which way it goes, with the wall at its side; meaningful while it is active.
    double heading_rad() const;
    // To the wall where it was found on starting: how far the body's side was from it, and in which direction.
    double wall_m() const { return wall_m_; }
    double wall_bearing_rad() const { return wall_bearing_rad_; }

    static constexpr double kGap_m = 0.03;           // between body and wall
    static constexpr double kWidestOpening_m = 2.4;  // wider ones are walked into

private:
    Vec3 along() const;
    void name(const BodyWorld& world, const Vec3& feet_m, const BodySize& body, std::vector<TrailEvent>& events);

    bool active_ = false;
    TrailSide side_ = TrailSide::Left;
    Vec3 normal_{0.0};  // out of the wall
    double wall_m_ = 0.0, wall_bearing_rad_ = 0.0;
    bool near_ = false;  // the wall has been reached once
    bool touching_ = false;
    double bridge_m_ = 0.0;           // still to go straight past an opening
    double round_m_ = 0.0;            // still to go round an outer corner before the wall counts as lost
    FeatureId feature_ = kNoFeature;  // named last
    FeatureId wall_ = kNoFeature;     // the last wall, and its direction: for corners
    Vec3 wall_normal_{0.0};
};

}  // namespace handrail
