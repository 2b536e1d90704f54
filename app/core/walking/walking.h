// Walking and turning by keys and sticks: it moves the body, tells of what the body meets, and keeps the way it went.
// What leads the body along a wall or back is ByEar, what holds it at an edge Footing. App thread only.
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

namespace handrail {

class Walking : SessionPart {
public:
    Walking(const SessionContext& context, BodyState& body, const HeldKeys& keys, ByEar& by_ear, Footing& footing)
        : SessionPart(context), body_(body), keys_(keys), by_ear_(by_ear), footing_(footing) {}

    // After the body was put into the world, at its home.
    void enter_world();
    // Puts the body somewhere else in this world, as near above it as there is room; what it was about to do ends.
    void set_down(const Vec3& feet_m, double heading_rad);
    // Steps, turns, trails, leaps and Home; of steps and turns so many. False: it is another's.
    bool act(Command command, double now_s, int times = 1);
    // Another's command, which may end trailing.
    void notice(Command command, double now_s);
    // Turns, tilts and walks for dt_s, up to 0.1 s.
    void tick(double now_s, double dt_s);
    // The tone of the nearest wall ahead, where the person wants one.
    void tell_walls(double now_s);
    // To where the world was entered.
    void go_home(double now_s);
    // A body that stands in something: to where there is room. Says how far, or that there is none; empty: it stands
    // free.
    std::string bring_out(double now_s);
    // Acts until told otherwise. What is not finite counts as rest.
    void steer(const Steering& steering);
    // Steps that are still to go are not gone.
    void halt() {
        pending_ = {};
        gait_.stand();
    }
    // Turns to that heading and says it.
    void face(double heading_rad, double now_s);
    // The same, and the tone of the walls has been silenced with everything else.
    void fall_silent();

    // Nothing is on its way any more: no steps pending, no turn unfinished, nothing leads.
    bool idle() const;
    double tilt_rad() const { return tilt_rad_; }                // of the eyes, up is positive
    const std::vector<Vec3>& path_m() const { return path_m_; }  // soles, oldest first, a quarter of a metre apart
    // Free space across the way, at the height of the waist; 0 where a side is open.
    double passage_width_m() const;

    // Set by the session.
    // Before each step: what lies before the body and gives way is pushed, and what has come to overlap the body takes
    // from the wish what leads into it. True: what gives way is no bump.
    std::function<bool(Vec3& wish_m_per_s, double now_s)> push_ahead;
    // After each step of the body: what it did and met.
    std::function<void(const WalkResult& walked, double now_s)> on_walked;
    // The body has bumped into something it had got away from before: once for each bump that is heard.
    std::function<void(FeatureId feature, double now_s)> on_bumped;
    // How far to the right somebody must slide who was stopped there, to come into a doorway: BlindGround::line_up_m.
    std::function<std::optional<double>(const Vec3& feet_m, double heading_rad)> line_up_m;

private:
    void stand();  // where it was set down: nothing is on its way, nothing was met
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
    void tell_step(const WalkerState& before, const WalkResult& walked, double now_s);
    void tell_heading(double now_s);
    void tell_rest(bool goes, double now_s);
    void tell_bump(const TraceHit& met, double way_rad, double now_s);

    BodyState& body_;
    const HeldKeys& keys_;
    ByEar& by_ear_;
    Footing& footing_;
    Steering steering_;
    // Of taps; walked even when the key is up again.
    struct Pending {
        double ahead_m = 0.0;  // behind: below 0
        double right_m = 0.0;
    };
    Pending pending_;
    Gait gait_;
    struct Brushed {
        double slid_m = 0.0;          // along something since it was heard last
        std::optional<TraceHit> met;  // on this walk, last
    };
    Brushed brushed_;
    double since_footstep_m_ = 0.0;
    bool went_ = false;     // in the last tick, by oneself
    bool blocked_ = false;  // a bump was told and the body has not got away since
    bool hovers_ = false;   // no ground of this world holds the body: it stays where it is until it is set down
    bool stick_turns_ = false, free_keys_told_ = false;
    double last_turn_repeat_s_ = 0.0;
    std::optional<double> heading_due_s_;  // when the way one faces is told; put off by each further turn
    Paces paces_;
    double walked_s_ = -1e9;  // when the body went last
    double tilt_rad_ = 0.0;
    double tone_loudness_ = 0.0;
    std::vector<Vec3> path_m_;
};

}  // namespace handrail
