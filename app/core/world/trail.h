// Trailing: following a wall with one side to it, round its corners and past its openings, as people do with the back
// of a hand. Plain state and one tick that returns the direction; the caller moves the walker and announces events. App
// thread; world metres.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail::core {

enum class TrailSide : std::uint8_t { Left, Right };

struct TrailEvent {
    enum class Kind : std::uint8_t {
        Meets,    // another thing is now at the side, or ahead
        Corner,   // another wall than before, in another direction
        Opening,  // the wall is interrupted and continues behind
        Ends,     // the wall is lost
    } kind = Kind::Meets;
    FeatureId feature = kNoFeature;  // Meets, Corner: what is now at the side. Opening: what is in it, if anything.
    Vec3 place_m{0.0};
    double width_m = 0.0;  // of an opening
};

// Where the walker should go now.
struct TrailWay {
    Vec3 wish_m_per_s{0.0};
    double heading_rad = 0.0;  // to face; if it is far off, wait for the turn
};

class Trail {
public:
    // Searches for a wall: at that side within arm's reach, otherwise the nearest one within 4 m. Returns false if
    // there is none.
    bool start(const WalkerWorld& world, const Vec3& feet_m, double heading_rad, const WalkerSize& body,
               TrailSide side);
    bool active() const { return active_; }
    void stop() { active_ = false; }
    TrailSide side() const { return side_; }
    // Follows the same wall in the opposite direction, with the other side to it.
    void turn_round();
    // Call it while the walker is on the ground and should continue. `facing_rad`: its present direction. Adds to
    // `events`.
    TrailWay tick(const WalkerWorld& world, const Vec3& feet_m, double facing_rad, const WalkerSize& body,
                  double speed_m_per_s, double dt_s, std::vector<TrailEvent>& events);
    // What the side follows now, for tests and for learning: level, out of the wall.
    const Vec3& wall_normal() const { return normal_; }
    bool touching() const { return touching_; }  // the side is at the wall
    FeatureId feature() const { return feature_; }
    // The direction of movement along the wall; valid while active.
    double heading_rad() const;
    // At the start: the distance of the wall from the walker's side, and its direction.
    double wall_m() const { return wall_m_; }
    double wall_bearing_rad() const { return wall_bearing_rad_; }

    static constexpr double kGap_m = 0.03;           // between walker and wall
    static constexpr double kWidestOpening_m = 2.4;  // wider ones are entered

private:
    Vec3 along() const;
    void name(const WalkerWorld& world, const Vec3& feet_m, const WalkerSize& body, std::vector<TrailEvent>& events);

    bool active_ = false;
    TrailSide side_ = TrailSide::Left;
    Vec3 normal_{0.0};  // out of the wall
    double wall_m_ = 0.0, wall_bearing_rad_ = 0.0;
    bool near_ = false;  // the wall has been reached once
    bool touching_ = false;
    double bridge_m_ = 0.0;           // remaining straight distance past an opening
    double round_m_ = 0.0;            // remaining distance round an outer corner before the wall counts as lost
    FeatureId feature_ = kNoFeature;  // last named
    FeatureId wall_ = kNoFeature;     // the last wall and its direction, to detect corners
    Vec3 wall_normal_{0.0};
};

}  // namespace handrail::core
