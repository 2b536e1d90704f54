// Moves the body of the walker: gravity, steps, stairs, slopes and collisions. Plain state and one tick, for the app
// thread. It uses the same solids that the hand feels. The method is that of walking games since the 1990s: trace the
// motion, clip the rest of the motion to the surface, try again one step higher, and choose the better result.
#pragma once

#include <optional>

#include "app/core/world/walker_world.h"
#include "worlds/base/human_measures.h"

namespace handrail::core {

struct WalkerSize {
    double radius_m = 0.25;
    double height_m = 1.8;    // body height; 1.7 in maps of games
    double step_up_m = 0.25;  // height of the highest step that the walker climbs; 0.57 in maps of games
    double eye_height_m = 1.65;
};
// Returns the size of a walker for a building or a game, with the radius that the person has set.
WalkerSize walker_size(const Scene& scene, double radius_m);

struct WalkerMotion {
    Vec3 feet_m{0.0};
    double fall_speed_m_per_s = 0.0;
    bool on_ground = false;
};

// The result of one tick.
struct WalkResult {
    double walked_m = 0.0;          // horizontal distance walked
    std::optional<TraceHit> met;    // the first surface in the way, even if the walker has only brushed it
    std::optional<TraceHit> bump;   // the surface that stopped most of the intended motion
    double climbed_m = 0.0;         // height that the walker has gained by steps up
    bool held_at_edge = false;      // true: the walker does not step over an edge; Walking sets it
    bool landed = false;            // true: the walker touched the ground after a fall of more than one step
    double fell_m = 0.0;            // height of the fall after which the walker landed
    FeatureId ground = kNoFeature;  // feature on which the walker stands
    MaterialId ground_material = kDefaultMaterial;
};

class Walker {
public:
    Walker(const WalkerWorld& world, WalkerSize size) : world_(world), size_(size) {}

    // Places the walker at `feet_m`, or as near above it as there is room (at most half a metre), and lets the walker
    // fall to the ground.
    void place(const Vec3& feet_m);
    // Copies the state of another walker, whether that walker stands or falls.
    void resume(const WalkerMotion& state) {
        state_ = state;
        fall_from_z_ = state.feet_m.z;
    }
    // `intended_m_per_s` is the intended horizontal velocity. `dt_s` is at most 0.1 s.
    WalkResult tick(const Vec3& intended_m_per_s, double dt_s);

    const WalkerMotion& state() const { return state_; }
    const WalkerSize& size() const { return size_; }
    WalkerShape shape() const { return {size_.radius_m, size_.height_m}; }

private:
    struct Slide {
        Vec3 end_m{0.0};
        std::optional<TraceHit> first_wall;
    };
    Slide slide(const Vec3& from_m, Vec3 motion_m) const;
    TraceHit ground_below(const Vec3& feet_m, double depth_m) const;
    bool stands_on_stairs(const Vec3& feet_m) const;

    const WalkerWorld& world_;
    WalkerSize size_;
    WalkerMotion state_;
    double fall_from_z_ = 0.0;
};

}  // namespace handrail::core
