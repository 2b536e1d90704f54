// Walking and turning by keys and sticks. It moves the walker, announces what the walker meets, and records its path.
// ByEar leads it along walls or back; Footing holds it at edges. App thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/walking/by_ear.h"
#include "app/core/walking/footing.h"
#include "app/core/walking/gait.h"
#include "app/core/walking/paces.h"
#include "app/core/walking/steering.h"

namespace handrail::core {

class Walking : SessionPart {
public:
    Walking(const SessionContext& context, WalkerState& body, const HeldKeys& keys, ByEar& by_ear, Footing& footing)
        : SessionPart(context), body_(body), keys_(keys), by_ear_(by_ear), footing_(footing) {}

    // Call it after the walker was placed in the world, at its base.
    void enter_world();
    // Moves the walker elsewhere in this world, as near above the place as there is room; pending movements end.
    void set_down(const Vec3& feet_m, double heading_rad);
    // Handles steps, turns, following, leaps and Home. times: for steps and turns. Returns false if the command belongs
    // to another feature.
    bool act(Command command, double now_s, int times = 1);
    // Call it for commands of other features, which may end following a wall.
    void notice(Command command, double now_s);
    // Turns, tilts and walks for dt_s, at most 0.1 s.
    void tick(double now_s, double dt_s);
    // Plays the tone of the nearest wall ahead, if the person wants it.
    void tell_walls(double now_s);
    // Returns to the base.
    void go_home(double now_s);
    // Moves a walker that is inside a solid to the nearest free place. Returns the distance in words, or that there is
    // no place; empty: the walker is free already.
    std::string bring_out(double now_s);
    // Acts until the next value. Values that are not finite count as rest.
    void steer(const Steering& steering);
    // Drops the remaining steps.
    void halt() {
        pending_ = {};
        gait_.stand();
    }
    // Turns to that heading and announces it.
    void face(double heading_rad, double now_s);
    // Like halt(), after the wall tone has been silenced with everything else.
    void fall_silent();

    // True if nothing is pending: no steps, no turn, no leading.
    bool idle() const;
    double tilt_rad() const { return tilt_rad_; }  // of the eyes; up is positive
    // At floor level, oldest first, a quarter of a metre apart.
    const std::vector<Vec3>& path_m() const { return path_m_; }
    // Free width across the walking direction, at waist height; 0 if a side is open.
    double passage_width_m() const;

    // Set by the session; called before each step. Pushes movable things in front of the walker, and removes from the
    // wish what leads into a body that overlaps the walker. Returns true if a thing moves aside, which is not a bump.
    std::function<bool(Vec3& wish_m_per_s, double now_s)> push_ahead;
    // Called after each step of the walker, with what it did and met.
    std::function<void(const WalkResult& walked, double now_s)> on_walked;
    // Called for each audible bump, that is, if the walker had been free before.
    std::function<void(FeatureId feature, double now_s)> on_bumped;
    // How far to the right a walker that was stopped there must slide to get into a doorway: BlindGround::line_up_m.
    std::function<std::optional<double>(const Vec3& feet_m, double heading_rad)> line_up_m;

private:
    void stand();  // after the walker was placed: nothing is pending, nothing was met
    void step(double& pending_m, double sign, int times);
    void turn_by(double by_rad, int times, double now_s);
    void turn(double now_s, double dt_s);
    void walk(double now_s, double dt_s);
    Vec3 own_wish(double& way_m, double dt_s);
    void take_from_pending(double way_m);
    void end_fall(double now_s);
    void hover(bool wants_to_go, double now_s);
    bool go_on(const WalkResult& walked, const Vec3& wish, double way_m, double now_s);
    void tell_frame(double now_s);
    void tell_slide(const TraceHit& met, double way_m, double now_s);
    void tell_step(const WalkerMotion& before, const WalkResult& walked, double now_s);
    void tell_heading(double now_s);
    void tell_rest(bool goes, double now_s);
    void tell_bump(const TraceHit& met, double way_rad, double now_s);

    WalkerState& body_;
    const HeldKeys& keys_;
    ByEar& by_ear_;
    Footing& footing_;
    Steering steering_;
    // From taps; walked even after the key is released.
    struct Pending {
        double ahead_m = 0.0;  // backwards: negative
        double right_m = 0.0;
    };
    Pending pending_;
    Gait gait_;
    struct Brushed {
        double slid_m = 0.0;          // distance along a surface since its last sound
        std::optional<TraceHit> met;  // last contact of this walk
    };
    Brushed brushed_;
    double since_footstep_m_ = 0.0;
    bool went_ = false;     // in the last tick, on the person's own wish
    bool blocked_ = false;  // a bump was announced and the walker has not moved away since
    // No ground of this world holds the walker, so it stays in place until it is placed elsewhere.
    bool hovers_ = false;
    bool stick_turns_ = false, free_keys_told_ = false;
    double last_turn_repeat_s_ = 0.0;
    std::optional<double> heading_due_s_;  // when to announce the heading; each further turn postpones it
    Paces paces_;
    double walked_s_ = -1e9;  // when the walker last moved
    double tilt_rad_ = 0.0;
    // The tone of walls, and where the body last came to stand.
    struct Tone {
        double loudness = 0.0;
        Vec3 feet_m{0.0};
        double heading_rad = 0.0, since_s = 0.0;
    };
    Tone tone_;
    std::vector<Vec3> path_m_;
};

}  // namespace handrail::core
