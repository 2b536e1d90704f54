// Makes the walker trail a wall: the walker follows the wall at one side, round corners and past openings, as people do
// with the back of a hand. Plain state and one tick that returns the direction. The caller moves the walker and
// announces the events. For the app thread, in world metres.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/core/world/walker.h"

namespace handrail::core {

enum class TrailSide : std::uint8_t { Left, Right };

struct TrailEvent {
    enum class Kind : std::uint8_t {
        Meets,    // the thing at the side or ahead is another one than before
        Corner,   // the wall at the side is another one than before, in another direction
        Opening,  // the wall is interrupted and continues after the gap
        Ends,     // the wall has ended
    } kind = Kind::Meets;
    // For Meets and Corner, this is what is now at the side. For Opening, it is what is in the opening, if anything.
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0};
    double width_m = 0.0;  // width of an opening
};

// How the walker should move now.
struct TrailMotion {
    Vec3 intended_m_per_s{0.0};
    double heading_rad = 0.0;  // direction to face; if it is very different from the present one, the walker only turns
};

class Trail {
public:
    // Searches for a wall within an arm's length on this side, or else for the nearest wall within 4 m. Returns false
    // if there is no wall.
    bool start(const WalkerWorld& world, const Vec3& feet_m, double heading_rad, const WalkerSize& body,
               TrailSide side);
    bool active() const { return active_; }
    void stop() { active_ = false; }
    TrailSide side() const { return side_; }
    // Makes the walker continue along the same wall in the opposite direction, with the other side at the wall.
    void turn_round();
    // Returns how the walker should move, and appends to `events`. Call it while the walker is on the ground and should
    // continue. `facing_rad` is the present direction of the walker.
    TrailMotion tick(const WalkerWorld& world, const Vec3& feet_m, double facing_rad, const WalkerSize& body,
                     double speed_m_per_s, double dt_s, std::vector<TrailEvent>& events);
    // Returns the horizontal normal out of the wall that the walker's side follows, for tests and for learning.
    const Vec3& wall_normal() const { return normal_; }
    bool touching() const { return touching_; }  // returns true if the walker's side is at the wall
    FeatureId feature() const { return feature_; }
    // Returns the direction of movement along the wall. The result is valid while active() is true.
    double heading_rad() const;
    // Return the distance from the walker's side to the wall and the direction of the wall, when the trailing began.
    double wall_m() const { return wall_m_; }
    double wall_bearing_rad() const { return wall_bearing_rad_; }

    static constexpr double kGap_m = 0.03;           // gap between the walker and the wall
    static constexpr double kWidestOpening_m = 2.4;  // the walker enters openings wider than this

private:
    Vec3 along() const;
    void name(const WalkerWorld& world, const Vec3& feet_m, const WalkerSize& body, std::vector<TrailEvent>& events);

    bool active_ = false;
    TrailSide side_ = TrailSide::Left;
    Vec3 normal_{0.0};  // normal out of the wall
    double wall_m_ = 0.0, wall_bearing_rad_ = 0.0;
    bool near_ = false;  // true: the walker has reached the wall once
    bool touching_ = false;
    double bridge_m_ = 0.0;           // remaining distance straight ahead past an opening
    double round_m_ = 0.0;            // remaining distance round an outer corner; after that, the wall has ended
    FeatureId feature_ = kNoFeature;  // the feature that was named last
    // The wall that was followed last; if this wall or its normal changes, there is a corner.
    FeatureId wall_ = kNoFeature;
    Vec3 wall_normal_{0.0};
};

}  // namespace handrail::core
